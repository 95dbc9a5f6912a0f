"""Under which condition, or in which other convention, a formula that differs is right."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, combinations

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.conventions.altered_question import Asked, Trial, trial, without_correlation
from radartrack.derive.checking.conventions.entry_order import arrangement
from radartrack.derive.checking.question.conditions import when_zero
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol


def condition_that_helps(asked: Asked) -> str | None:
    """`equal when rho = 0`, where that is proved."""
    return next((f"equal{one.words}" for one in without_correlation(asked) if _is_equal(one, asked)), None)


def convention_that_helps(asked: Asked) -> str | None:
    """Equal with an angle counted from the other axis, or with the entries in another order, where that is proved."""
    turned = next((f"equal{one.words}" for one in _from_other_axes(asked) if _is_equal(one, asked)), None)
    return turned or next(_other_orders(asked), None)


def _is_equal(one: Trial, asked: Asked) -> bool:
    return one.equals(asked.reference.entries)


def _other_orders(asked: Asked) -> Iterator[str]:
    for one in (trial(asked), *without_correlation(asked)):
        if (words := arrangement(one, asked.reference.entries)) is not None:
            yield f"equal {words}{one.words}"


def _from_other_axes(asked: Asked) -> Iterator[Trial]:
    """With any of the printed angles counted from the other axis."""
    angles = [one for one in asked.reference.symbols if one.is_angle and one in _used(asked) - set(asked.conditions)]
    names = list(dict.fromkeys(_name(angle) for angle in angles))
    for turned in chain.from_iterable(combinations(names, count + 1) for count in range(len(names))):
        yield from _turned(asked, [angle for angle in angles if _name(angle) in turned])


def _turned(asked: Asked, angles: Sequence[Variable]) -> Iterator[Trial]:
    """With these angles counted from the other axis, in the other sense: a correlation may change its sign then.

    Where the print has no correlation although the derived formula has, there is none.
    """
    correlations = asked.correlations
    if correlations and not _used(asked) & set(correlations):
        yield _trial(asked, angles, vanishing=correlations)
        return
    yield _trial(asked, angles)
    if correlations:
        yield _trial(asked, angles, negated=correlations)


def _trial(
    asked: Asked, angles: Sequence[Variable], *, negated: Sequence[Variable] = (), vanishing: Sequence[Variable] = ()
) -> Trial:
    changes: dict[Symbol, Expr] = {angle: sp.pi / 2 - angle for angle in angles}
    changes.update({one: -one for one in negated})
    replaced = " and ".join([*(f"pi/2 - {one} for {one}" for one in angles), *(f"-{one} for {one}" for one in negated)])
    words = f" with {replaced}{when_zero(vanishing)}: counted from the other axis"
    return trial(asked, words, vanishing=vanishing, changes=changes)


def _used(asked: Asked) -> set[Symbol]:
    return set[Symbol]().union(*(entry.free_symbols for entry in asked.printed))


def _name(angle: Variable) -> str:
    """A predicted angle is counted as the measured one is."""
    return angle.name.removeprefix("predicted_")
