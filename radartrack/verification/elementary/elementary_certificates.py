"""Certificates of the elementary functions: found by halving, kept in the package, confirmed by the checker.

`python -m radartrack.verification.elementary.elementary_certificates FILE` finds them anew.
"""

from __future__ import annotations

import ast
import json
import math
import sys
from collections.abc import Mapping
from hashlib import sha256
from importlib.resources import files
from inspect import getsource
from pathlib import Path
from typing import Any

from radartrack.generated import elementary
from radartrack.verification.elementary.ball_arithmetic import Refused
from radartrack.verification.elementary.elementary_checker import FUNCTIONS, bound, cases, confirmed, read
from radartrack.verification.elementary.elementary_text import Text

RECORD = "elementary_certificates.json"
PRECISIONS = {"double": 53, "single": 24}
ENOUGH = 0.93  # ulp: much of what is left is the last rounding
DEEPEST = 40  # halvings of an interval
Row = dict[str, Any]


def kept() -> dict[str, dict[str, Row]]:
    """What the package holds: by precision and function a bound in ulp, and the cells that prove it."""
    found: dict[str, dict[str, Row]] = json.loads(files(__package__).joinpath(RECORD).read_text("utf-8"))["functions"]
    return found


def source() -> str:
    """The text of the generated module."""
    return getsource(elementary)


def code_of(text: Text) -> str:
    """A digest of what a certificate speaks of."""
    lines = [f"{name} = {ast.unparse(value)}" for name, value in text.statements]
    return sha256("\n".join([*lines, *map(ast.unparse, text.results)]).encode()).hexdigest()[:16]


def confirmed_bound(precision: str, name: str, row: Mapping[str, Any], module: str) -> float:
    """The bound that the cells prove of the code as it stands.

    Raises:
        Refused: they do not, or they prove less than the certificate says.
    """
    bits = PRECISIONS[precision]
    if row["code"] != code_of(read(module, name, bits)):
        raise Refused("the certificate is of other code")
    found = confirmed(module, name, bits, row["trees"])
    if not found <= row["bound"]:
        raise Refused(f"the cells prove {found:.6g} ulp, the certificate says {row['bound']:g}")
    return found


def certificate(precision: str, name: str, module: str) -> Row:
    """A bound with its cells.

    Raises:
        Refused: where none is found.
    """
    text = read(module, name, PRECISIONS[precision])
    trees = {case: _halved(text, case, low, high, DEEPEST) for case, (low, high) in cases(text).items()}
    proved = confirmed(module, name, PRECISIONS[precision], trees)
    return {"code": code_of(text), "bound": math.ceil(1000 * proved) / 1000, "trees": trees}


def _halved(text: Text, case: str, low: float, high: float, deepest: int) -> str:
    try:
        found, reason = bound(text, case, low, high), ""
    except Refused as error:  # a result that may vanish in so wide a cell, or one that is above one ulp
        found, reason = math.inf, str(error)
    if found <= ENOUGH:
        return "."
    if not deepest:
        raise Refused(f"{text.name}: {found:.6g} ulp from {low} to {high} {reason}")
    middle = (low + high) / 2
    return f"|{_halved(text, case, low, middle, deepest - 1)}{_halved(text, case, middle, high, deepest - 1)}"


def write(path: Path) -> None:
    """All certificates, a line each."""
    rows = {precision: {name: certificate(precision, name, source()) for name in FUNCTIONS} for precision in PRECISIONS}
    groups = []
    for precision, found in rows.items():
        lines = ",\n".join(f"{json.dumps(name)}: {json.dumps(row)}" for name, row in found.items())
        groups.append(f"{json.dumps(precision)}: {{\n{lines}\n}}")
    path.write_text('{"functions": {\n' + ",\n".join(groups) + "\n}}\n", encoding="utf-8")


if __name__ == "__main__":
    write(Path(sys.argv[1]))
