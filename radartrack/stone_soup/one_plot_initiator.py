"""Tracks from one detection each."""

from typing import Any, Literal, get_args

import numpy as np
from stonesoup.base import Property
from stonesoup.initiator.base import GaussianInitiator
from stonesoup.initiator.simple import SimpleMeasurementInitiator
from stonesoup.models.measurement import MeasurementModel
from stonesoup.types.array import CovarianceMatrix, StateVector
from stonesoup.types.hypothesis import SingleHypothesis
from stonesoup.types.state import GaussianState
from stonesoup.types.track import Track
from stonesoup.types.update import Update

from radartrack._arrays.validation import RealArray, one_of
from radartrack.stone_soup.model_geometry import Geometry
from radartrack.stone_soup.plot_conversion import Plots, converted, is_plot, read_plots, without_rate
from radartrack.stone_soup.scan import by_kind, model_for
from radartrack.stone_soup.second_moments import moments

StartMethod = Literal["unbiased", "posterior"]


class OnePlotInitiator(GaussianInitiator):
    """Starts tracks as Stone Soup's `SimpleMeasurementInitiator`, with covariances that hold at any angle error.

    The position is that of our conversion, whose covariance is exact; the other components are those of the prior
    state. A range rate is then used by a second-order extended update, with what its error has in common with that of
    the range. Detections of models that measure no position, or are linear, go to Stone Soup's initiator.

    Source: Duan et al. 2004 ("posterior"), Mo et al. 1998 ("unbiased").
    """

    prior_state: GaussianState = Property(doc="What is known of a state before; its position is replaced")
    measurement_model: MeasurementModel = Property(
        default=None, doc="Measurement model. Can be left as None if all detections have one."
    )
    method: str = Property(default="posterior", doc='"posterior" or "unbiased": the conversion of the position')
    skip_non_reversible: bool = Property(default=False, doc="Whether other detections start no track")

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        one_of("method", self.method, get_args(StartMethod))

    def initiate(self, detections: Any, timestamp: Any, **kwargs: Any) -> set[Any]:
        """A track for each detection; all detections of one kind are converted in one batch.

        Raises:
            ValueError: a detection has no measurement model, or is out of place for the conversion.
        """
        tracks: set[Any] = set()
        for group in by_kind(detections, self.measurement_model):
            models = [model_for(detection, self.measurement_model) for detection in group]
            if not is_plot(models[0]):
                simple = SimpleMeasurementInitiator(self.prior_state, self.measurement_model, self.skip_non_reversible)
                tracks |= simple.initiate(set(group), timestamp, **kwargs)
                continue
            plots = read_plots(group, models)
            positions = converted(without_rate(plots), self.method)
            for number, detection in enumerate(group):
                state = self._start(plots.geometries[number], *(part[number] for part in positions))
                if "range_rate" in plots.measured:
                    state = _with_rate(*state, models[number], plots, number)
                tracks.add(Track([self._update(detection, *state)]))
        return tracks

    def _start(self, geometry: Geometry, mean: RealArray, covariance: RealArray) -> tuple[RealArray, RealArray]:
        places = geometry.places[: geometry.axes]
        state = np.array(self.prior_state.state_vector, dtype=np.float64).reshape(-1)
        spread = np.array(self.prior_state.covar, dtype=np.float64)
        spread[places, :] = spread[:, places] = 0
        state[places], spread[np.ix_(places, places)] = mean, covariance
        return state, spread

    def _update(self, detection: Any, mean: RealArray, covariance: RealArray) -> Any:
        return Update.from_state(
            self.prior_state,
            state_vector=StateVector(mean),
            covar=CovarianceMatrix(covariance),
            hypothesis=SingleHypothesis(None, detection),
            timestamp=detection.timestamp,
        )


def _with_rate(
    mean: RealArray, covariance: RealArray, model: Any, plots: Plots, number: int
) -> tuple[RealArray, RealArray]:
    """A second-order extended update with the range rate of a plot whose range the state holds already.

    The error of the range rate is a multiple of that of the range, and one that is independent of it: what is new is
    the range rate less that multiple of the range.
    """
    plot = {name: float(values[number]) for name, values in plots.measured.items()}
    own_std, correlation = plot["range_rate_std"], plot["correlation"]
    multiple = correlation * own_std / plot["range_std"] if plot["range_std"] > 0 else 0.0
    geometry = plots.geometries[number]
    of = np.zeros(len(geometry.outputs))
    of[[geometry.outputs.index("range_rate"), geometry.outputs.index("r")]] = 1.0, -multiple
    shift, jacobian, spread = moments(model, mean, covariance)
    expected = of @ (geometry.measurement(mean) + shift)
    along = covariance @ jacobian.T @ of
    variance = of @ (jacobian @ along) + of @ spread @ of + own_std**2 * (1 - correlation**2)
    gain = along / variance
    reduced = covariance - variance * np.outer(gain, gain)
    return mean + gain * (plot["range_rate"] - multiple * plot["r"] - expected), (reduced + reduced.T) / 2
