"""How plots are to be converted: by which formulas, with which prediction, and with the azimuth from which axis."""

import reprlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Self

from numpy.typing import ArrayLike

from radartrack._arrays.validation import RealArray
from radartrack._conversion.prediction import Prediction, prediction_arguments
from radartrack._conversion.sensors import AzimuthFrom, Sensor

NEEDS_PREDICTION = "decorrelated"


@dataclass(frozen=True, slots=True)
class Way:
    """What was asked for, in words that were checked.

    Attributes:
        sensor: what is measured, and the formulas for it.
        method: which mean and covariance.
        prediction: the two parts of a prediction as they were given, by name; empty without one.
        turned: whether the formulas count the azimuth from the other axis.
    """

    sensor: Sensor
    method: str
    prediction: Mapping[str, ArrayLike]
    turned: bool

    @classmethod
    def chosen(
        cls, sensor: Sensor, method: str, predicted: Prediction | None, azimuth_from: AzimuthFrom | None
    ) -> Self:
        """Check the words.

        Raises:
            TypeError, ValueError: a word is none of those allowed, or a prediction is missing or not needed.

        """
        turned = sensor.is_turned(azimuth_from)
        if method == NEEDS_PREDICTION:
            return cls(sensor, method, prediction_arguments(predicted), turned)
        if predicted is not None:
            raise ValueError(f"predicted must be None for method {method!r}; got {reprlib.repr(predicted)}")
        return cls(sensor, method, {}, turned)

    @property
    def function(self) -> str:
        """The name of the generated conversion; what averages over a prediction has the mean of another method."""
        return f"{self.sensor.module}_{'unbiased' if self.method == NEEDS_PREDICTION else self.method}"

    def oriented(self, mean: RealArray, covariance: RealArray) -> tuple[RealArray, RealArray]:
        """Mean and covariance with x and y exchanged, where the azimuth is counted from the other axis."""
        if not self.turned:
            return mean, covariance
        order = [1, 0, *range(2, mean.shape[-1])]
        return mean[..., order], covariance[..., order, :][..., order]
