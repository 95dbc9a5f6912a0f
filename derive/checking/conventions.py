"""Under which condition, or in which other convention, a formula that differs is right."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, combinations

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.arrangement import arrangement
from radartrack.derive.checking.trial import Asked, Trial, trial, without_correlation
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import RADIAN
from radartrack.derive.variable import Variable


def conditions_that_help(asked: Asked) -> tuple[str, ...]:
    """`equal when rho = 0`, in another order, or with an angle counted from the other axis, where that is proved."""
    entries = asked.reference.entries
    uncorrelated = without_correlation(asked)
    for one in chain(uncorrelated, _from_other_axes(asked)):
        if one.equals(entries):
            return (f"equal{one.words}",)
    for one in (trial(asked), *uncorrelated):
        if (words := arrangement(one, entries)) is not None:
            return (f"equal {words}{one.words}",)
    return ()


def _from_other_axes(asked: Asked) -> Iterator[Trial]:
    """With any of the printed angles counted from the other axis."""
    angles = [one for one in asked.reference.symbols if _is_angle(one) and one in _used(asked) - set(asked.conditions)]
    names = list(dict.fromkeys(_name(angle) for angle in angles))
    for turned in chain.from_iterable(combinations(names, count + 1) for count in range(len(names))):
        yield from _turned(asked, [angle for angle in angles if _name(angle) in turned])


def _turned(asked: Asked, angles: Sequence[Variable]) -> Iterator[Trial]:
    """With these angles counted from the other axis, in the other sense: a correlation may change its sign then.

    Where the print has no correlation although the derived formula has, there is none.
    """
    correlations = asked.correlations
    if correlations and not _used(asked) & set(correlations):
        yield _trial(asked, angles, zero=correlations)
        return
    yield _trial(asked, angles)
    if correlations:
        yield _trial(asked, angles, negated=correlations)


def _trial(
    asked: Asked, angles: Sequence[Variable], *, negated: Sequence[Variable] = (), zero: Sequence[Variable] = ()
) -> Trial:
    changes: dict[Symbol, Expr] = {angle: sp.pi / 2 - angle for angle in angles} | {one: -one for one in negated}
    replaced = " and ".join([*(f"pi/2 - {one} for {one}" for one in angles), *(f"-{one} for {one}" for one in negated)])
    when = " when " + " and ".join(f"{one} = 0" for one in zero) if zero else ""
    return trial(asked, f" with {replaced}{when}: counted from the other axis", zero=zero, changes=changes)


def _used(asked: Asked) -> set[Symbol]:
    return set[Symbol]().union(*(entry.free_symbols for entry in asked.printed))


def _name(angle: Variable) -> str:
    """A predicted angle is counted as the measured one is."""
    return angle.name.removeprefix("predicted_")


def _is_angle(symbol: Variable) -> bool:
    return symbol.unit == RADIAN and symbol.low < 0
