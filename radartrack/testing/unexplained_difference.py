"""What can be said of a difference that no edit explains: on which symbols it depends, its order, and where it is."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

import numpy as np
import numpy.typing as npt

from radartrack.derive.language.variable import Variable
from radartrack.testing.calling.called_function import Array
from radartrack.testing.diagnosis import place as at_place
from radartrack.testing.function_conventions import deviations_of
from radartrack.testing.wanted import Expected, Wanted
from radartrack.verification.domain_points import Points

Difference = Callable[[Points], Array]  # what the function has, less what is exact, at points; shape (points, entries)
MOVED = 1.3
SHRINKING = (0.5, 0.25, 0.125)
NOISE = 1e-9


def described(wanted: Wanted, places: Sequence[int], difference: Difference, point: dict[str, float]) -> Iterator[str]:
    """For each entry that differs, in words."""
    for place in places:
        index = (wanted.places[place],) if wanted.shape else ()
        here = {name: np.array([value]) for name, value in point.items()}
        if not here or not np.isfinite(difference({name: values * MOVED for name, values in here.items()})[0, place]):
            yield f"{at_place(*index) or 'it '}differs"  # a constant, or a table, of which nothing is known elsewhere
            continue
        depends = [symbol.name for symbol in wanted.symbols if _matters(symbol, place, difference, point)]
        order = _order(deviations_of(wanted.symbols), place, difference, point)
        on = f"the difference depends on {', '.join(depends)}" if depends else "the difference is a constant"
        of = f" and is of order {order} in the deviations" if order is not None else ""
        yield f"{at_place(*index) or 'it '}differs; {on}{of}"


def _matters(symbol: Variable, place: int, difference: Difference, point: dict[str, float]) -> bool:
    """Whether the difference changes with a symbol alone."""
    moved = point[symbol.name] + 1 if symbol.whole else point[symbol.name] * MOVED
    if symbol.is_correlation:
        moved = point[symbol.name] / 2 + 0.1
    both = {name: np.array([value, moved if name == symbol.name else value]) for name, value in point.items()}
    first, second = difference(both)[:, place]
    return bool(abs(first - second) > NOISE * abs(first))  # never of what is not known there


def _order(deviations: Sequence[str], place: int, difference: Difference, point: dict[str, float]) -> int | None:
    """The power of the deviations with which the difference vanishes, where it has one."""
    if not deviations:
        return None
    points = {
        name: np.array([value * (factor if name in deviations else 1.0) for factor in SHRINKING])
        for name, value in point.items()
    }
    values = np.abs(difference(points)[:, place])
    if not np.isfinite(values).all() or not values.all():
        return None
    slope = math.log2(values[1] / values[2])
    return round(slope) if abs(slope - round(slope)) < 0.1 else None


def region(expected: Expected, wrong: npt.NDArray[np.bool_]) -> str:
    """Where a function is wrong that is right elsewhere: "where x < 0", or at how many points."""
    for symbol in expected.wanted.symbols:
        values = expected.points[symbol.name]
        for words, there in (
            (f"{symbol.name} < 0", values < 0),
            (f"{symbol.name} > 0", values > 0),
            (f"{symbol.name} = 0", values == 0),
        ):
            if wrong.any() and (wrong <= there).all() and wrong[there].mean() > 0.5 and not there.all():
                return f"only where {words}"
        if wrong.any() and not wrong.all():
            if values[wrong].max() < values[~wrong].min():
                return f"only where {symbol.name} is {values[wrong].max():.3g} or less"
            if values[wrong].min() > values[~wrong].max():
                return f"only where {symbol.name} is {values[wrong].min():.3g} or more"
            sizes = np.abs(values)
            if sizes[wrong].max() < sizes[~wrong].min():
                return f"only where |{symbol.name}| is {sizes[wrong].max():.3g} or less"
    return f"at {int(wrong.sum())} of {expected.count} points"
