"""Directions are right to their last rounding, whatever the arc tangent of the library is."""

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.frames import exact_sines
from tests.examples import share

LENGTHS = st.floats(5e-324, 1e90)
ARC_TANGENT = np.arctan2


def off_by(units: int, y: np.ndarray, x: np.ndarray) -> np.ndarray:
    angle = ARC_TANGENT(y, x)
    return np.clip(angle + units * np.spacing(angle), -np.pi, np.pi)


@pytest.mark.parametrize("units", [-4, -1, 0, 1, 4])
@given(length=LENGTHS, angle=st.floats(-math.pi, math.pi))
@share(0.3)
def test_a_direction_is_right_though_the_library_is_off(units: int, length: float, angle: float):
    y, x = np.array([length * math.sin(angle)]), np.array([length * math.cos(angle)])
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(np, "arctan2", lambda y, x: off_by(units, y, x))
        [found] = exact_sines.direction(y, x)
    with mpmath.workdps(40):
        exact = mpmath.atan2(mpmath.mpf(float(y[0])), mpmath.mpf(float(x[0])))
        assert abs(exact - mpmath.mpf(float(found))) <= 0.52 * math.ulp(found) + 1e-300


@pytest.mark.parametrize(
    ("y", "x", "angle"),
    [(0.0, 0.0, 0.0), (0.0, -1.0, math.pi), (5e-324, 0.0, math.pi / 2), (-5e-324, -5e-324, -0.75 * math.pi)],
)
def test_on_the_axis_and_beside_it_nothing_is_lost(y: float, x: float, angle: float):
    assert exact_sines.direction(np.array([y]), np.array([x])) == angle
