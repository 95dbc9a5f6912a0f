"""Replaces the formulas of Markdown pages, fenced as `math` or in line as code hosts write them, by MathML."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Sequence
from pathlib import Path

TYPESET = Path(__file__).with_name("typeset.mjs")
MATH = re.compile(
    r"^(?P<fence>```|~~~)(?!math)[^\n]*\n.*?^(?P=fence)$"  # code, which stays
    r"|^```math\n(?P<block>.*?)\n```$"
    r"|\$`(?P<inline>[^`\n]+)`\$",
    re.MULTILINE | re.DOTALL,
)
SPECIAL = re.compile(r"[*_`\[\]|\\~^]")  # of Markdown


def typeset(pages: Sequence[str]) -> list[str]:
    """The pages with their formulas typeset, all in one run of Node."""
    snippets: dict[tuple[str, bool], int] = {}

    def collect(found: re.Match[str]) -> str:
        latex = found["block"] or found["inline"]
        if latex is None:
            return found[0]
        snippets.setdefault((latex, bool(found["block"])), len(snippets))
        return found[0]

    for page in pages:
        MATH.sub(collect, page)
    request = json.dumps([{"latex": latex, "display": display} for latex, display in snippets])
    finished = subprocess.run(  # noqa: S603 - our own script
        ["node", str(TYPESET)],  # noqa: S607 - the one of this environment
        input=request,
        capture_output=True,
        text=True,
        check=True,
    )
    mathml = [SPECIAL.sub(lambda sign: f"&#{ord(sign[0])};", one) for one in json.loads(finished.stdout)]

    def put(found: re.Match[str]) -> str:
        latex = found["block"] or found["inline"]
        if latex is None:
            return found[0]
        shown = mathml[snippets[latex, bool(found["block"])]]
        return f'\n<div class="formula" data-search-exclude>{shown}</div>\n' if found["block"] else shown

    return [MATH.sub(put, page) for page in pages]
