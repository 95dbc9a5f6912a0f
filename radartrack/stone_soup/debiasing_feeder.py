"""Scans of plots, turned into Gaussian detections of positions."""

from collections.abc import Iterator
from typing import Any, Literal, get_args

from stonesoup.base import Property
from stonesoup.buffered_generator import BufferedGenerator
from stonesoup.feeder.base import DetectionFeeder
from stonesoup.models.measurement import MeasurementModel
from stonesoup.types.array import CovarianceMatrix, StateVector
from stonesoup.types.detection import Clutter, GaussianDetection, TrueDetection

from radartrack._arrays.validation import one_of
from radartrack.stone_soup.plot_conversion import converted, is_plot, model_of, read_plots
from radartrack.stone_soup.scan import by_kind, model_for

FeederMethod = Literal["linear", "second_order", "averaged", "unbiased", "posterior"]


class DebiasedTrueDetection(TrueDetection, GaussianDetection):
    """A converted plot that came from ground truth."""


class DebiasedClutter(Clutter, GaussianDetection):
    """A converted plot that came from nothing."""


class DebiasingFeeder(DetectionFeeder):
    """Converts the plots of each scan in one batch, so that linear filters can take them.

    A plot becomes a Gaussian detection of the position, with a linear measurement model; with a range rate, of the
    position and of the product of range and range rate, with the model `PositionAndRangeRate`. Its model, mean and
    covariance are in the axes of the state, so offset, rotation and velocity of the sensor are done with. Other
    detections pass as they are.

    Source: Mo et al. 1998 ("unbiased"), Duan et al. 2004 and 2005; the other methods as for `rt.convert.polar`.
    """

    method: str = Property(default="unbiased", doc="The conversion")
    measurement_model: MeasurementModel = Property(
        default=None, doc="Measurement model. Can be left as None if all detections have one."
    )

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        one_of("method", self.method, get_args(FeederMethod))

    @BufferedGenerator.generator_method
    def data_gen(self) -> Iterator[tuple[Any, set[Any]]]:
        """Times, with the detections of each."""
        for time, detections in self.reader:
            scan: set[Any] = set()
            for group in by_kind(detections, self.measurement_model):
                scan.update(self._debiased(group))
            yield time, scan

    def _debiased(self, group: list[Any]) -> list[Any]:
        models = [model_for(detection, self.measurement_model) for detection in group]
        if not is_plot(models[0]):
            return group
        plots = read_plots(group, models)
        means, covariances = converted(plots, self.method)
        return [
            _detection(detection, mean, covariance, model_of(model, geometry, covariance))
            for detection, mean, covariance, model, geometry in zip(
                group, means, covariances, models, plots.geometries, strict=True
            )
        ]


def _detection(plot: Any, mean: Any, covariance: Any, model: Any) -> Any:
    common = {
        "state_vector": StateVector(mean),
        "covar": CovarianceMatrix(covariance),
        "timestamp": plot.timestamp,
        "measurement_model": model,
        "metadata": plot.metadata,
    }
    if isinstance(plot, TrueDetection):
        return DebiasedTrueDetection(groundtruth_path=plot.groundtruth_path, **common)
    return (DebiasedClutter if isinstance(plot, Clutter) else GaussianDetection)(**common)
