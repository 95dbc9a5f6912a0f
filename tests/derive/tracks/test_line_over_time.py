"""Ordinary regression of a coordinate on time, against its hat matrix."""

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from radartrack.derive import symbolic as sp
from radartrack.derive.tracks import line_over_time

LEVERAGE = line_over_time.leverage()
TIMES = st.lists(st.integers(-60, 60), min_size=3, max_size=8)


def left_by_projection(times: list[int]) -> NDArray[Any]:
    """What the residuals of a straight-line fit are, as a matrix on the errors: I - A (A'A)^-1 A'."""
    design = np.stack([np.ones(len(times)), np.array(times, float)], axis=1)
    left: NDArray[Any] = np.eye(len(times)) - design @ np.linalg.pinv(design)
    return left


@given(times=TIMES)
def test_leverages_are_the_diagonal_of_the_hat_matrix(times: list[int]) -> None:
    assume(len(set(times)) > 1)
    n, mean = len(times), Fraction(sum(times), len(times))
    spread = sum((time - mean) ** 2 for time in times)
    fixed = {line_over_time.n: Fraction(n), line_over_time.mean_t: mean, line_over_time.S_tt: Fraction(spread)}
    leverage = LEVERAGE.xreplace({symbol: sp.Rational(value) for symbol, value in fixed.items()})
    derived = [float(leverage.xreplace({line_over_time.t: sp.Integer(time)})) for time in times]
    assert derived == pytest.approx(1 - np.diag(left_by_projection(times)), abs=1e-12)


@given(times=TIMES)
def test_degrees_of_freedom_are_the_trace_of_what_is_left(times: list[int]) -> None:
    assume(len(set(times)) > 1)
    derived = line_over_time.degrees_of_freedom().xreplace({line_over_time.n: sp.Integer(len(times))})
    assert float(derived) == pytest.approx(np.trace(left_by_projection(times)))


def test_the_variance_of_exact_points_is_that_of_their_residuals() -> None:
    t, x = np.array([0.0, 1.0, 3.0, 7.0, 8.0]), np.array([2.0, -1.0, 4.0, 4.5, 9.0])
    residual = x - np.polyval(np.polyfit(t, x, 1), t)
    t, x = t - t.mean(), x - x.mean()
    sums = {line_over_time.S_tt: t @ t, line_over_time.S_tx: t @ x, line_over_time.S_xx: x @ x, line_over_time.n: 5}
    derived = line_over_time.variance().xreplace(
        {symbol: sp.Rational(Fraction(value)) for symbol, value in sums.items()}
    )
    assert float(derived) == pytest.approx(residual @ residual / 3)
