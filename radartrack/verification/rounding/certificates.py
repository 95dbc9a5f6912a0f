"""Certificates of proved rounding errors: found, kept in the package, and confirmed by the checker."""

from __future__ import annotations

import ast
import json
import math
from collections.abc import Mapping
from contextlib import suppress
from functools import cache
from hashlib import sha256
from importlib import import_module
from importlib.resources import files
from inspect import getsource
from textwrap import indent
from typing import Any

from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import indices
from radartrack.derive.language.variable import Variable
from radartrack.derive.stable.quantity_form import scaled
from radartrack.derive.writing.numpy_writer import body
from radartrack.verification.error_in_ulp import peers
from radartrack.verification.rounding.bisection import bisected
from radartrack.verification.rounding.checker.certificate_checker import WAYS, confirmed
from radartrack.verification.rounding.checker.domain_cases import cases_of
from radartrack.verification.rounding.checker.given_arguments import PRECISIONS
from radartrack.verification.rounding.checker.known_numbers import Refused
from radartrack.verification.rounding.checker.written_helpers import KNOWN
from radartrack.verification.rounding.domain_boxes import Argument
from radartrack.verification.rounding.error_rules import NotAnalysed
from radartrack.verification.rounding.proving import NotProved, Theorem, proved
from radartrack.verification.rounding.scales import ITSELF, WEIGHTS
from radartrack.verification.rounding.statements import function_node

RECORD = "certificates.json"
ENOUGH = 10.0  # times what was measured: a bound that need not be made smaller
BOXES = 24  # a case may have
SECONDS = 20.0  # of processor time for a function
CONDITION = 10.0  # times as much is enough where variances are differences
KINDS: dict[str, dict[str, Any]] = {
    "double": {"correlated": False, "precision": "double"},
    "correlated": {"correlated": True, "precision": "double"},
    "single": {"correlated": False, "precision": "single"},
}
WORTH = {"double": 1e4, "correlated": 1e5, "single": 1e3}  # ulp; a larger bound says nothing that is of use
Row = dict[str, Any]


def kept() -> dict[str, Row]:
    """What the package holds: by quantity a bound and the boxes that prove it, or why there is none."""
    found: dict[str, Row] = json.loads(files(__package__).joinpath(RECORD).read_text("utf-8"))["functions"]
    return found


def proved_bounds(row: Row) -> dict[str, float]:
    """By kind the bounds in ulp that certificates claim of a function."""
    return {kind: row[kind]["bound"] for kind in KINDS if "bound" in row.get(kind, {})}


def source_of(quantity: Quantity) -> str:
    """The text of the generated module."""
    return _source(quantity.module)


@cache
def _source(module: str) -> str:
    return getsource(import_module(f"radartrack.generated.{module}"))


def code_of(source: str, function: str) -> str:
    """A digest of a function's statements, and of the helpers that it calls, without docstrings."""
    statements = _statements(source, function)
    called = [helper for helper in KNOWN if any(f"{helper}(" in statement for statement in statements)]
    statements += [statement for helper in called for statement in _statements(source, helper)]
    return sha256("\n".join(statements).encode()).hexdigest()[:16]


def _statements(source: str, function: str) -> list[str]:
    body = function_node(source, function).body
    return [ast.unparse(statement) for statement in body if not isinstance(statement, ast.Expr)]


def claim_of(
    quantity: Quantity, trees: Mapping[str, str], *, correlated: bool = False, precision: str = "double"
) -> Row:
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
        "sides": quantity.scaled_by is not None,  # a map that a cosine divides
        "precision": precision,
        "trees": trees,
    } | (_stated(quantity) if _scale(quantity) == "stated" else {})


def confirmed_bound(quantity: Quantity, row: Row, source: str, kind: str = "double") -> float:
    """The bound that the boxes prove of the code as it stands.

    Args:
        quantity: whose function it is.
        row: its certificates.
        source: the text of its module.
        kind: which of them, a name of `KINDS`.

    Raises:
        Refused: they do not, or they prove less than the certificate says.
    """
    if row["code"] != code_of(source, quantity.function):
        raise Refused("the certificate is of other code")
    claim = claim_of(quantity, {}, **KINDS[kind])
    ways = {"ways": row[kind]["ways"]} if "ways" in row[kind] else {}
    found = confirmed(source, {**claim, **ways, "trees": _of_all_cases(claim, row[kind]["trees"])})
    if not found <= row[kind]["bound"]:
        raise Refused(f"the boxes prove {found:.6g} ulp, the certificate says {row[kind]['bound']:g}")
    return found


def _of_all_cases(claim: Row, trees: str | dict[str, str]) -> dict[str, str]:
    """Where all cases have one tree, a certificate has it once."""
    return dict.fromkeys(cases_of(claim), trees) if isinstance(trees, str) else trees


def certificate(quantity: Quantity, source: str, enough: float, most: int, seconds: float) -> Row:
    """Bounds with their boxes, or the reasons why there are none: of each of `KINDS` that a quantity has.

    Args:
        quantity: whose function is looked at.
        source: the text of its module.
        enough: a bound in ulp that need not be made smaller.
        most: boxes that a case may have.
        seconds: of processor time for each kind, beyond which boxes are halved for a bound at all only.
    """
    found: Row = {"code": code_of(source, quantity.function)}
    for kind, said in KINDS.items():
        if kind == "correlated" and not any(symbol.is_correlation for symbol in quantity.symbols):
            continue
        wanted = enough * CONDITION if kind == "correlated" else enough
        found[kind] = _best(quantity, source, said, wanted, most, seconds)
        if found[kind].get("bound", 0.0) > WORTH[kind]:
            found[kind] = {"reason": f"no bound below {WORTH[kind]:g} ulp"}
    return found


def _best(quantity: Quantity, source: str, kind: Row, enough: float, most: int, seconds: float) -> Row:
    """The first bound that is good enough, else the smallest, else why there is none."""
    reason, best = "", Row()
    for boxes in (_one_each, _split, _bisected_in_one_way, bisected):
        try:
            claim = claim_of(quantity, {}, **kind)
            trees = boxes(source, claim, enough, most, seconds)
            bound = _rounded_up(confirmed(source, {**claim, "trees": trees}))
        except (NotAnalysed, NotProved, Refused) as error:
            reason = reason or str(error)
            continue
        if not best or bound < best["bound"]:
            shapes = set(trees.values())
            best = {"bound": bound, "trees": shapes.pop() if len(shapes) == 1 else trees}
            best |= _one_way(source, {**claim, "trees": trees}, bound)
        if bound <= enough:
            break
    return best or {"reason": reason}


def _one_way(source: str, claim: Row, bound: float) -> Row:
    """The way of telling errors that gives the bound alone, if one does: the checker need not try the others."""
    for number in range(len(WAYS)):
        with suppress(Refused):
            if confirmed(source, {**claim, "ways": [number]}) <= bound:
                return {"ways": [number]}
    return {}


def _one_each(source: str, claim: Row, enough: float, most: int, seconds: float) -> dict[str, str]:
    """The whole domain as one box, with every choice of signs: enough for most functions."""
    del source, enough, most, seconds
    return dict.fromkeys(cases_of(claim), ".")


def _split(source: str, claim: Row, enough: float, most: int, seconds: float) -> dict[str, str]:
    """Boxes that plain floating point finds good enough."""
    del seconds
    if claim["precision"] != "double" or any(argument["whole"] for argument in claim["arguments"]):
        raise NotAnalysed("the search by enclosures is of doubles, and of numbers that need not be whole")
    arguments = [Argument(a["name"], a["low"], a["high"], a["kind"]) for a in claim["arguments"]]
    function = function_node(source, claim["function"])
    theorem = Theorem(function, arguments, claim["shape"], claim["scale"], claim["groups"])
    return proved(theorem, correlated=claim["correlated"], most=most, enough=enough).trees


def _bisected_in_one_way(source: str, claim: Row, enough: float, most: int, seconds: float) -> dict[str, str]:
    """Boxes that the last way of telling errors finds good enough: a sixth of the time for each."""
    return bisected(source, {**claim, "ways": [len(WAYS) - 1]}, enough, most, seconds)


def written(rows: Mapping[str, Row]) -> str:
    """All of them, one line a function."""
    lines = [f"{json.dumps(name)}: {json.dumps(row, ensure_ascii=False)}" for name, row in sorted(rows.items())]
    assumed = {name: precision.ulps for name, precision in PRECISIONS.items()}
    head = json.dumps({"assumed_ulp": assumed})[1:-1]
    return "{" + head + ',\n"functions": {\n' + ",\n".join(lines) + "\n}}\n"


def _scale(quantity: Quantity) -> str:
    """What errors are measured against, as the checker says it; where a scale is a sum, a part of it will do."""
    if quantity.scale is not None:
        return {ITSELF: "norm", WEIGHTS: "ends"}.get(quantity.measured_against, "stated")
    return "terms" if quantity.is_difference else "covariance" if quantity.is_covariance else "norm"


@cache
def _stated(quantity: Quantity) -> Row:
    """A scale that is a formula of its own, as a function of the arguments; sizes are of what can be either sign."""
    scale = quantity.scale() if quantity.scale else quantity.expression
    form = StableForm({}, scale)
    if quantity.scaled_by is not None:
        form = scaled(form, quantity, quantity.scaled_by)
    statements = body(quantity, form)
    paired = quantity.is_covariance and all(
        scale[m, n] ** 2 == scale[m, m] * scale[n, n] for m, n in indices(quantity.shape)
    )
    return {"stated": "def stated():\n" + indent(statements, "    ") + "\n", "paired": paired}


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
