"""Where a formula that differs becomes right: in the limit of slow manoeuvres, of many scans and the like."""

from __future__ import annotations

from collections.abc import Iterator

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.checking.conventions.altered_question import Asked
from radartrack.derive.checking.question.conditions import under
from radartrack.derive.evaluation.many_digits import Evaluator, NotComputed
from radartrack.derive.evaluation.points import Point, generic_points
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.verbs.limit import limit
from radartrack.derive.verbs.no_closed_form import NoClosedForm

LETTERS = 4  # of a coordinate: vx, rdot; parameters have words for names
LONGEST = 4000  # characters of all entries: a limit of a longer formula is not worked out in a second
NEAR, NEARER = 1e4, 1e6  # how far towards the limit
CLOSE = 1e-2  # relative difference that is left there
SHRINKS = 0.1  # to less than this part of it from the one to the other

Pair = tuple[Expr, Expr]


def limiting_case(asked: Asked, *, lacking: bool) -> str:
    """The limit in which all that is printed is what was derived, in words; nothing where there is none.

    What is said of small deviations is the order of the difference, which is told anyway.

    Args:
        asked: what is printed, and what it was compared with.
        lacking: whether of symbols that the print lacks, or of others.
    """
    both = zip(asked.printed, asked.reference.entries, strict=True)
    pairs = [(under(asked.conditions, ours), under(asked.conditions, theirs)) for ours, theirs in both]
    pairs = [(ours, theirs) for ours, theirs in pairs if ours != theirs]
    if len(str(pairs)) > LONGEST:
        return ""
    symbols = asked.reference.symbols
    found = (
        f" where {one} goes to {_spoken(end)}"
        for one, end in _ends(asked, lacking=lacking)
        if _is_right(pairs, symbols, one, end)
    )
    return next(found, "")


def _ends(asked: Asked, *, lacking: bool) -> Iterator[tuple[Variable, Expr]]:
    """The ends of what a print may neglect: rates, counts and parameters; of what is measured nothing is."""
    used = set[Symbol]().union(*(entry.free_symbols for entry in asked.reference.entries)) - asked.conditions.keys()
    for symbol in asked.reference.symbols:
        is_rate = symbol.unit.second < 0 and not symbol.unit.metre
        is_parameter = is_rate or symbol.whole or len(symbol.name) > LETTERS
        if symbol not in used or not is_parameter or "sigma" in symbol.name or asked.uses([symbol]) is lacking:
            continue
        if not symbol.whole:
            yield symbol, sp.Integer(0)
        if not lacking or symbol.whole:
            yield symbol, sp.oo


def _is_right(pairs: list[Pair], symbols: tuple[Variable, ...], symbol: Variable, end: Expr) -> bool:
    return _seems_right(pairs, symbols, symbol, end) and all(_proves(pair, symbol, end) for pair in pairs)


def _seems_right(pairs: list[Pair], symbols: tuple[Variable, ...], symbol: Variable, end: Expr) -> bool:
    """Whether the differences shrink towards the end."""
    (point,) = generic_points(symbols, 1)
    evaluated = Evaluator(Tensor((2 * len(pairs),), tuple(side for pair in pairs for side in pair)), symbols)
    left = [_differences(evaluated, point, symbol, far if end == sp.oo else 1 / far) for far in (NEAR, NEARER)]
    return all(
        near is not None and nearer is not None and nearer <= CLOSE and nearer <= SHRINKS * near
        for near, nearer in zip(*left, strict=True)
    )


def _differences(evaluated: Evaluator, point: Point, symbol: Variable, factor: float) -> list[float | None]:
    """The relative differences of the pairs with a symbol so many times as large; absolute ones beside zero."""
    try:
        values = evaluated(point | {symbol.name: point[symbol.name] * factor}).entries
    except (ArithmeticError, NotComputed):
        return []
    pairs = zip(values[::2], values[1::2], strict=True)
    return [float(abs(ours - theirs) / (abs(ours) or 1)) for ours, theirs in pairs]


def _proves(pair: Pair, symbol: Variable, end: Expr) -> bool:
    """Whether the limit of what was derived is what is printed, or that of their quotient is one."""
    ours, theirs = pair
    try:
        if symbol not in ours.free_symbols:
            return proved_equal(ours, limit(theirs, symbol, end))
        return proved_equal(limit(theirs / ours, symbol, end), sp.Integer(1))
    except NoClosedForm:
        return False


def _spoken(end: Expr) -> str:
    return "infinity" if end == sp.oo else "0"
