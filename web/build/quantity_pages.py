"""A page for each quantity: formula, code, accuracy, source, and where a formula is checked against it."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable
from functools import cache
from itertools import groupby
from pathlib import Path
from urllib.parse import quote

from book_sections import Section

GENERATED = Path(__file__).parents[2] / "generated"
MOST_LINES = 250  # of code on a page
_RELATED = re.compile(r"\[(?P<name>[\w.]+)\]\(#\w+\)")
_TOO_LONG = re.compile(r"^Too long to print here: .*$", re.MULTILINE)
_USED = re.compile(r"^- symbols: (?P<names>.*?); ", re.MULTILINE)


def chapters(found: Iterable[Section]) -> list[tuple[str, list[tuple[str, str]]]]:
    """The modules, each with its quantities and what they are."""
    return [
        (module, [(one.name, _meaning(one)) for one in group])
        for module, group in groupby(found, key=lambda one: one.name.partition(".")[0])
    ]


def quantity_page(section: Section, long_formula: str = "") -> str:
    """All that is known of a quantity, in Markdown.

    Args:
        section: what the book says of it.
        long_formula: what stands for a formula that is too long for the book.
    """
    text = _RELATED.sub(lambda found: f"[{found['name']}]({found['name']}.md)", section.text)
    if not section.latex:
        told, rest = _TOO_LONG.split(text, maxsplit=1)
        text = "\n".join([told, f"{long_formula}\n", f"Whole: `radartrack show {section.name}`.", rest])
    used = _USED.search(section.text)
    symbols = re.findall(r"`(\w+)`", used["names"]) if used else []
    rows = [section.symbols[name] for name in symbols if name in section.symbols]
    table = ["| symbol | | meaning | unit |", "|---|---|---|---|", *rows] if rows else []
    check = f'<a class="md-button" href="../../check/#quantity={quote(section.name)}">Check a formula against this</a>'
    parts = [f"# {section.name}\n", text, "", *table, "", check, "", _code(section.name), _commands(section.name)]
    return "\n".join(parts)


def _meaning(section: Section) -> str:
    return section.text.partition("\n")[0].removesuffix(".")


def _commands(name: str) -> str:
    return f"""
## On the command line

    radartrack show {name} --format latex
    radartrack check {name} 'FORMULA'
    radartrack verify {name}
"""


def _code(name: str) -> str:
    """The generated function."""
    module, _, rest = name.partition(".")
    function = rest.replace(".", "_")
    source = _functions(module).get(function)
    if source is None:
        return ""
    call = f"## In Python\n\n`radartrack.generated.{module}.{function}`"
    lines = source.count("\n") + 1
    if lines > MOST_LINES:
        return f"{call}, {lines} lines.\n"
    body = "\n".join(f"    {line}" for line in ["```python", *source.split("\n"), "```"])
    return f'{call}\n\n??? abstract "Its code"\n\n{body}\n'


@cache
def _functions(module: str) -> dict[str, str]:
    path = GENERATED / f"{module}.py"
    if not path.exists():
        return {}
    source = path.read_text(encoding="utf-8")
    lines = source.split("\n")
    nodes = (node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef))
    return {node.name: "\n".join(lines[node.lineno - 1 : node.end_lineno]) for node in nodes}
