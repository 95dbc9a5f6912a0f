"""The bistatic radar: its series against quadrature, its triangle, and where the series end."""

import math
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import consistency, convert, observe, simulate, validity
from radartrack.convert import Converted, Method
from radartrack.testing import strategies
from tests.examples import share
from tests.radartrack.plots import METHODS, OF_THE_PLOT, Floats, Plot, assert_covariances_agree

PLOT: Plot = {"path": 30e3, "azimuth": 0.7, "baseline": 9e3, "path_std": 30.0, "azimuth_std": 0.02, "correlation": 0.3}
SERIES = 2e-3  # of the deviations, which series of the fourth order leave
PLOTS = strategies.plots(
    "bistatic",
    within={
        "path": (20e3, 60e3),
        "azimuth": (-7, 7),
        "baseline": (0, 12e3),
        "path_std": (1, 100),
        "azimuth_std": (1e-3, 0.03),
        "correlation": (-0.95, 0.95),
    },
)


def bistatic(method: Method = "unbiased", **changed: Any) -> Converted:
    plot = PLOT | changed
    if method == "decorrelated" and "predicted" not in plot:
        plot["predicted"] = prediction(plot)
    return convert.bistatic(**plot, method=method)


def prediction(plot: Plot) -> tuple[Floats, Floats]:
    return np.array([plot["path"] + 50.0, plot["azimuth"] - 0.01]), np.array([[2500.0, 0.2], [0.2, 1e-4]])


def position(plot: Plot, path: Any, azimuth: Any) -> Floats:
    """The target on the ray that is as far from the transmitter as what is left of the path, by bisection."""
    low, high = (
        np.zeros(np.broadcast(path, azimuth).shape),
        np.broadcast_to(path, np.broadcast(path, azimuth).shape) * 1.0,
    )
    r = (low + high) / 2
    for _ in range(200):
        far = r + np.hypot(r * np.cos(azimuth) - plot["baseline"], r * np.sin(azimuth)) > path
        low, high = np.where(far, low, r), np.where(far, r, high)
        r = (low + high) / 2
    return np.stack([r * np.cos(azimuth), r * np.sin(azimuth)], axis=-1)


def errors(plot: Plot) -> tuple[Floats, Floats, Floats]:
    """Errors of path and azimuth with their correlation, and weights."""
    nodes, weights = np.polynomial.hermite_e.hermegauss(9)
    first, second = (grid.ravel() for grid in np.meshgrid(nodes, nodes))
    rho = plot["correlation"]
    azimuth = plot["azimuth_std"] * (rho * first + math.sqrt(1 - rho**2) * second)
    return plot["path_std"] * first, azimuth, np.outer(weights, weights).ravel() / weights.sum() ** 2


@given(plot=PLOTS)
@share(0.3)
def test_the_posterior_and_the_unbiased_estimate_have_their_defining_moments(plot: Plot) -> None:
    of_path, of_azimuth, weights = errors(plot)
    truths = position(plot, plot["path"] - of_path, plot["azimuth"] - of_azimuth)
    mean = weights @ truths
    covariance = np.einsum("wi,wj,w->ij", truths - mean, truths - mean, weights)
    # A variance that vanishes to first order along an axis is one of what the series leaves out: the sum is the scale.
    scale = np.trace(covariance)
    got = convert.bistatic(**plot, method="posterior")
    assert (np.abs(got.covariance - covariance) <= SERIES * scale).all()
    assert (np.abs(got.mean - mean) <= SERIES * np.sqrt(scale)).all()
    moved = plot | {"path": plot["path"] + of_path, "azimuth": plot["azimuth"] + of_azimuth}
    unbiased = convert.bistatic(**moved)
    truth = position(plot, plot["path"], plot["azimuth"])
    assert (np.abs(weights @ unbiased.mean - truth) <= SERIES * np.sqrt(scale)).all()
    error = convert.bistatic(**plot).mean - truths
    squares = np.einsum("wi,wj,w->ij", error, error, weights)
    assert (np.abs(convert.bistatic(**plot).covariance - squares) <= SERIES * np.trace(squares)).all()


@pytest.mark.parametrize("method", METHODS)
@given(plot=PLOTS)
@share(0.2)
def test_without_a_baseline_it_is_the_radar_of_half_the_path(method: Method, plot: Plot) -> None:
    alone = plot | {"baseline": 0.0}
    mean, matrix = prediction(alone)
    half = np.array([0.5, 1.0])
    words: dict[str, Any] = {}
    if method == "decorrelated":
        words["predicted"] = mean * half, matrix * np.outer(half, half)
    got = bistatic(method, **alone)
    polar = convert.polar(
        plot["path"] / 2,
        plot["azimuth"],
        plot["path_std"] / 2,
        plot["azimuth_std"],
        plot["correlation"],
        method,
        **words,
    )
    deviations = np.sqrt(np.diagonal(polar.covariance))
    assert (np.abs(got.mean - polar.mean) <= 1e-3 * deviations).all()
    assert_covariances_agree(got.covariance, polar.covariance, 5e-3)


@pytest.mark.parametrize("azimuth_from", ["x", "y"])
@given(plot=PLOTS)
@share(0.3)
def test_observation_undoes_conversion(azimuth_from: Any, plot: Plot) -> None:
    mean = convert.bistatic(**plot, method="linear", azimuth_from=azimuth_from).mean
    path, azimuth = observe.bistatic(mean, plot["baseline"], azimuth_from).measurement
    assert path == pytest.approx(plot["path"], rel=1e-13)
    assert math.remainder(azimuth - plot["azimuth"], 2 * math.pi) == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("method", METHODS)
def test_the_other_azimuth_exchanges_the_axes(method: Method) -> None:
    from_x, from_y = (bistatic(method, azimuth_from=axis) for axis in ("x", "y"))
    np.testing.assert_array_equal(from_y.mean, from_x.mean[::-1])
    np.testing.assert_array_equal(from_y.covariance, from_x.covariance[::-1, ::-1])


@pytest.mark.parametrize("method", METHODS)
def test_arrays_and_plain_numbers_and_float32_agree(method: Method) -> None:
    paths, baselines = np.array([20e3, 30e3, 80e3]), np.array([[0.0], [9e3]])
    got = (
        bistatic(method, path=paths, baseline=baselines, predicted=prediction(PLOT))
        if method == "decorrelated"
        else bistatic(method, path=paths, baseline=baselines)
    )
    assert (got.mean.shape, got.covariance.shape) == ((2, 3, 2), (2, 3, 2, 2))
    words: Any = {"predicted": prediction(PLOT)} if method == "decorrelated" else {}
    alone = bistatic(method, path=80e3, baseline=9e3, **words)
    np.testing.assert_allclose(got.mean[1, 2], alone.mean, rtol=1e-13)
    assert_covariances_agree(got.covariance[1, 2], alone.covariance, 1e-12)
    single: dict[str, Any] = {name: np.float32(value) for name, value in PLOT.items()}
    if method == "decorrelated":
        single["predicted"] = tuple(part.astype(np.float32) for part in prediction(PLOT))
    few = convert.bistatic(**single, method=method)
    assert few.mean.dtype == few.covariance.dtype == np.float32
    assert_covariances_agree(few.covariance.astype(float), bistatic(method).covariance, 1e-4)


@pytest.mark.parametrize("scale", [1e-25, 1e-9, 1e5, 1e90])
@pytest.mark.parametrize("method", OF_THE_PLOT)
def test_a_larger_triangle_has_larger_positions_and_no_overflow(method: Method, scale: float) -> None:
    lengths = {name: PLOT[name] * scale for name in ("path", "baseline", "path_std")}
    small, large = bistatic(method), bistatic(method, **lengths)
    np.testing.assert_allclose(large.mean, small.mean * scale, rtol=1e-13)
    np.testing.assert_allclose(large.covariance, small.covariance * scale**2, rtol=1e-10)


@pytest.mark.parametrize("method", OF_THE_PLOT)
@given(
    share_of_path=st.floats(0, 0.99),
    relative=st.floats(0, 1),
    turned=st.floats(0, 1),
    azimuth=st.floats(-4, 4),
    correlation=st.floats(-1, 1),
)
@share(0.5)
def test_covariances_are_such_up_to_where_the_series_end(
    method: Method, share_of_path: float, relative: float, turned: float, azimuth: float, correlation: float
) -> None:
    baseline = 1e4 * share_of_path
    path_std = (0.999e4 - baseline) / 5 * relative * 0.999
    azimuth_std = min(0.5, math.acosh(1e4 / baseline) / 5 if baseline else 0.5) * turned * 0.999
    found = convert.bistatic(1e4, azimuth, baseline, path_std, azimuth_std, correlation, method)
    assert np.isfinite(found.mean).all()
    deviations = np.sqrt(np.diagonal(found.covariance))
    divisors = np.where(deviations > 0, deviations, 1)
    assert np.linalg.eigvalsh(found.covariance / np.outer(divisors, divisors)).min() > -1e-9


@pytest.mark.parametrize("azimuth_from", ["x", "y"])
@pytest.mark.parametrize(("method", "condition"), [("posterior", "measurement"), ("unbiased", "measurement")])
def test_simulated_errors_have_the_covariance_that_is_told(azimuth_from: Any, method: Method, condition: Any) -> None:
    found = consistency.experiment("bistatic", PLOT, method, condition, azimuth_from=azimuth_from, false_alarm=1e-6)
    assert found.is_consistent


def test_a_simulated_bistatic_radar_measures_path_and_azimuth() -> None:
    noise = {name: PLOT[name] for name in ("path_std", "azimuth_std", "correlation")}
    radar = simulate.Radar("bistatic", 2.0, noise, known={"baseline": 9e3})
    seen = simulate.plots(simulate.Straight((12e3, 5e3), (100.0, 0.0)), radar, scans=3, trials=2000)
    assert seen.truth["path"][0] == pytest.approx(13e3 + math.hypot(3e3, 5e3))
    assert (seen.measured["path"] - seen.truth["path"]).std() == pytest.approx(30.0, rel=0.05)
    with pytest.raises(TypeError, match=r"known must have \['baseline'\]; got \[\]"):
        simulate.Radar("bistatic", 2.0, noise)


@pytest.mark.parametrize("formulas", ["linear", "second_order"])
@given(plot=PLOTS)
@share(0.1)
def test_validity_is_the_next_taylor_term_over_the_deviation(formulas: Any, plot: Plot) -> None:
    order = {"linear": 2, "second_order": 3}[formulas]

    def coordinates(path: Any, azimuth: Any) -> list[Any]:
        r = (path**2 - plot["baseline"] ** 2) / (path - plot["baseline"] * mpmath.cos(azimuth)) / 2
        return [r * mpmath.cos(azimuth), r * mpmath.sin(azimuth)]

    def along(error: tuple[float, float], degree: int) -> list[float]:
        def moved(k: int) -> Any:
            return lambda t: coordinates(plot["path"] + t * error[0], plot["azimuth"] + t * error[1])[k]

        with mpmath.workdps(40):
            return [float(mpmath.diff(moved(k), 0, degree)) for k in range(2)]

    jacobian = np.array([along(unit, 1) for unit in ((1.0, 0.0), (0.0, 1.0))]).T
    nodes, weights = np.polynomial.hermite_e.hermegauss(4)
    rho, deviations = plot["correlation"], np.array([plot["path_std"], plot["azimuth_std"]])
    total = np.zeros(2)
    for a, first in zip(nodes, weights, strict=True):
        for b, second in zip(nodes, weights, strict=True):
            error = (deviations[0] * a, deviations[1] * (rho * a + math.sqrt(1 - rho**2) * b))
            neglected = np.linalg.solve(jacobian, along(error, order)) / math.factorial(order)
            total += first * second * neglected**2
    expected = np.sqrt(total / weights.sum() ** 2) / deviations
    np.testing.assert_allclose(validity.bistatic(**plot, formulas=formulas), expected, rtol=1e-7, atol=1e-12)
    np.testing.assert_array_equal(
        validity.bistatic(**plot, azimuth_from="y"), validity.bistatic(**plot, azimuth_from="x")
    )


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"path": 0.0}, "path must be from 1e-30 to 1e[+]100 m"),
        ({"baseline": -1.0}, "baseline must be from 0 to 1e[+]100 m"),
        ({"azimuth_std": 0.6}, "azimuth_std must be from 0 to 0.5 rad"),
        ({"path": 9e3}, r"\(baseline \+ 5 path_std\)/path must be from 0 to 0.999 .*; got 1.01"),
        (
            {"path": 9.5e3, "azimuth_std": 0.1},
            r"5 azimuth_std/arccosh\(path/baseline\) must be from 0 to 1 .*; got 1.5",
        ),
        ({"path_std": [1.0, 1e4]}, r"\(baseline \+ 5 path_std\)/path must be .*; got 1.96.* at \[1\]"),
    ],
)
def test_what_is_too_near_the_baseline_is_refused_with_what_is_allowed(changed: Plot, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        bistatic(**changed)


def test_a_baseline_of_zero_may_have_a_sign() -> None:
    plus, minus = (convert.bistatic(8e4, 0.5, baseline, 30.0, 0.01, 0.2) for baseline in (0.0, -0.0))
    np.testing.assert_array_equal(plus.mean, minus.mean)
