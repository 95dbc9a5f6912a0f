"""Plain differences and factors are one update: which of them does it shows in nothing but the time."""

import re
from typing import Any, cast

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import kalman
from radartrack._filtering import beliefs, refinement
from radartrack._observation.sights import SIGHTS
from radartrack.kalman import Belief
from tests.examples import share
from tests.radartrack.test_update_with import assert_same, by_the_book, scene, update


def in_factors_alone(covariance: Any, told: refinement.Told) -> tuple[Any, Any]:
    return refinement._in_factors(covariance, told)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("sensor", ["bearing", "polar", "spherical", "spherical_doppler", "range_rate_difference"])
@given(power=st.floats(-3, 8), rho=st.floats(0, 8), seed=st.integers(0, 10**6))
@share(0.5)
def test_however_good_and_correlated_the_measurement_both_ways_agree(
    sensor: str, order: int, power: float, rho: float, seed: int
) -> None:
    """The correlation is 1 - 10^-rho, the deviations are divided by 10^power."""
    belief, measured, noise = scene(sensor, seed, (3,), more=1)
    errors = noise / 10.0 ** (2 * power)
    deviations = np.sqrt(np.diagonal(errors))
    errors = np.outer(deviations, deviations) * ((1 - 10.0**-rho) + np.eye(len(noise)) * 10.0**-rho)
    got = update(sensor, belief, measured, errors, order)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(kalman, "refined", in_factors_alone)
        expected = update(sensor, belief, measured, errors, order)
    np.testing.assert_array_equal(got.covariance, np.swapaxes(got.covariance, -1, -2))
    assert_same(got, expected, 1e-8)
    assert (np.linalg.eigvalsh(correlations(got.covariance)) >= -1e-14).all()


def correlations(covariance: Any) -> Any:
    deviations = np.sqrt(np.diagonal(covariance, axis1=-2, axis2=-1))
    return covariance / (deviations[..., :, np.newaxis] * deviations[..., np.newaxis, :])


@pytest.mark.parametrize(
    ("dtype", "correlation", "better", "expected"),
    [
        ("f8", 0, [0.1, 3.0, 1e4, 1e6], 2),
        ("f4", 0, [0.1, 3.0, 1e4, 1e6], 3),
        ("f8", 1 - 1e-9, [1e-6] * 4, 4),
    ],
)
def test_tracks_that_would_lose_their_digits_go_in_factors_and_the_others_do_not(
    dtype: str, correlation: float, better: list[float], expected: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    belief, measured, noise = scene("polar", 3, (4,))
    noise[0, 1] = noise[1, 0] = correlation * np.sqrt(noise[0, 0] * noise[1, 1])
    errors = noise / np.square(better)[:, np.newaxis, np.newaxis]
    sent = []

    def watched(covariance: Any, told: refinement.Told) -> Any:
        sent.append(told.innovation.shape[-1])
        return in_factors(covariance, told)

    in_factors = refinement._in_factors
    monkeypatch.setattr(refinement, "_in_factors", watched)
    given_belief = Belief(*(part.astype(dtype) for part in belief))
    got = update("polar", given_belief, measured.astype(dtype), errors.astype(dtype))
    assert sent == [expected]
    assert (np.linalg.eigvalsh(correlations(got.covariance)) >= -8 * np.finfo(dtype).eps).all()


@pytest.mark.parametrize("more", [1e-6, 1e-3, 0.1, 1.0])
def test_where_rounding_took_more_than_the_noise_the_result_is_still_a_belief(more: float) -> None:
    """Of two components that are nearly one, by a correlation above one: of their difference the variance is < 0."""
    above = 1 + 4e-9
    belief = Belief(np.array([1e3, 1e3]), np.array([[1.0, above], [above, 1.0]]) * 1e4)
    across = np.array([-1.0, 1.0]) / 2e3
    noise = np.full((1, 1), -across @ belief.covariance @ across * (1 + more))
    got = update("bearing", belief, [np.pi / 4], noise)
    assert (np.linalg.eigvalsh(got.covariance) >= 2.01 * np.linalg.eigvalsh(belief.covariance).min()).all()
    np.testing.assert_allclose(got.covariance, belief.covariance, rtol=1e-8)


@pytest.mark.parametrize("order", [1, 2])
def test_measurements_missing_in_some_tracks_leave_the_others_bits(order: int) -> None:
    belief, measured, noise = scene("spherical_doppler", 2, (16,), more=1)
    holes = np.array([[number >> place & 1 for place in range(4)] for number in range(16)], dtype=bool)
    got = update("spherical_doppler", belief, np.where(holes, np.nan, measured), noise, order)
    whole = update("spherical_doppler", belief, measured, noise, order)
    np.testing.assert_array_equal(got.mean[0], whole.mean[0])
    np.testing.assert_array_equal(got.covariance[0], whole.covariance[0])
    for number in range(16):
        alone = update(
            "spherical_doppler",
            Belief(belief.mean[number], belief.covariance[number]),
            np.where(holes[number], np.nan, measured[number]),
            noise,
            order,
        )
        np.testing.assert_array_equal(got.mean[number], alone.mean)
        np.testing.assert_array_equal(got.covariance[number], alone.covariance)


@pytest.mark.parametrize("sensor", ["polar", "spherical", "polar_doppler", "spherical_doppler", "bistatic", "ruv"])
@given(power=st.floats(1, 6), better=st.floats(0, 8), seed=st.integers(0, 10**6), sight=st.booleans())
@share(0.3)
def test_what_is_known_to_lie_on_a_line_is_updated_however_far_along_it(
    sensor: str, power: float, better: float, seed: int, *, sight: bool
) -> None:
    """All of what curvature adds is one error then, and far more than the noise: that is no fault of the noise.

    Along the line of sight curvature adds nothing to the angles, and rounding takes nothing from them.
    """
    belief, measured, noise = scene(sensor, seed)
    along = np.random.default_rng(seed).standard_normal(belief.mean.shape) * np.sqrt(np.diagonal(belief.covariance))
    if sight:
        along = belief.mean / 10.0**power
    spread = 10.0 ** (2 * power) * np.outer(along, along)
    got = update(sensor, Belief(belief.mean, spread), measured, noise / 10.0 ** (2 * better), 2)
    deviations = np.sqrt(np.diagonal(spread))
    assert (np.linalg.eigvalsh(got.covariance / np.outer(deviations, deviations)) >= -1e-14).all()
    assert (np.diagonal(got.covariance) <= np.diagonal(spread) * (1 + 1e-12)).all()


@pytest.mark.parametrize("order", [1, 2])
def test_a_noise_that_is_none_is_refused_in_whatever_track(order: int) -> None:
    belief, measured, noise = scene("polar", 4, (5,))
    errors = np.tile(noise, (5, 1, 1))
    errors[3] = [[1.0, 1.1], [1.1, 1.0]]
    with pytest.raises(
        ValueError, match=r"noise must be positive semidefinite; got .* at \[3\], the first of 1 among 5"
    ):
        update("polar", belief, measured, errors, order)


def test_single_beside_double_precision_computes_in_double() -> None:
    belief, measured, noise = scene("spherical", 6, (3,))
    single = Belief(belief.mean.astype(np.float32), belief.covariance.astype(np.float32))
    double = Belief(single.mean.astype(np.float64), single.covariance.astype(np.float64))
    got, expected = update("spherical", single, measured, noise), update("spherical", double, measured, noise)
    assert got.covariance.dtype == np.float64
    np.testing.assert_array_equal(got.mean, expected.mean)
    np.testing.assert_array_equal(got.covariance, expected.covariance)


@pytest.mark.parametrize("sensor", SIGHTS)
def test_a_belief_that_is_asymmetric_by_rounding_counts_by_its_upper_triangle(sensor: str) -> None:
    belief, measured, noise = scene(sensor, 8)
    asymmetric = belief.covariance.copy()
    asymmetric[-1, 0] *= 1 + 1e-10
    got = update(sensor, Belief(belief.mean, asymmetric), measured, noise, 2)
    symmetric = np.where(np.triu(np.ones(asymmetric.shape)), asymmetric, asymmetric.T)
    expected = update(sensor, Belief(belief.mean, symmetric), measured, noise, 2)
    np.testing.assert_array_equal(got.covariance, expected.covariance)
    assert_same(got, by_the_book(sensor, Belief(belief.mean, symmetric), measured, noise, 2))


def test_what_is_no_covariance_is_counted_among_all_tracks() -> None:
    count = beliefs.BLOCK + 7
    belief, measured, noise = scene("polar", 4, (count,))
    belief.covariance[count - 2, 0, 0] = -1
    message = re.escape(f"at [{count - 2}], the first of 1 among {count}")
    with pytest.raises(ValueError, match=rf"covariance must be without a negative variance.*{message}"):
        update(cast("Any", "polar"), belief, measured, noise)
