"""A constant by which a function takes another value of an argument: too few digits of π, an offset, a unit."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.testing.calling.called_function import Array
from radartrack.testing.diagnosis import Slip
from radartrack.testing.function_conventions import HALF_TURN
from radartrack.testing.wanted import Expected
from radartrack.verification.domain_points import Points
from radartrack.verification.program_compilation import compiled

STEPS = 40  # of Newton's method, which are shortened
LONGEST = 0.5  # of a step, in units of where it starts
TURN = 1e-6  # of an argument, over which a slope is taken
STEADY = 1e-8  # of a constant, by which it may scatter over the points
SAME, CLEARLY = 1e-7, 1e-2  # of the scale of an entry, and of what the function is off by
ROUND = 1e-9  # of a number that is written with few digits
DIGITS = 7
NEAR_DEGREES = 0.02  # of pi/180, to which a factor is taken for it
COST, ROUNDED = 1.5, 0.5  # of any constant, and of one with too few digits, which no edit of a formula is
OFF_BY_ONE = 1.2  # of a whole number
MANY_DIGITS = 3.5  # of a constant with many
NUMBER = re.compile(r"[\d.]+")


def argument_slip(
    screening: Expected, found: Array, confirming: Expected, found_there: Array, in_degrees: frozenset[str]
) -> Slip | None:
    """One symbol of which the function takes a multiple, or more or less, wherever it stands; None without any.

    Args:
        screening: points of ordinary size.
        found: what the function has there, shape (points, entries).
        confirming: points in all directions.
        found_there: likewise.
        in_degrees: symbols that are known to be passed in degrees.
    """
    wanted = screening.wanted
    wrong = _wrong(screening, found)
    entries = [wanted.entries[place] for place in wrong]
    try:
        program = compiled(Tensor((len(entries),), tuple(entries)), wanted.quantity.symbols)
    except ValueError:  # an operation without one of NumPy
        return None

    def values(points: Points) -> Array:
        with np.errstate(all="ignore"):
            return np.asarray(program(**points), dtype=np.float64)

    places = tuple(wanted.places[place] if wanted.shape else () for place in wrong)
    for symbol in wanted.symbols if wrong else ():
        if symbol.whole:
            for one in (1, -1):
                off = _Moved(one)
                if _is_so(screening, found, symbol, off) and _is_so(confirming, found_there, symbol, off):
                    return Slip(
                        places, f"{symbol.name} {'+' if one > 0 else '-'} 1 for {symbol.name}", "", "", OFF_BY_ONE
                    )
        if symbol.whole or symbol.is_correlation:
            continue
        taken = _taken(values, screening.points, found[:, wrong], symbol)
        for moved, words in _constants(symbol, screening.points[symbol.name], taken, in_degrees):
            if _is_so(screening, found, symbol, moved) and _is_so(confirming, found_there, symbol, moved):
                return Slip(places, words, "", "", _cost(words))
    return None


@dataclass(frozen=True)
class _Moved:
    """One more or one less."""

    term: float

    def __call__(self, values: Array) -> Array:
        return values + self.term


def _cost(words: str) -> float:
    """A constant of many digits is rather worked out from something else."""
    if "pi" in words:
        return ROUNDED
    return COST if max(map(len, NUMBER.findall(words)), default=0) <= DIGITS else MANY_DIGITS


def _wrong(expected: Expected, found: Array) -> list[int]:
    with np.errstate(all="ignore"):
        right = (np.abs(found - expected.values) <= ROUND * expected.scales) | ~np.isfinite(found)
    return [int(place) for place in np.flatnonzero(~right.all(axis=0))]


def _taken(values: Callable[[Points], Array], points: Points, found: Array, symbol: Variable) -> Array:
    """At which value of the symbol the first entry is what the function has, near to where the symbol is."""
    start = np.asarray(points[symbol.name], dtype=np.float64)
    taken = start.copy()
    for _ in range(STEPS):
        turn = TURN * np.maximum(np.abs(taken), TURN)
        here, beyond = (values({**points, symbol.name: one})[:, 0] for one in (taken, taken + turn))
        with np.errstate(all="ignore"):
            step = -(here - found[:, 0]) * turn / (beyond - here)
        longest = LONGEST * np.maximum(np.abs(taken), np.abs(start))
        taken = taken + np.clip(np.nan_to_num(step, nan=0.0), -longest, longest)
    return taken


def _constants(
    symbol: Variable, values: Array, taken: Array, in_degrees: frozenset[str]
) -> Iterator[tuple[Callable[[Array], Array], str]]:
    """A factor or a term that is the same at all points, and what that says."""
    with np.errstate(all="ignore"):
        ratios, terms = taken / values, taken - values
    ratio, term = float(np.median(ratios)), float(np.median(terms))
    if ratio > 0 and abs(ratio - 1) > ROUND and np.ptp(ratios) <= STEADY * ratio:
        yield (lambda value: ratio * value), _factor_in_words(symbol, ratio, is_in_degrees=symbol.name in in_degrees)
    if abs(term) > ROUND * np.abs(values).max() and np.ptp(terms) <= STEADY * np.abs(values).max():
        said = few_digits(abs(term)) or f"{abs(term):.9g}"
        yield (lambda value: value + term), f"{symbol.name} {'+' if term > 0 else '-'} {said} for {symbol.name}"


def _factor_in_words(symbol: Variable, ratio: float, *, is_in_degrees: bool) -> str:
    name = symbol.name
    if symbol.is_angle or symbol.unit.radian:
        is_near_one = is_in_degrees or abs(ratio - 1) < NEAR_DEGREES
        degree = ratio / HALF_TURN if is_near_one else ratio
        if abs(degree * HALF_TURN - 1) < NEAR_DEGREES and (said := _as_degree(degree)):
            return said if is_near_one else f"{name} in degrees with {said}"
    if said := few_digits(ratio):
        return f"{said}*{name} for {name}"
    inverse = few_digits(1 / ratio)
    return f"{name}/{inverse} for {name}" if inverse else f"{ratio:.9g}*{name} for {name}"


def _as_degree(degree: float) -> str:
    """Of a factor that is nearly pi/180, how it was written."""
    written = (("pi", degree * 180, math.pi), ("180/pi", 1 / degree, HALF_TURN), ("pi/180", degree, 1 / HALF_TURN))
    said = [(few_digits(value), text, exact) for text, value, exact in written]
    rounded = [(one, text) for one, text, exact in said if one and one == f"{exact:.{_digits(one)}g}"]
    for one, text in (*rounded, *((one, text) for one, text, _ in said if one)):
        return f"{one} for {text}"
    single = [text for text, value, exact in written if math.isclose(value, float(np.float32(exact)), rel_tol=ROUND)]
    return f"{single[0]} in single precision" if single else ""


def _digits(text: str) -> int:
    return len(text.replace(".", "").lstrip("0"))


def few_digits(value: float) -> str:
    """A number as it is written with few digits; empty where it has many."""
    for digits in range(1, DIGITS):
        text = f"{value:.{digits}g}"
        if math.isclose(float(text), value, rel_tol=ROUND):
            return f"{float(text):g}" if "e" in text else text
    return ""


def _is_so(expected: Expected, found: Array, symbol: Variable, moved: Callable[[Array], Array]) -> bool:
    """Whether the function is the quantity at the other values of the symbol, wherever that is defined."""
    there = expected.wanted.at({**expected.points, symbol.name: moved(expected.points[symbol.name])})
    if there.count < expected.count or not np.isfinite(found).any():
        return False
    with np.errstate(all="ignore"):
        away = np.where(np.isfinite(found), np.abs(found - there.values), 0.0)
        off = np.where(np.isfinite(found), np.abs(found - expected.values), 0.0)
        near = away <= SAME * np.maximum(there.scales, expected.scales)
    return bool(near.all() and (away.max(axis=0) <= CLEARLY * off.max(axis=0)).all())
