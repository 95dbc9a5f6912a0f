"""What sites observe together, from triangles: a length's rate is what it grows in a moment of flight."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import mpmath

from radartrack.derive.language.tensor import Tensor

METHOD = "triangles, and how they change in flight"
Number = Any
At = Mapping[str, Number]


def _side(position: Sequence[Number], site: Sequence[Number]) -> Number:
    """The law of cosines, the radar at the corner."""
    here, there = mpmath.norm(list(position)), mpmath.norm(list(site))
    cosine = mpmath.fdot(position, site) / (here * there)
    return mpmath.sqrt(here**2 + there**2 - 2 * here * there * cosine)


def _difference(at: At, elapsed: Number = 0) -> Number:
    position = [at[axis] + elapsed * at.get(f"v{axis}", 0) for axis in "xyz"]
    return _side(position, [at[f"receiver_{axis}"] for axis in "xyz"]) - mpmath.norm(position)


def _path(at: At, elapsed: Number) -> Number:
    position = [at[axis] + elapsed * at[f"v{axis}"] for axis in "xy"]
    return _side(position, [at["baseline"], 0]) + mpmath.norm(position)


def _rate(length: Callable[[Number], Number]) -> Tensor[Number]:
    return Tensor((1,), (mpmath.diff(length, 0),))


def _bearing(at: At) -> Tensor[Number]:
    """Twice the angle at the circumference is that at the centre."""
    return Tensor((1,), (2 * mpmath.atan(at["y"] / (mpmath.hypot(at["x"], at["y"]) + at["x"])),))


DERIVATIONS: dict[str, Callable[[At], Tensor[Number]]] = {
    "observe.bearing.map": _bearing,
    "observe.range_difference.map": lambda at: Tensor((1,), (_difference(at),)),
    "observe.range_rate_difference.map": lambda at: _rate(lambda elapsed: _difference(at, elapsed)),
    "observe.bistatic_range_rate.map": lambda at: _rate(lambda elapsed: _path(at, elapsed)),
}
