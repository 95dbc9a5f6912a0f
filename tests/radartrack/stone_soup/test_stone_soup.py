"""What stands in the place of Stone Soup's parts does what theirs do, and is right where theirs are not."""

import math
from importlib import import_module
from importlib.metadata import entry_points
from typing import Any

import numpy as np
import pytest

pytest.importorskip("stonesoup", reason="these tests run against Stone Soup itself")

from stonesoup.feeder.base import DetectionFeeder
from stonesoup.initiator.simple import SimpleMeasurementInitiator
from stonesoup.models.measurement import nonlinear
from stonesoup.models.measurement.linear import LinearGaussian
from stonesoup.types.array import CovarianceMatrix, StateVector, StateVectors
from stonesoup.types.detection import Clutter, Detection, GaussianDetection, TrueDetection
from stonesoup.types.groundtruth import GroundTruthPath
from stonesoup.types.hypothesis import SingleHypothesis
from stonesoup.types.prediction import GaussianStatePrediction
from stonesoup.types.state import GaussianState, State
from stonesoup.updater.kalman import ExtendedKalmanUpdater, KalmanUpdater, UnscentedKalmanUpdater

import radartrack as rt
from radartrack import stone_soup
from tests.radartrack.stone_soup.scenes import (
    IN_PLANE,
    IN_SPACE,
    MOVING_IN_PLANE,
    MOVING_IN_SPACE,
    PLANE,
    SHIFT,
    SPACE,
    TILTED,
    TIME,
    detections,
    nees,
    noise,
)

MODELS: dict[str, tuple[type, type, dict[str, Any]]] = {
    "bearing": (
        stone_soup.ExactBearing2D, nonlinear.Cartesian2DToBearing, PLANE | IN_PLANE | {"noise_covar": noise(0.01)},
    ),
    "plane": (
        stone_soup.ExactBearingRange, nonlinear.CartesianToBearingRange,
        PLANE | IN_PLANE | {"noise_covar": noise(0.01, 9)},
    ),
    "plane, rate": (
        stone_soup.ExactBearingRangeRate2D, nonlinear.CartesianToBearingRangeRate2D,
        PLANE | IN_PLANE | MOVING_IN_PLANE | {"noise_covar": noise(0.01, 9, 2)},
    ),
    "angles": (
        stone_soup.ExactElevationBearing, nonlinear.CartesianToElevationBearing,
        SPACE | IN_SPACE | {"noise_covar": noise(0.02, 0.01)},
    ),
    "space": (
        stone_soup.ExactElevationBearingRange, nonlinear.CartesianToElevationBearingRange,
        SPACE | IN_SPACE | {"noise_covar": noise(0.02, 0.01, 9)},
    ),
    "no elevation": (
        stone_soup.ExactBearingRangeRate, nonlinear.CartesianToBearingRangeRate,
        SPACE | IN_SPACE | MOVING_IN_SPACE | {"noise_covar": noise(0.01, 9, 2)},
    ),
    "space, rate": (
        stone_soup.ExactElevationBearingRangeRate, nonlinear.CartesianToElevationBearingRangeRate,
        SPACE | IN_SPACE | MOVING_IN_SPACE | {"noise_covar": noise(0.02, 0.01, 9, 2)},
    ),
}  # fmt: skip
REVERSIBLE = ["plane", "plane, rate", "space", "space, rate"]


def made(name: str, **other: Any) -> tuple[Any, Any]:
    """Our model, and Stone Soup's of the same arguments."""
    ours, theirs, arguments = MODELS[name]
    return ours(**arguments | other), theirs(**arguments | other)


def states(count: int, model: Any, seed: int = 5) -> Any:
    return StateVectors(np.random.default_rng(seed).normal(0, 2000.0, (model.ndim_state, count)))


@pytest.mark.parametrize("name", MODELS)
class TestModels:
    """Subclasses of Stone Soup's models, with derivatives that are no differences."""

    def test_is_the_same_function(self, name: str) -> None:
        ours, theirs = made(name)
        assert isinstance(ours, type(theirs))
        many = State(states(4, ours))
        np.testing.assert_array_equal(ours.function(many), theirs.function(many))

    def test_first_derivatives_are_those_of_the_function_by_central_differences(self, name: str) -> None:
        ours, theirs = made(name)
        at, step = states(1, ours), 0.05
        differences = np.empty((ours.ndim_meas, ours.ndim_state))
        for place in range(ours.ndim_state):
            shift = step * np.eye(ours.ndim_state)[:, [place]]
            ends = [np.asarray(theirs.function(State(at + sign * shift)), dtype=float) for sign in (1, -1)]
            differences[:, place] = ((ends[0] - ends[1]) / (2 * step))[:, 0]
        found = ours.jacobian(State(at))
        largest = np.abs(found).max(axis=1, keepdims=True)
        np.testing.assert_allclose(found / largest, differences / largest, rtol=0, atol=1e-6)

    def test_second_derivatives_are_those_of_the_first_by_central_differences(self, name: str) -> None:
        ours, _ = made(name)
        at, step = states(1, ours), 0.05
        differences = np.empty((ours.ndim_meas, ours.ndim_state, ours.ndim_state))
        for place in range(ours.ndim_state):
            shift = step * np.eye(ours.ndim_state)[:, [place]]
            ends = [ours.jacobian(State(at + sign * shift)) for sign in (1, -1)]
            differences[:, :, place] = (ends[0] - ends[1]) / (2 * step)
        found = ours.hessian(State(at))
        largest = np.abs(found).max(axis=(1, 2), keepdims=True)
        np.testing.assert_allclose(found / largest, differences / largest, rtol=0, atol=1e-6)


@pytest.mark.parametrize("name", REVERSIBLE)
def test_the_inverse_of_many_plots_at_once_leads_back_to_them(name: str) -> None:
    ours, theirs = made(name)
    measured = ours.function(State(states(5, ours)))
    found = ours.inverse_function(Detection(measured))
    assert isinstance(found, StateVectors)
    np.testing.assert_allclose(
        np.asarray(ours.function(State(found)), dtype=float), np.asarray(measured, dtype=float), rtol=1e-9, atol=1e-9
    )
    one = Detection(measured[:, [2]])
    assert isinstance(ours.inverse_function(one), StateVector)
    if hasattr(theirs, "inverse_function"):
        inverse = np.asarray(theirs.inverse_function(one), dtype=float)
        np.testing.assert_allclose(ours.inverse_function(one), inverse, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("model", made("plane", rotation_offset=StateVector(TILTED), noise_covar=noise(0.01, 10.0)))
def test_plots_of_a_tilted_sensor_in_the_plane_are_not_converted(model: Any) -> None:
    truth, prediction = predicted(model, 1, 100.0, 10.0)
    [plot] = detections(model, [truth], 1)
    hypothesis = SingleHypothesis(prediction, plot)
    for convert in (
        lambda: stone_soup.OnePlotInitiator(prior(model)).initiate({plot}, TIME),
        lambda: [*stone_soup.DebiasingFeeder([(TIME, {plot})])],
        lambda: stone_soup.DecorrelatedUpdater().update(hypothesis),
    ):
        with pytest.raises(ValueError, match="rotation_offset must be about the z axis alone"):
            convert()
    assert stone_soup.SecondOrderUpdater().update(hypothesis).mean.shape == prediction.mean.shape


def test_a_sensor_in_the_plane_that_is_tilted_is_refused_where_it_has_no_inverse() -> None:
    tilted, _ = made("plane", rotation_offset=StateVector(TILTED))
    with pytest.raises(ValueError, match="rotation_offset must be about the z axis alone"):
        tilted.inverse_function(Detection(StateVector([[0.1], [1000.0]])))
    moving, _ = made("plane, rate", rotation_offset=StateVector(TILTED))
    with pytest.raises(ValueError, match="rotation_offset must be about the z axis alone"):
        moving.jacobian(State(states(1, moving)))


FAR, ANGLE = 1e5, np.deg2rad(3.0)
FAR_NOISE = {
    "plane": noise(ANGLE, 50), "space": noise(ANGLE, ANGLE, 50),
    "plane, rate": noise(ANGLE, 50, 1), "space, rate": noise(ANGLE, ANGLE, 50, 1),
}  # fmt: skip
SPEED = 100.0


def far_targets(model: Any, count: int, seed: int) -> Any:
    """Anywhere at 100 km from the sensor, but not near its vertical, at speeds that the prior state says."""
    generator = np.random.default_rng(seed)
    axes = len(model.mapping)
    ways = generator.standard_normal((count, axes)) * np.array([1.0, 1.0, 0.3])[:axes]
    ways *= FAR / np.linalg.norm(ways, axis=1, keepdims=True)
    turned = ways @ np.asarray(model.rotation_matrix, dtype=float)[:axes, :axes]
    found = np.zeros((count, model.ndim_state))
    found[:, list(model.mapping)] = turned + np.asarray(model.translation_offset, dtype=float)[:axes, 0]
    found[:, [place + 1 for place in model.mapping]] = SPEED * generator.standard_normal((count, axes))
    return found


def prior(model: Any) -> GaussianState:
    return GaussianState(np.zeros((model.ndim_state, 1)), SPEED**2 * np.eye(model.ndim_state), timestamp=TIME)


def average_nees(initiator: Any, plots: Any, truths: Any, places: Any) -> float:
    owners = dict(zip(plots, truths, strict=True))
    tracks = initiator.initiate(set(plots), TIME)
    assert len(tracks) == len(plots)
    found = [nees(t.mean, t.covar, owners[t.state.hypothesis.measurement], places) for t in tracks]
    return float(np.mean(found))


@pytest.mark.parametrize("name", FAR_NOISE)
@pytest.mark.parametrize("method", ["posterior", "unbiased"])
def test_the_first_state_has_the_covariance_of_its_errors(name: str, method: str) -> None:
    _, model = made(name, noise_covar=FAR_NOISE[name])
    truths = far_targets(model, 600, 7)
    plots = detections(model, truths, 8)
    everything = [*range(model.ndim_state)]
    found = average_nees(stone_soup.OnePlotInitiator(prior(model), method=method), plots, truths, everything)
    assert 0.85 < found < 1.2  # of 600; the deviation is about 0.05


def test_stone_soups_own_first_state_has_not() -> None:
    """So that what is measured above is known to be able to fail."""
    _, model = made("plane", noise_covar=FAR_NOISE["plane"])
    truths = far_targets(model, 600, 7)
    plots = detections(model, truths, 8)
    assert average_nees(SimpleMeasurementInitiator(prior(model)), plots, truths, [0, 2]) > 6


def test_a_range_rate_narrows_the_velocity_along_the_line_of_sight() -> None:
    _, model = made("space, rate", noise_covar=noise(1e-3, 1e-3, 5, 1))
    truths = far_targets(model, 1, 3)
    [track] = stone_soup.OnePlotInitiator(prior(model)).initiate(set(detections(model, truths, 4)), TIME)
    line = truths[0][[0, 2, 4]] - SHIFT[:, 0]
    line /= np.linalg.norm(line)
    velocities = np.asarray(track.covar, dtype=float)[np.ix_([1, 3, 5], [1, 3, 5])]
    across = np.cross(line, [0.0, 0.0, 1.0])
    assert np.sqrt(line @ velocities @ line) < 1.1
    assert np.sqrt(across @ velocities @ across / (across @ across)) == pytest.approx(SPEED, rel=1e-3)


def test_what_the_errors_of_range_and_range_rate_have_in_common_is_used_once() -> None:
    """As our own first state of a track, which is exact, has it: the sensor at rest at the origin, not turned."""
    correlated = np.array(noise(0.002, 50, 2), dtype=float)
    correlated[1, 2] = correlated[2, 1] = 0.6 * 50 * 2
    model = nonlinear.CartesianToBearingRangeRate2D(**PLANE, noise_covar=correlated)
    plot = StateVector([[0.4], [3e4], [-70.0]])
    detection = Detection(plot, timestamp=TIME, measurement_model=model)
    [track] = stone_soup.OnePlotInitiator(prior(model)).initiate({detection}, TIME)
    measured = {"r": 3e4, "azimuth": 0.4, "range_rate": -70.0, "range_std": 50.0, "azimuth_std": 0.002}
    exact = rt.initiate.one_plot("polar_doppler", measured | {"range_rate_std": 2.0, "correlation": 0.6}, SPEED)
    order = [0, 2, 1, 3]
    deviations = np.sqrt(np.diagonal(exact.covariance))
    differences = (np.asarray(track.covar, dtype=float)[np.ix_(order, order)] - exact.covariance) / np.outer(
        deviations, deviations
    )
    assert np.abs(differences).max() < 0.01
    assert np.abs((np.asarray(track.mean, dtype=float)[order, 0] - exact.mean) / deviations).max() < 0.01


def test_detections_that_are_no_plots_start_tracks_as_in_stone_soup() -> None:
    linear = LinearGaussian(4, (0, 2), noise(3, 4))
    detection = Detection(StateVector([[10.0], [20.0]]), timestamp=TIME, measurement_model=linear)
    ours, theirs = (
        initiator(prior(linear)).initiate({detection}, TIME).pop()
        for initiator in (stone_soup.OnePlotInitiator, SimpleMeasurementInitiator)
    )
    np.testing.assert_array_equal(ours.covar, theirs.covar)
    with pytest.raises(ValueError, match="measurement_model must be given"):
        stone_soup.OnePlotInitiator(prior(linear)).initiate({Detection(StateVector([[1.0], [2.0]]))}, TIME)
    with pytest.raises(ValueError, match="method must be one of"):
        stone_soup.OnePlotInitiator(prior(linear), method="linear")


def test_correlations_that_the_conversion_has_not_are_refused() -> None:
    tied = np.array([[1e-4, 5e-5], [5e-5, 1e-4]])
    covariance = np.zeros((3, 3))
    covariance[:2, :2], covariance[2, 2] = tied, 100.0
    _, model = made("space", noise_covar=covariance)
    plots = detections(model, far_targets(model, 1, 1), 1)
    with pytest.raises(ValueError, match=r"noise_covar must be without correlations but that of r and azimuth"):
        stone_soup.OnePlotInitiator(prior(model)).initiate(set(plots), TIME)


@pytest.mark.parametrize("sign", [-1, 1])
def test_errors_that_are_one_but_for_rounding_count_as_one(sign: int) -> None:
    variances = 2e-6, 700.0
    both = sign * math.sqrt(variances[0] * variances[1])
    assert abs(both) > math.sqrt(variances[0]) * math.sqrt(variances[1])
    model = nonlinear.CartesianToBearingRange(4, (0, 2), np.array([[variances[0], both], [both, variances[1]]]))
    detection = Detection(StateVector([[0.4], [3e4]]), timestamp=TIME, measurement_model=model)
    [track] = stone_soup.OnePlotInitiator(prior(model)).initiate({detection}, TIME)
    exact = rt.convert.polar(3e4, 0.4, 700.0**0.5, 2e-6**0.5, float(sign), "posterior")
    np.testing.assert_array_equal(np.asarray(track.covar, float)[::2, ::2], exact.covariance)


def test_a_noise_that_is_no_covariance_is_refused() -> None:
    model = nonlinear.CartesianToBearingRange(4, (0, 2), np.array([[1e-4, 2.0], [2.0, 100.0]]))
    detection = Detection(StateVector([[0.4], [3e4]]), timestamp=TIME, measurement_model=model)
    with pytest.raises(ValueError, match="noise_covar must be positive semidefinite"):
        stone_soup.OnePlotInitiator(prior(model)).initiate({detection}, TIME)


class Scans(DetectionFeeder):
    """A reader of what it is handed."""

    def data_gen(self) -> Any:
        yield from self.reader


@pytest.mark.parametrize("name", FAR_NOISE)
def test_a_scan_becomes_gaussian_detections_whose_models_measure_their_states(name: str) -> None:
    _, model = made(name, noise_covar=FAR_NOISE[name])
    truths = far_targets(model, 300, 17)
    plots = detections(model, truths, 18)
    owners = {plot.state_vector[0, 0]: truth for plot, truth in zip(plots, truths, strict=True)}
    for plot in plots:
        plot.metadata["first"] = plot.state_vector[0, 0]
    [(time, found)] = stone_soup.DebiasingFeeder([(TIME, set(plots))])
    assert time == TIME
    assert len(found) == len(plots)
    errors = []
    for detection in found:
        assert isinstance(detection, GaussianDetection)
        truth = State(StateVector(owners[detection.metadata["first"]]))
        error = np.asarray(detection.state_vector - detection.measurement_model.function(truth), dtype=float)[:, 0]
        np.testing.assert_array_equal(detection.covar, detection.measurement_model.covar())
        errors.append(error @ np.linalg.solve(np.asarray(detection.covar), error) / len(error))
    assert 0.8 < np.mean(errors) < 1.25  # of 300; the deviation is about 0.07


def test_the_feeder_keeps_what_a_detection_is_and_passes_what_is_no_plot() -> None:
    _, model = made("plane")
    path = GroundTruthPath()
    vector = StateVector([[0.2], [5e3]])
    common = {"timestamp": TIME, "measurement_model": model}
    linear = Detection(vector, timestamp=TIME, measurement_model=LinearGaussian(4, (0, 2), noise(1, 1)))
    scan = {TrueDetection(vector, groundtruth_path=path, **common), Clutter(vector, **common), linear}
    [(_, found)] = stone_soup.DebiasingFeeder([(TIME, scan)])
    kinds = {type(detection): detection for detection in found}
    assert kinds[stone_soup.DebiasedTrueDetection].groundtruth_path is path
    assert isinstance(kinds[stone_soup.DebiasedClutter], Clutter)
    assert kinds[Detection] is linear


def test_what_a_feeder_makes_goes_through_stone_soups_own_kalman_updater() -> None:
    _, model = made("space")
    plots = detections(model, far_targets(model, 1, 2), 3)
    [(_, [detection])] = stone_soup.DebiasingFeeder([(TIME, set(plots))])
    start = GaussianStatePrediction(
        detection.measurement_model.matrix().T @ detection.state_vector, 1e6 * np.eye(6), timestamp=TIME
    )
    updated = KalmanUpdater().update(SingleHypothesis(start, detection))
    np.testing.assert_allclose(updated.mean, start.mean, rtol=1e-12)


@pytest.mark.parametrize("name", ["plane, rate", "space, rate"])
def test_position_and_range_rate_has_the_derivatives_of_its_function_and_an_inverse(name: str) -> None:
    _, model = made(name)
    [(_, [detection])] = stone_soup.DebiasingFeeder([(TIME, set(detections(model, far_targets(model, 1, 2), 3)))])
    product = detection.measurement_model
    at = states(1, product)
    shifts = 0.5 * np.eye(product.ndim_state)
    ends = [[product.function(State(at + sign * shift[:, np.newaxis])) for shift in shifts] for sign in (1, -1)]
    differences = np.hstack([up - down for up, down in zip(*ends, strict=True)])
    np.testing.assert_allclose(product.jacobian(State(at)), differences, rtol=1e-7, atol=1e-6)
    turned = [
        product.jacobian(State(at + shift[:, np.newaxis])) - product.jacobian(State(at - shift[:, np.newaxis]))
        for shift in shifts
    ]
    np.testing.assert_allclose(product.hessian(State(at)), np.stack(turned, axis=-1), atol=1e-9)
    back = product.function(State(product.inverse_function(detection)))
    np.testing.assert_allclose(back, detection.state_vector, rtol=1e-9)


def predicted(model: Any, seed: int, position_std: float, speed_std: float) -> tuple[Any, GaussianStatePrediction]:
    """A truth, and a prediction whose errors have its covariance, with correlations."""
    generator = np.random.default_rng(seed)
    truth = far_targets(model, 1, seed)[0]
    scale = np.full(model.ndim_state, speed_std)
    scale[list(model.mapping)] = position_std
    root = scale[:, np.newaxis] * (np.eye(model.ndim_state) + 0.3 * generator.standard_normal((model.ndim_state,) * 2))
    mean = truth + root @ generator.standard_normal(model.ndim_state)
    return truth, GaussianStatePrediction(StateVector(mean), root @ root.T, timestamp=TIME)


def updated_nees(updater: Any, name: str, count: int) -> float:
    _, model = made(name, noise_covar=FAR_NOISE[name])
    found = []
    for seed in range(count):
        truth, prediction = predicted(model, 100 + seed, 3000.0, 30.0)
        [plot] = detections(model, [truth], seed)
        state = updater.update(SingleHypothesis(prediction, plot))
        assert state.hypothesis.measurement is plot
        found.append(nees(state.mean, state.covar, truth, [*range(model.ndim_state)]))
    return float(np.mean(found))


@pytest.mark.parametrize("updater", [stone_soup.SecondOrderUpdater, stone_soup.DecorrelatedUpdater])
@pytest.mark.parametrize("name", ["plane", "space, rate"])
def test_an_update_where_angles_are_poor_has_the_covariance_of_its_errors(name: str, updater: Any) -> None:
    assert 0.75 < updated_nees(updater(), name, 150) < 1.3


def test_the_extended_update_of_first_order_has_not() -> None:
    assert updated_nees(ExtendedKalmanUpdater(), "plane", 150) > 2


def test_the_second_order_expects_what_sigma_points_expect_of_a_gentle_curvature() -> None:
    """The unscented transform agrees to the second order; where the first order is off by the shift, it is not."""
    _, model = made("space, rate")
    _, prediction = predicted(model, 1, 1500.0, 30.0)
    ours = stone_soup.SecondOrderUpdater().predict_measurement(prediction, model)
    sigma = UnscentedKalmanUpdater(alpha=1.0, kappa=0.0, beta=0.0).predict_measurement(prediction, model)
    first = ExtendedKalmanUpdater().predict_measurement(prediction, model)
    scale = np.sqrt(np.diagonal(np.asarray(sigma.covar, dtype=float)))[:, np.newaxis]
    shift = np.abs(np.asarray(ours.state_vector - sigma.state_vector, dtype=float) / scale).max()
    assert shift < 0.2 * np.abs(np.asarray(first.state_vector - sigma.state_vector, dtype=float) / scale).max()


@pytest.mark.parametrize("updater", [stone_soup.SecondOrderUpdater, stone_soup.DecorrelatedUpdater])
@pytest.mark.parametrize("along", [30.0, 3e3, 1e5])
@pytest.mark.parametrize("angle", [1e-1, 1e-3, 1e-5, 1e-7])
def test_josephs_form_is_the_same_update_however_unlike_metres_and_radians_are(
    updater: Any, along: float, angle: float
) -> None:
    """A target that is known across the line of sight, and hardly along it: squared, 1e5 m beside 1e-7 rad is 1e24."""
    _, model = made("space, rate", noise_covar=noise(angle, angle, 10.0, 1.0))
    truth, prediction = predicted(model, 1, 3.0, 3.0)
    sight = (truth[[0, 2, 4]] - SHIFT[:, 0]) / np.linalg.norm(truth[[0, 2, 4]] - SHIFT[:, 0])
    spread = np.array(prediction.covar, dtype=float)
    spread[np.ix_([0, 2, 4], [0, 2, 4])] += along**2 * np.outer(sight, sight)
    believed = GaussianStatePrediction(prediction.state_vector, CovarianceMatrix(spread), timestamp=TIME)
    [plot] = detections(model, [truth], 1)
    plain, joseph = (
        updater(use_joseph_cov=joseph).update(SingleHypothesis(believed, plot)) for joseph in (False, True)
    )
    deviations = np.sqrt(np.diag(np.asarray(plain.covar, dtype=float)))
    np.testing.assert_allclose(
        joseph.mean / deviations[:, np.newaxis], plain.mean / deviations[:, np.newaxis], rtol=1e-4
    )
    scale = np.outer(deviations, deviations)
    np.testing.assert_allclose(joseph.covar / scale, plain.covar / scale, atol=1e-3)


def test_models_without_known_curvature_are_refused_by_name() -> None:
    model = nonlinear.CartesianToAzimuthElevationRange(**SPACE, noise_covar=noise(0.1, 0.1, 1))
    _, prediction = predicted(made("space")[1], 1, 100.0, 1.0)
    with pytest.raises(
        TypeError, match=r"the measurement model must be one of .*; got CartesianToAzimuthElevationRange"
    ):
        stone_soup.SecondOrderUpdater().predict_measurement(prediction, model)


def test_stone_soup_finds_the_plugin() -> None:
    if not [one for one in entry_points(group="stonesoup.plugins") if one.name == "radartrack"]:
        pytest.skip("the package was installed before it had this entry point")
    import_module("stonesoup.plugins")
    assert import_module("stonesoup.plugins.radartrack") is stone_soup
