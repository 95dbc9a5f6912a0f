"""Intervals of figures from repeated trials."""

from typing import Any

import numpy as np
import pytest
import scipy.stats

from radartrack._arrays import repeated_trials

ONE_STANDARD_ERROR = 0.6826894921370859


def test_the_interval_of_an_excess_is_that_of_a_ratio_over_the_same_trials() -> None:
    """Over 2000 repetitions the half width at one standard deviation is the scatter of the ratio, within 10 %."""
    generator = np.random.default_rng(1)
    reference = generator.exponential(size=(300, 2000))
    squares = 2.0 * reference + 0.5 * generator.exponential(size=(300, 2000))
    found = repeated_trials.excess(squares, reference, ONE_STANDARD_ERROR)
    assert found.value.mean() == pytest.approx(1.5, rel=0.01)
    assert (found.upper - found.value).mean() == pytest.approx(found.value.std(), rel=0.1)


def test_intervals_of_root_mean_squares_hold_the_truth_as_often_as_they_say() -> None:
    """Of 4000 intervals at 90 % a share within 2 % of that holds the deviation; one that is 5 % off is found."""
    squares = 9.0 * np.random.default_rng(2).standard_normal((400, 4000)) ** 2
    found = repeated_trials.root_mean(squares, 0.9)
    assert np.mean((found.lower < 3.0) & (found.upper > 3.0)) == pytest.approx(0.9, abs=0.02)


def test_an_interval_is_as_wide_as_it_is_sure() -> None:
    """One half plus a confidence of nearly 1 would be 1."""
    values = np.array([-1.0, 1.0])
    for confidence in (1e-9, 0.5, 0.95, 1 - 1e-13, float(np.nextafter(1, 0))):
        found = repeated_trials.mean(values, confidence)
        assert found.upper == pytest.approx(scipy.stats.norm.isf((1 - confidence) / 2), rel=1e-9)


def test_root_excess_is_the_ratio_of_root_mean_squares_less_one() -> None:
    generator = np.random.default_rng(3)
    one, other = generator.exponential(size=(2, 500, 3))
    found = repeated_trials.root_excess(one, other)
    assert found.value == pytest.approx(np.sqrt(one.mean(axis=0) / other.mean(axis=0)) - 1)
    assert (found.lower < found.value).all()
    assert (found.value < found.upper).all()


FIGURES = {
    "mean": repeated_trials.mean,
    "root_mean": repeated_trials.root_mean,
    "excess": lambda values, *rest: repeated_trials.excess(values, np.ones_like(values), *rest),
    "root_excess": lambda values, *rest: repeated_trials.root_excess(values, np.ones_like(values), *rest),
}


@pytest.mark.parametrize("figure", FIGURES.values(), ids=FIGURES)
def test_two_trials_have_a_scatter_and_fewer_have_none(figure: Any) -> None:
    assert np.isfinite(figure(np.array([[1.0, 2.0], [2.0, 1.0]]))).all()
    assert figure(np.ones((2, 0))).value.shape == (0,)
    for few in (np.ones(1), np.ones((0, 3)), np.array(1.0)):
        with pytest.raises(ValueError, match="must have at least 2 trials"):
            figure(few)
    for bad in (np.nan, np.inf):
        with pytest.raises(ValueError, match="must be finite"):
            figure(np.array([1.0, bad]))
    for share in (0.0, 1.0, -0.5, np.nan):
        with pytest.raises(ValueError, match="confidence must be"):
            figure(np.ones(3), share)


def test_an_excess_over_nothing_or_over_other_trials_is_refused() -> None:
    with pytest.raises(ValueError, match="reference must have a mean of more than 0; got 0"):
        repeated_trials.excess(np.ones((3, 2)), np.array([[1.0, 0.0]] * 3))
    with pytest.raises(ValueError, match=r"must have one shape; got \(3,\) and \(4,\)"):
        repeated_trials.excess(np.ones(3), np.ones(4))


@pytest.mark.parametrize("figure", FIGURES.values(), ids=FIGURES)
def test_an_estimate_that_overflows_is_refused(figure: Any) -> None:
    with pytest.raises(ValueError, match="of the estimate must be finite"):
        figure(np.array([1e308, 1e308, 5e307]))
