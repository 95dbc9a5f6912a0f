"""The proof that a steady state solves the Riccati equation fails for any other gain."""

from dataclasses import replace

import pytest
import sympy

from radartrack.derive.language.stable_form import NotProved
from radartrack.derive.motion.steady_state import ALPHA_BETA, ALPHA_BETA_GAMMA, SteadyState, index, w

FILTERS = [ALPHA_BETA, ALPHA_BETA_GAMMA]


@pytest.mark.parametrize("steady", FILTERS)
def test_the_predicted_covariance_is_the_gain_times_that_of_the_innovation(steady: SteadyState) -> None:
    before = steady.predicted
    for gain, covariance in zip(steady.gain, before[0], strict=True):
        assert sympy.cancel(gain * (before[0][0] + 1) - covariance) == 0


@pytest.mark.parametrize("steady", FILTERS)
@pytest.mark.parametrize("place", [0, 1])
def test_another_gain_is_refused(steady: SteadyState, place: int) -> None:
    other = tuple(gain * (2 if n == place else 1) for n, gain in enumerate(steady.gain))
    with pytest.raises(NotProved):
        _ = replace(steady, gain=other).predicted


@pytest.mark.parametrize("steady", FILTERS)
def test_another_index_is_refused(steady: SteadyState) -> None:
    with pytest.raises(NotProved):
        _ = replace(steady, index=2 * steady.index).predicted


@pytest.mark.parametrize("steady", FILTERS)
def test_the_root_belongs_to_the_index(steady: SteadyState) -> None:
    for value in (1e-6, 0.5, 20.0, 400.0):
        root = complex(
            steady.root.xreplace({index: sympy.Float(value, 30)})
            .xreplace({})
            .replace(lambda part: part.func.__name__ == "third", lambda part: sympy.cos(sympy.acos(part.args[0]) / 3))
            .evalf(30)
        )
        assert abs(root.imag) < 1e-12
        assert float(steady.index.xreplace({w: sympy.Float(root.real, 30)})) == pytest.approx(value, rel=1e-5)
