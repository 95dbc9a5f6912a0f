"""Angles of points against many digits: rounded once, whatever the library's arctangent does."""

import math

import mpmath
import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from radartrack.frames import exact_sines
from radartrack.frames.exact_sines import angle_of

TINY = 1e-200  # of less, what a rounding leaves underflows
COORDINATES = st.floats(-1e9, 1e9).map(lambda value: value if abs(value) >= TINY else 0.0)
COORDINATES |= st.floats(-200, 100).flatmap(lambda power: st.sampled_from([10.0**power, -(10.0**power)]))


def off(x: float, y: float, angle: float) -> float:
    """How far an angle is from that of the point, in halves of the distance to the next number."""
    with mpmath.workdps(400):
        return float(abs(mpmath.atan2(mpmath.mpf(y), mpmath.mpf(x)) - mpmath.mpf(angle))) / math.ulp(angle) * 2


@given(x=COORDINATES, y=COORDINATES)
def test_an_angle_is_that_of_the_point_but_for_its_last_rounding(x: float, y: float) -> None:
    assume(x or y)
    x, y = x + 0.0, y + 0.0
    assume(not 0 < abs(y) < TINY * abs(x))
    angle = float(angle_of(np.array([x]), np.array([y]))[0])
    assert off(x, y, angle) <= 1.1


@pytest.mark.parametrize(("x", "y"), [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (0.0, 0.0), (-1.0, -1e-30)])
def test_on_the_axes_the_angle_is_that_of_the_library(x: float, y: float) -> None:
    assert angle_of(np.array([x]), np.array([y]))[0] == math.atan2(y, x)


def test_a_poor_arctangent_is_mended(monkeypatch: pytest.MonkeyPatch) -> None:
    """One whose last three bits are wrong."""
    x, y = np.random.default_rng(1).uniform(-1e7, 1e7, (2, 500))
    right = np.arctan2

    class Poor:
        def __getattr__(self, name: str) -> object:
            return getattr(np, name)

        @staticmethod
        def arctan2(b: np.ndarray, a: np.ndarray) -> np.ndarray:
            return np.asarray(right(b, a) * (1 + 2.0**-50))

    monkeypatch.setattr(exact_sines, "np", Poor())
    angles = angle_of(x, y)
    assert max(map(off, x.tolist(), y.tolist(), angles.tolist())) <= 1.1
