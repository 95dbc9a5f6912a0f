"""Certificates of proved rounding errors: found, kept in the package, and confirmed by the checker."""

from __future__ import annotations

import ast
import json
import math
from collections.abc import Mapping
from functools import cache
from hashlib import sha256
from importlib import import_module
from importlib.resources import files
from inspect import getsource
from pathlib import Path
from typing import Any

from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.verification.error_in_ulp import peers
from radartrack.verification.rounding.certificate_checker import Refused, cases_of, confirmed
from radartrack.verification.rounding.domain_boxes import Argument
from radartrack.verification.rounding.error_rules import ULPS, NotAnalysed
from radartrack.verification.rounding.proving import NotProved, Theorem, proved
from radartrack.verification.rounding.statements import function_node

RECORD = "certificates.json"
ENOUGH = 10.0  # times what was measured: a bound that need not be made smaller
BOXES = 24  # a case may have
WEIGHTS = "the weights of this, the first and the last scan and the root mean square of all"
Row = dict[str, Any]


def kept() -> dict[str, Row]:
    """What the package holds: by quantity a bound and the boxes that prove it, or why there is none."""
    found: dict[str, Row] = json.loads(files(__package__).joinpath(RECORD).read_text())["functions"]
    return found


def source_of(quantity: Quantity) -> str:
    """The text of the generated module."""
    return _source(quantity.module)


@cache
def _source(module: str) -> str:
    return getsource(import_module(f"radartrack.generated.{module}"))


def code_of(source: str, function: str) -> str:
    """A digest of a function's statements, without its docstring."""
    body = function_node(source, function).body
    statements = [statement for statement in body if not isinstance(statement, ast.Expr)]
    return sha256("\n".join(map(ast.unparse, statements)).encode()).hexdigest()[:16]


def claim_of(quantity: Quantity, trees: Mapping[str, str], *, correlated: bool = False, precision: str = "double") -> Row:
    """What a certificate claims: domain and scale are the quantity's, whatever the certificate says."""
    arguments = [
        {
            "name": symbol.name,
            "low": float(symbol.low),
            "high": float(symbol.high),
            "kind": _kind(symbol),
            "whole": symbol.whole,
            "at_most": symbol.at_most.name if symbol.at_most is not None else None,
        }
        for symbol in quantity.symbols
    ]
    return {
        "function": quantity.function,
        "arguments": arguments,
        "shape": quantity.shape,
        "scale": _scale(quantity),
        "groups": _groups(quantity),
        "correlated": correlated,
        "precision": precision,
        "trees": trees,
    }


def confirmed_bound(quantity: Quantity, row: Row, source: str) -> float:
    """The bound that the boxes prove of the code as it stands.

    Raises:
        Refused: they do not, or they prove less than the certificate says.
    """
    if row["code"] != code_of(source, quantity.function):
        raise Refused("the certificate is of other code")
    found = confirmed(source, claim_of(quantity, row["trees"]))
    if not found <= row["bound"]:
        raise Refused(f"the boxes prove {found:.6g} ulp, the certificate says {row['bound']:g}")
    return found


def certificate(quantity: Quantity, source: str, enough: float, most: int) -> Row:
    """A bound with its boxes, or the reason why there is none.

    Args:
        quantity: whose function is looked at.
        source: the text of its module.
        enough: a bound in ulp that need not be made smaller.
        most: boxes that a case may have.
    """
    code = code_of(source, quantity.function)
    reason = ""
    best: Row = {}
    for boxes in (_one_each, _split):
        try:
            trees = boxes(quantity, source, enough, most)
            bound = _rounded_up(confirmed(source, claim_of(quantity, trees)))
        except (NotAnalysed, NotProved, Refused) as error:
            reason = reason or str(error)
            continue
        if not best or bound < best["bound"]:
            best = {"code": code, "bound": bound, "trees": trees}
        if bound <= enough:
            break
    return best or {"code": code, "reason": reason}


def _one_each(quantity: Quantity, source: str, enough: float, most: int) -> dict[str, str]:
    """The whole domain as one box, with every choice of signs: enough for most functions."""
    del source, enough, most
    return dict.fromkeys(cases_of(claim_of(quantity, {})), ".")


def _split(quantity: Quantity, source: str, enough: float, most: int) -> dict[str, str]:
    return proved(_theorem(quantity, source), most=most, enough=enough).trees


def write(rows: Mapping[str, Row], path: Path) -> None:
    """One line a function."""
    lines = [f"{json.dumps(name)}: {json.dumps(row, ensure_ascii=False)}" for name, row in sorted(rows.items())]
    head = json.dumps({"assumed_ulp": ULPS})[1:-1]
    path.write_text("{" + head + ',\n"functions": {\n' + ",\n".join(lines) + "\n}}\n", encoding="utf-8")


def _theorem(quantity: Quantity, source: str) -> Theorem:
    arguments = [Argument(s.name, float(s.low), float(s.high), _kind(s)) for s in quantity.symbols]
    return Theorem(
        function_node(source, quantity.function), arguments, quantity.shape, _scale(quantity), _groups(quantity)
    )


def _scale(quantity: Quantity) -> str:
    """What errors are measured against, as the checker says it; where a scale is a sum, a part of it will do."""
    if quantity.scale is not None:
        found = {"itself": "norm", WEIGHTS: "ends"}.get(quantity.measured_against)
        if found is None:
            raise NotAnalysed("its errors are measured against a scale of its own")
        return found
    return "terms" if quantity.is_difference else "covariance" if quantity.is_covariance else "norm"


def _groups(quantity: Quantity) -> list[list[int]]:
    """Of every entry those that its error is measured against."""
    if quantity.scale is not None:
        return [[position] for position in range(math.prod(quantity.shape))]
    return peers(quantity) if _scale(quantity) == "norm" else []


def _kind(symbol: Variable) -> str:
    if symbol.is_correlation:
        return "correlation"
    if symbol.is_angle:
        return "angle"
    return "signed" if symbol.low < 0 else "positive"


def _rounded_up(bound: float) -> float:
    """To three digits, and a little more than was found."""
    digits = 10.0 ** (math.floor(math.log10(bound)) - 2) if bound > 1e-3 else 1e-3
    return round(math.ceil(bound * (1 + 1e-9) / digits) * digits, 6)
