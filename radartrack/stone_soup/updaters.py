"""Updaters that know the curvature of a measurement, and the bias of weights that a plot computes of itself."""

from functools import lru_cache
from typing import Any

import numpy as np
from stonesoup.types.array import CovarianceMatrix, StateVector
from stonesoup.types.prediction import MeasurementPrediction
from stonesoup.types.state import State
from stonesoup.types.update import Update
from stonesoup.updater.kalman import ExtendedKalmanUpdater

from radartrack._arrays.validation import RealArray
from radartrack.stone_soup.model_geometry import Geometry
from radartrack.stone_soup.plot_conversion import converted, is_plot, model_of, read_plots
from radartrack.stone_soup.second_moments import Moments, moments


class SecondOrderUpdater(ExtendedKalmanUpdater):
    """The second-order extended Kalman filter: curvature moves what is expected, and counts as noise.

    Takes Stone Soup's measurement models, and ours.

    Source: Bar-Shalom, Willett & Tian 2011, second-order extended Kalman filter.
    """

    @lru_cache  # noqa: B019 - as in Stone Soup: hypothesisers ask again for each detection
    def predict_measurement(
        self,
        predicted_state: Any,
        measurement_model: Any = None,
        measurement_noise: bool = True,  # noqa: FBT001, FBT002 - as in Stone Soup
        **kwargs: Any,
    ) -> Any:
        """What will be measured, with its covariance.

        Raises:
            TypeError: the model has no second derivatives that we know.
        """
        model = self._check_measurement_model(measurement_model)
        seen = moments(model, predicted_state.mean, predicted_state.covar)
        expected = model.function(predicted_state, **kwargs) + seen.shift[:, np.newaxis]
        across = predicted_state.covar @ seen.jacobian.T
        innovation = seen.jacobian @ across + seen.spread + (model.covar(**kwargs) if measurement_noise else 0)
        return MeasurementPrediction.from_state(
            predicted_state, expected, innovation.view(CovarianceMatrix), cross_covar=across
        )

    def _posterior_covariance(self, hypothesis: Any) -> Any:
        """As Stone Soup's; in Joseph's form the noise is all of the innovation that the Jacobian does not explain."""
        if not self.use_joseph_cov:
            return super()._posterior_covariance(hypothesis)
        prediction, expected = hypothesis.prediction, hypothesis.measurement_prediction
        model = self._check_measurement_model(hypothesis.measurement.measurement_model)
        jacobian = moments(model, prediction.mean, prediction.covar).jacobian
        gain = np.linalg.solve(expected.covar, expected.cross_covar.T).T
        left = np.eye(prediction.ndim) - gain @ jacobian
        noise = expected.covar - jacobian @ expected.cross_covar
        return (left @ prediction.covar @ left.T + gain @ noise @ gain.T).view(CovarianceMatrix), gain


class DecorrelatedUpdater(SecondOrderUpdater):
    """The converted-measurement Kalman filter whose weights do not depend on the error of the plot that they weigh.

    A plot is converted without bias, and its covariance is that averaged over the prediction. What is predicted for
    association is the plot itself, as of the second-order filter. Detections that are no plots are updated as there.

    Source: Bordonaro, Willett & Bar-Shalom 2014, decorrelated unbiased converted measurement.
    """

    def update(self, hypothesis: Any, **kwargs: Any) -> Any:
        """Update a prediction with a plot.

        Raises:
            ValueError: the plot or the prediction of it is out of place for the conversion.
        """
        detection, prediction = hypothesis.measurement, hypothesis.prediction
        model = self._check_measurement_model(detection.measurement_model)
        if not is_plot(model):
            return super().update(hypothesis, **kwargs)
        plots = read_plots([detection], [model])
        means, covariances = converted(plots, "decorrelated", _predicted(model, prediction))
        position = model_of(model, plots.geometries[0], covariances[0])
        mean, covariance = _updated(position, means[0], prediction)
        return Update.from_state(
            prediction,
            mean.view(StateVector),
            CovarianceMatrix(covariance),
            timestamp=detection.timestamp,
            hypothesis=hypothesis,
        )


def _predicted(model: Any, prediction: Any) -> tuple[RealArray, RealArray]:
    """Mean and covariance of the quantities that a plot measures, in the order of the conversion, without its noise."""
    geometry = Geometry.of(model)
    seen: Moments = moments(model, prediction.mean, prediction.covar)
    covariance = seen.jacobian @ np.asarray(prediction.covar, dtype=np.float64) @ seen.jacobian.T + seen.spread
    sensor = geometry.sensor
    places = [geometry.outputs.index(name) for name in sensor.coordinates] if sensor is not None else []
    mean = geometry.measurement(prediction.mean) + seen.shift
    return mean[places][np.newaxis], covariance[np.ix_(places, places)][np.newaxis]


def _updated(model: Any, measured: RealArray, prediction: Any) -> tuple[RealArray, RealArray]:
    mean = np.asarray(prediction.mean, dtype=np.float64)
    P = np.asarray(prediction.covar, dtype=np.float64)
    shift, jacobian, spread = moments(model, mean, P)
    expected = np.asarray(model.function(State(mean.view(StateVector))), dtype=np.float64)[:, 0] + shift
    across = P @ jacobian.T
    innovation = jacobian @ across + spread + np.asarray(model.covar())
    gain = np.linalg.solve(innovation, across.T).T
    reduced = P - gain @ innovation @ gain.T
    return mean + (gain @ (measured - expected))[:, np.newaxis], (reduced + reduced.T) / 2
