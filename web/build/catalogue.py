"""Writes what the checker's page says of each quantity before Python is loaded there: `python catalogue.py FILE`."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

from book_sections import sections

from radartrack.derive.catalogue import catalogue

TEMML = Path(__file__).with_name("typeset.mjs")
LONGEST = 600  # characters of LaTeX; longer formulas have a page of their own


def main(target: Path) -> None:
    """All quantities, with those formulas typeset that a list can show."""
    short = {one.name: one.latex for one in sections() if one.latex and len(one.latex) <= LONGEST}
    snippets = [{"latex": latex, "display": True} for latex in short.values()]
    finished = subprocess.run(  # noqa: S603 - our own script
        ["node", str(TEMML)],  # noqa: S607 - the one of this environment
        input=json.dumps(snippets),
        capture_output=True,
        text=True,
        check=True,
    )
    typeset = dict(zip(short, json.loads(finished.stdout), strict=True))
    rows = [
        {
            "name": quantity.name,
            "meaning": quantity.meaning,
            "source": str(quantity.source),
            "unit": quantity.unit_text,
            "conditioning": quantity.conditioning.value,
            "symbols": [(one.name, one.meaning, str(one.unit)) for one in quantity.symbols],
            "shape": quantity.shape,
            "mathml": typeset.get(quantity.name, ""),
        }
        for quantity in catalogue().values()
    ]
    target.write_text(json.dumps(rows, ensure_ascii=False), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
