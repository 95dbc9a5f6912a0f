"""Whether what a diagnosis tells of a function is what was done to its formula: read again, in many digits."""

import re
from collections.abc import Iterator

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.formula.to_expression import to_expression
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.reading.text import read_text
from radartrack.derive.symbolic import Expr
from radartrack.testing import Diagnosis
from radartrack.testing.diagnosis import Slip
from radartrack.verification.domain_points import coarse

POINTS = 5
SAME = 1e-25
ORDER = re.compile(r"the (?:entries|columns) in the order (?P<order>[\d, ]+)")
COMPLEMENT = re.compile(r"(?P<symbol>\w+) counted from .+ \(pi/2 - \w+\)")
OPPOSITE = re.compile(r"the opposite sign of (?P<symbol>\w+)")
VARIANCES = re.compile(r"variances in place of (?P<symbol>\w+)")
FOR_A_SYMBOL = re.compile(r"(?P<taken>.+) for (?P<symbol>\w+)")


def is_told(found: Diagnosis, quantity: Quantity, mutant: Tensor[Expr]) -> bool:
    """Whether the derived formula with what is told, and nothing else, is the mutant all over the domain.

    Two entries exchanged are an order, and a sign before an angle's sine may be one of the angle.
    """
    if found.verdict == "convention":
        return any(is_same(other, mutant, quantity) for other in _in_convention(found.convention, quantity))
    if found.verdict != "slip" or found.convention:
        return False
    told = dict(quantity.expression.items())
    for slip in found.slips:
        told |= _edited(slip, quantity)
    return is_same(Tensor(quantity.shape, tuple(told.values())), mutant, quantity)


def _in_convention(words: str, quantity: Quantity) -> Iterator[Tensor[Expr]]:
    """The derived formula in a convention."""
    entries, shape = quantity.expression.entries, quantity.shape
    symbols = {symbol.name: symbol for symbol in quantity.symbols}
    if words == "the result transposed":
        table = dict(quantity.expression.items())
        yield Tensor(shape, tuple(table[index[::-1]] for index in table))
    elif words == "the opposite sign":
        yield Tensor(shape, tuple(-entry for entry in entries))
    elif match := ORDER.fullmatch(words):
        order = [int(place) for place in match["order"].split(", ")]
        for way in (order, [order.index(place) for place in range(len(order))]):
            rows = range(0, len(entries), len(order))
            yield Tensor(shape, tuple(entries[row + place] for row in rows for place in way))
    elif words in {"the reciprocal of the result", "rdot positive for what comes closer (-rdot)"}:
        rdot = symbols.get("rdot")
        yield Tensor(shape, tuple(1 / entry if rdot is None else entry.xreplace({rdot: -rdot}) for entry in entries))
    elif match := COMPLEMENT.fullmatch(words) or OPPOSITE.fullmatch(words) or VARIANCES.fullmatch(words):
        symbol = symbols[match["symbol"]]
        other = sp.pi / 2 - symbol if "counted" in words else -symbol if "opposite" in words else sp.sqrt(symbol)
        yield Tensor(shape, tuple(entry.xreplace({symbol: other}) for entry in entries))


def _edited(slip: Slip, quantity: Quantity) -> dict[Index, Expr]:
    """The entries that a slip is told in, as they are told to be."""
    derived = dict(quantity.expression.items())
    symbols = {symbol.name: symbol for symbol in quantity.symbols}
    if slip.formula:
        formula = to_expression(read_text(slip.formula, symbols), symbols)
        assert isinstance(formula, Expr)
        return dict.fromkeys(slip.entries or ((),), formula)
    if slip.edit == "exchanged":
        first, second = slip.entries
        return {first: derived[second], second: derived[first]}
    match = FOR_A_SYMBOL.fullmatch(slip.edit)
    if match is None or match["symbol"] not in symbols:
        return {}
    taken = to_expression(read_text(match["taken"], symbols), symbols)
    return {index: derived[index].xreplace({symbols[match["symbol"]]: taken}) for index in slip.entries or ((),)}


def is_same(first: Tensor[Expr], second: Tensor[Expr], quantity: Quantity) -> bool:
    """Whether two formulas have the same values."""
    points = coarse(quantity, POINTS, seed=77)
    one, other = (Evaluator(entries, quantity.symbols) for entries in (first, second))
    rows = [[float(values[n]) for values in points.values()] for n in range(POINTS)]
    return all(mpmath.almosteq(a, b, SAME) for row in rows for a, b in zip(one(row), other(row), strict=True))
