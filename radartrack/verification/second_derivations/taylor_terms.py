"""Terms of Taylor expansions from direct power series, in many digits."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.sensors import models
from radartrack.verification.second_derivations.direct_series import at_point, derivatives
from radartrack.verification.second_derivations.power_series import Jet, averaged, jets

METHOD = "direct power series"
Number = Any
At = Mapping[str, Number]
X, Y = sp.Symbol("first", real=True), sp.Symbol("second", real=True)
WITH = {"f_xx": sp.exp(X), "f_xy": sp.sin(X) * sp.sin(Y), "f_yy": -sp.cos(Y)}
"""For each second derivative a function whose only one it is, and that is no polynomial."""


def _series(at: At) -> Jet:
    """The second-degree part of f(x + dx, y + dy)."""
    zero = {X: mpmath.mpf(0), Y: mpmath.mpf(0)}
    whole = jets(list(WITH.values()), zero, (X, Y), 4)
    parts = [series.scaled(at[name]) for name, series in zip(WITH, whole, strict=True)]
    return sum(parts[1:], parts[0]).only(lambda powers: sum(powers) == 2)


def _term(at: At) -> Tensor[Number]:
    moved = [at["dx"] ** m * at["dy"] ** n * value for (m, n, _), value in _series(at).terms.items()]
    return Tensor((), (mpmath.fsum(moved),))


def _mean(at: At) -> Tensor[Number]:
    covariance = [[at["D_1"], at["K_12"]], [at["K_12"], at["D_2"]]]
    return Tensor((), (at_point(averaged(_series(at), covariance)),))


def _cross_range_std(at: At) -> Tensor[Number]:
    """How far the position of the polar map moves with the azimuth, wherever the target is."""
    polar = models()["polar"]
    r, azimuth = polar.measured
    series = jets(list(polar.map), {r: at["r"], azimuth: mpmath.mpf(1)}, (azimuth,), 1)
    return Tensor((), (mpmath.norm(list(derivatives(series, 1, 1))) * at["sigma_beta"],))


DERIVATIONS: dict[str, Callable[[At], Tensor[Number]]] = {
    "taylor.quadratic_term": _term,
    "taylor.mean_shift": _mean,
    "fusion.cross_range_std": _cross_range_std,
}
