"""Layer: errors of the code in units of the last place, at random points and where a search makes them worst."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack.derive.catalogue import catalogue
from radartrack.derive.evaluation.balls import exact_arithmetic
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.verification.domain_points import Points, coarse, sample
from radartrack.verification.error_in_ulp import SINGLE, Exact, errors, in_single
from radartrack.verification.outcome import Function, Outcome

NAME = "ulp"
BOUNDS = {"polar": 8.0}
BOUND_ELSEWHERE = 16.0
GENERATIONS = 5
CORRELATED = 32
ALLOWANCE = 2.0**10  # correlated errors may nearly cancel; the bound is for independent ones
SURVIVORS = 0.02
MOVED = 2.0**-45  # relative, of an argument, to see what its rounding does: next to a pole it must be small
ROUNDING = 2.0**-53  # of an argument, relative


@dataclass(frozen=True)
class Accuracy:
    """The error against arithmetic of many digits.

    Attributes:
        points: how many are tried; half are spread over all scales of the domain, and the rest, in generations, are
            bred from the worst found so far: moved a little, or mixed.
        seed: of the points.
        single: whether the function computes in single precision; it says then where that suffices, by `within_range`.
    """

    points: int = 2000
    seed: int = 0
    single: bool = False
    name: str = NAME

    def __call__(self, quantity: Quantity, function: Function) -> Outcome:
        """The largest error found."""
        arithmetic, exact = exact_arithmetic()
        generator = np.random.Generator(np.random.Philox(self.seed + 3))
        first = self._held(sample(quantity, max(1, self.points // 2), self.seed + 4))
        tried, found = first, self._errors(function, quantity, first, exact)
        worst_at_random = float(np.nanmax(found, initial=0.0))
        litter = (self.points - len(found)) // GENERATIONS
        for _ in range(GENERATIONS if litter and first else 0):
            born = self._held(bred(quantity, tried, np.nan_to_num(found, nan=-1.0, posinf=np.inf), litter, generator))
            tried = {name: np.concatenate([values, born[name]]) for name, values in tried.items()}
            found = np.concatenate([found, self._errors(function, quantity, born, exact)])
        strong_points = self._held(coarse(quantity, CORRELATED, self.seed + 7))
        strong = self._errors(function, quantity, strong_points, exact)
        within = int(np.count_nonzero(~np.isnan(found)))
        if not within:
            return Outcome.not_applicable(
                NAME, "everywhere in the domain something leaves the range of single precision"
            )
        found, strong = np.nan_to_num(found, posinf=np.inf), np.nan_to_num(strong, posinf=np.inf)
        bound = BOUNDS.get(quantity.module, BOUND_ELSEWHERE)
        if quantity.name not in catalogue():
            found = found / _conditions(quantity, tried, found > bound, exact)
            strong = strong / _conditions(quantity, strong_points, strong > bound, exact)
        place = ", ".join(f"{name}={float(values[found.argmax()])!r}" for name, values in tried.items())
        counted = (
            f"{within} of {len(found)} points, where nothing leaves its range"
            if self.single
            else f"{len(found)} points"
        )
        return Outcome.measured(
            NAME,
            max(float(found.max()), float(strong.max()) / ALLOWANCE),
            bound,
            f"{counted}, {worst_at_random:.2g} ulp before the search, {strong.max():.2g} ulp with large "
            f"correlated errors, {arithmetic}; worst at {place}",
        )

    def _held(self, points: Points) -> Points:
        """The points as the precision has them."""
        return in_single(points) if self.single else points

    def _errors(self, function: Function, quantity: Quantity, points: Points, exact: Exact) -> npt.NDArray[np.float64]:
        """In ulp of the precision; NaN where something leaves the range of single precision."""
        found = errors(function, quantity, points, exact)
        if not self.single:
            return found
        within: Any = function
        return np.where(within.within_range(points), found / SINGLE, np.nan)


def _conditions(
    quantity: Quantity, points: Points, wanted: npt.NDArray[np.bool_], exact: Exact
) -> npt.NDArray[np.float64]:
    """How many times its own rounding an error is that comes of rounding the arguments, at wanted points; else 1.

    A model of one's own may have entries that vanish inside of its domain, or waves of many turns: no code computes
    them to a few ulp there, and code that is as good as its arguments is as good as it can be. In either precision the
    rounding of an argument is as many ulp of an entry.
    """
    found = np.ones(wanted.shape)
    some = {name: values[wanted] for name, values in points.items()}
    if not wanted.any():
        return found
    exactly = exact(quantity.expression, quantity.symbols)
    total = np.ones(int(wanted.sum()))
    for name, values in some.items():
        moved = some | {name: values * (1 + MOVED)}

        def elsewhere(moved: Points = moved, **_: object) -> object:
            columns = (moved[symbol.name].tolist() for symbol in quantity.symbols)
            return [_rounded(exactly, row, len(quantity.expression.entries)) for row in zip(*columns, strict=True)]

        change = errors(elsewhere, quantity, some, exact) * (ROUNDING / MOVED)
        total += np.where(np.isfinite(change), change, 0.0)
    found[wanted] = total
    return found


def _rounded(exactly: Callable[[Sequence[float]], Iterable[Any]], row: Sequence[float], size: int) -> list[float]:
    """The exact entries at a point; NaN where there are none, as a little beyond the domain."""
    try:
        return [float(value) for value in exactly(row)]
    except (ArithmeticError, TypeError, ValueError):
        return [math.nan] * size


def bred(
    quantity: Quantity,
    tried: Points,
    found: npt.NDArray[np.float64],
    count: int,
    generator: np.random.Generator,
) -> Points:
    """Points made from the worst: each coordinate from one of two parents, some of them moved."""
    ranked = np.argsort(-found, kind="stable")[: max(2, int(SURVIVORS * len(found)))]
    mothers, fathers = generator.choice(ranked, count), generator.choice(ranked, count)
    born: Points = {}
    for symbol in quantity.symbols:
        values = tried[symbol.name]
        mixed = np.where(generator.random(count) < 0.8, values[mothers], values[fathers])
        moved = np.where(generator.random(count) < 0.6, _moved(symbol, mixed, generator), mixed)
        highest = born[symbol.at_most.name] if symbol.at_most is not None else symbol.high
        kept = np.clip(moved, symbol.low, highest)
        born[symbol.name] = np.floor(kept) if symbol.whole else kept
    return born


def _moved(
    symbol: Variable, values: npt.NDArray[np.float64], generator: np.random.Generator
) -> npt.NDArray[np.float64]:
    """By a step whose size is drawn over all scales; relative to the value, or to the domain where that has zero."""
    if symbol.is_correlation:
        return values
    size = np.exp(generator.uniform(np.log(1e-15), np.log(0.5), values.shape))
    step = size * generator.choice([-1.0, 1.0], values.shape)
    if symbol.low >= 0:
        return np.asarray(values * (1 + step))
    return np.asarray(np.where(generator.random(values.shape) < 0.5, values * (1 + step), values + step * symbol.high))
