"""What a function has at points, beside the exact values: angles by whole turns, the worst, what is no number."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from radartrack.testing.calling.called_function import Array, Calls
from radartrack.testing.diagnosis import Worst
from radartrack.testing.function_conventions import deviations_of, is_direction
from radartrack.testing.reading import Reading
from radartrack.testing.unexplained_difference import region
from radartrack.testing.wanted import Expected, Wanted

EXCUSED = 8.0  # units of its errors beyond which it is asked whether the convention makes them
INDEFINITE = -1e-3  # an eigenvalue of a correlation matrix that rounding of one that is right does not reach
TURNED = 2.0**-50  # radians that an angle loses when it is turned
SINGLE = np.finfo(np.float32)
SHOWN = 4


def unwrapped(found: Array, expected: Expected, offsets: Array | None = None) -> Array:
    """Angles that come back, moved by whole turns to the exact ones; a turned one is as exact as the turn, no more."""
    found = found.copy()
    for column, place in enumerate(expected.wanted.places):
        if is_direction(expected.wanted, place):
            exact = expected.values[:, column]
            with np.errstate(all="ignore"):
                turns = np.nan_to_num(np.round((found[:, column] - exact) / (2 * np.pi)), posinf=0.0, neginf=0.0)
            moved = found[:, column] - 2 * np.pi * turns
            turned = (turns != 0) | (offsets is not None and offsets[column] != 0)
            same = turned & (np.abs(moved - exact) <= TURNED)
            found[:, column] = np.where(same, exact, np.where(turns, moved, found[:, column]))
    return found


def beyond_single(found: Array, exact: Array) -> npt.NDArray[np.bool_]:
    """Where single precision cannot hold the exact value, and the function has what is left: infinity, or zero."""
    with np.errstate(all="ignore"):
        overflown = np.isinf(found) & (np.abs(exact) > float(SINGLE.max)) & (found * exact > 0)
        vanished = (np.abs(exact) < float(SINGLE.tiny)) & (np.abs(found - exact) <= float(SINGLE.smallest_subnormal))
    return np.asarray(overflown | (vanished & (exact != 0)))


def excused(
    reading: Reading, expected: Expected, found: Array, unit: float, *, arguments_in_single: bool = False
) -> Array:
    """What a function has, without what rounding of arguments in its convention makes: it cannot know better.

    Args:
        reading: the convention.
        expected: the exact values.
        found: what the function has.
        unit: in which its errors are told, in ulp of double precision.
        arguments_in_single: whether all arguments may be rounded to single precision.
    """
    changed = reading.binding.changes
    symbols = [one for one in reading.wanted.symbols if arguments_in_single or one.name in changed]
    found = found.copy()
    finite = np.where(np.isfinite(found), found, 0.0)
    for place in np.flatnonzero((expected.errors(finite) > EXCUSED * unit).any(axis=1)) if symbols else ():
        exact, point, slack = expected.values[place], expected.point(int(place)), np.zeros(found.shape[1])
        for symbol in symbols:
            step = TURNED * max(abs(point[symbol.name]), symbol.is_angle) if symbol.name in changed else 0.0
            step += float(SINGLE.eps) * abs(point[symbol.name]) * arguments_in_single
            moved = reading.wanted.at(
                {name: np.array([value]) for name, value in point.items()}
                | {symbol.name: np.array([point[symbol.name] + step])}
            )
            slack += np.abs(moved.values[0] - exact) if moved.count else 0.0
        difference = found[place] - exact
        found[place] = exact + np.sign(difference) * np.maximum(np.abs(difference) - slack, 0.0)
    return found


def worst_point(expected: Expected, found: Array, errors: Array) -> Worst:
    """Where the error is largest."""
    place, entry = np.unravel_index(int(errors.argmax()), errors.shape)
    index = expected.wanted.places[int(entry)] if expected.wanted.shape else ()
    return Worst(
        index,
        expected.point(int(place)),
        float(found[place, entry]),
        float(expected.values[place, entry]),
    )


def where_undefined(calls: Calls, found: Array, expected: Expected) -> Iterator[str]:
    """Where there is no real number, one line for each kind."""
    kinds: dict[str, list[int]] = {}
    for place, words in calls.raised.items():
        kinds.setdefault(words, []).append(place)
    for place, words in calls.wrong.items():
        kinds.setdefault(words, []).append(place)
    if calls.complex:
        kinds["it is complex"] = calls.complex
    quiet = set(range(expected.count)) - {place for places in kinds.values() for place in places} - set(calls.unknown)
    for place in sorted(quiet):
        if not np.isfinite(found[place]).all():
            kinds.setdefault("it is infinite" if np.isinf(found[place]).any() else "it is undefined", []).append(place)
    for words, places in list(kinds.items())[:SHOWN]:
        at = ", ".join(f"{name} = {value:.6g}" for name, value in expected.point(places[0]).items())
        there = np.isin(np.arange(expected.count), places)
        yield f"{words} {region(expected, there) if len(places) > 1 else 'at one point'}, such as {at}"


def where_beyond_single(reading: Reading, calls: Calls, expected: Expected) -> Iterator[str]:
    """Where what it should return is too large or too small for the precision that it returns."""
    if not (reading.single or calls.single):
        return
    found = reading.arrangement.undone(calls.values)
    places = np.flatnonzero(beyond_single(found, expected.values).any(axis=1))
    if len(places):
        at = ", ".join(f"{name} = {value:.6g}" for name, value in expected.point(int(places[0])).items())
        yield f"beyond what single precision holds at {len(places)} of {expected.count} points, such as {at}"


def where_indefinite(wanted: Wanted, expected: Expected, found: Array) -> Iterator[str]:
    """Where what should be a covariance is none."""
    if not wanted.quantity.is_covariance or len(wanted.shape) != 2:
        return
    scale = np.sqrt(np.abs(np.diagonal(expected.values.reshape(-1, *wanted.shape), axis1=1, axis2=2)))
    with np.errstate(all="ignore"):
        matrices = found.reshape(-1, *wanted.shape) / (scale[:, :, np.newaxis] * scale[:, np.newaxis, :])
    usable = np.isfinite(matrices).all(axis=(1, 2))
    lowest = np.array(
        [np.linalg.eigvalsh(one).min() if fine else 0.0 for one, fine in zip(matrices, usable, strict=True)]
    )
    places = np.flatnonzero(lowest < INDEFINITE)
    if len(places):
        place = max(places, key=lambda one: sum(_size(expected, int(one))))
        at = ", ".join(f"{name} = {value:.6g}" for name, value in expected.point(int(place)).items())
        yield f"indefinite, which no covariance is, at {len(places)} of {expected.count} points, such as {at}"


def _size(expected: Expected, place: int) -> Iterator[float]:
    """The scales of the deviations at a point: the larger they are, the less of an edge it is."""
    for name in deviations_of(expected.wanted.symbols):
        yield float(np.log10(max(expected.points[name][place], 1e-300)))
