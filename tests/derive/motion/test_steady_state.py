"""The proof that a steady state solves the Riccati equation fails for any other gain."""

from dataclasses import replace

import mpmath
import pytest
import sympy

from radartrack.derive.evaluation.many_digits import evaluate
from radartrack.derive.language.stable_form import NotProved
from radartrack.derive.motion.steady_state import ALPHA_BETA, ALPHA_BETA_GAMMA, SteadyState, index, w

FILTERS = [ALPHA_BETA, ALPHA_BETA_GAMMA]


@pytest.mark.parametrize("steady", FILTERS)
def test_the_predicted_covariance_is_the_gain_times_that_of_the_innovation(steady: SteadyState) -> None:
    before = steady.predicted
    for gain, covariance in zip(steady.gain, before[0], strict=True):
        assert sympy.cancel(gain * (before[0][0] + 1) - covariance) == 0


@pytest.mark.parametrize(("steady", "place"), [(ALPHA_BETA, 0), (ALPHA_BETA, 1), (ALPHA_BETA_GAMMA, 2)])
def test_another_gain_is_refused(steady: SteadyState, place: int) -> None:
    other = tuple(gain * (2 if n == place else 1) for n, gain in enumerate(steady.gain))
    with pytest.raises(NotProved):
        _ = replace(steady, gain=other).predicted


@pytest.mark.parametrize("steady", FILTERS)
def test_another_index_is_refused(steady: SteadyState) -> None:
    with pytest.raises(NotProved):
        _ = replace(steady, index=2 * steady.index).predicted


@pytest.mark.parametrize("steady", FILTERS)
@pytest.mark.parametrize("value", [1e-9, 0.5, 20.0, 1e3])
def test_the_root_belongs_to_the_index(steady: SteadyState, value: float) -> None:
    root = evaluate(steady.root, {index: value})
    assert root > 1
    with mpmath.workdps(50):
        assert abs(evaluate(steady.index, {w: root}) / value - 1) < mpmath.mpf(10) ** -40
