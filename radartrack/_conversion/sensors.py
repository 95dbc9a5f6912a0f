"""What the measurement models are called in public, and which values their arguments may have."""

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Literal, NamedTuple, TypeAlias, get_args

import numpy as np

from radartrack._arrays.validation import (
    ANGLE,
    ANGLE_STD,
    CORRELATION,
    DIRECTION_COSINE,
    DIRECTION_COSINE_STD,
    ELEVATION,
    RANGE,
    RANGE_RATE,
    RANGE_RATE_STD,
    Domain,
    RealArray,
    broadcast_shape,
    one_of,
    require_within,
)

AzimuthFrom: TypeAlias = Literal["x", "y"]
SensorName: TypeAlias = Literal["polar", "spherical", "polar_doppler", "ruv"]

MARGIN = 5  # deviations; nearer to the edge of the unit circle the series are of no use
DIRECTION = Domain("", 0.999, 0.999, "at the edge of the unit circle the root has no derivative")


class Argument(NamedTuple):
    """A public argument: its symbol in the formulas, and the values it may have."""

    symbol: str
    domain: Domain


class Sensor(NamedTuple):
    """The public arguments of a measurement model, by name, and the formulas for it.

    Attributes:
        module: the name of the generated module.
        coordinates: what is measured.
        noise: the standard deviations of the coordinates, in their order, and a correlation.
        correlated: the places, among the coordinates, of the two whose errors that correlation joins.
        azimuth_from: where the formulas count the azimuth from; None without an azimuth.
        series: what the names of formulas end with that are series; empty for closed forms.
    """

    module: SensorName
    coordinates: Mapping[str, Argument]
    noise: Mapping[str, Argument]
    correlated: tuple[int, int]
    azimuth_from: AzimuthFrom | None
    series: str = ""

    @property
    def arguments(self) -> dict[str, Argument]:
        """All public arguments, in the order of those of the formulas."""
        return {**self.coordinates, **self.noise}

    @property
    def angles(self) -> tuple[int, ...]:
        """The places of the angles among the coordinates."""
        return tuple(
            place for place, (_, domain) in enumerate(self.coordinates.values()) if domain in {ANGLE, ELEVATION}
        )

    def is_turned(self, azimuth_from: AzimuthFrom | None) -> bool:
        """Whether the formulas count the azimuth from the other axis.

        Raises:
            TypeError, ValueError: the word is none of the two.

        """
        return (
            self.azimuth_from is not None
            and one_of("azimuth_from", azimuth_from, get_args(AzimuthFrom)) != self.azimuth_from
        )

    def read(self, plot: Mapping[str, RealArray]) -> dict[str, RealArray]:
        """Check the values of all arguments, by name; they are returned by symbol.

        Raises:
            ValueError: a value is out of place, or the shapes do not broadcast.

        """
        for name, (_, domain) in self.arguments.items():
            require_within(name, plot[name], domain)
        broadcast_shape(plot)
        values = {symbol: plot[name] for name, (symbol, _) in self.arguments.items()}
        self.require_possible(values)
        return values

    def require_possible(self, values: Mapping[str, RealArray] | Mapping[str, float], of: str = "") -> None:
        """Check what no argument says alone: that directions stay in the unit circle despite their errors.

        Args:
            values: by symbol; their shapes broadcast.
            of: what to add to the names of the arguments in a message.

        Raises:
            ValueError: they do not.

        """
        if "u" not in self.coordinates:
            return
        reach = np.hypot(values["u"], values["v"])
        reach = reach + MARGIN * np.maximum(values["sigma_u"], values["sigma_v"])
        name = f"sqrt(u^2 + v^2) + {MARGIN} max(u_std, v_std){of}"
        require_within(name, np.asarray(reach), DIRECTION)

    def evaluate(self, word: str, values: Mapping[str, RealArray]) -> RealArray:
        """Call a generated function with the values, by symbol, that it takes."""
        formulas = import_module(f"radartrack.generated.{self.module}")
        named = word if hasattr(formulas, word) else f"{word}{self.series}"
        function: Callable[..., RealArray] = getattr(formulas, named)
        if word == "map":
            return function(**{symbol: values[symbol] for symbol, _ in self.coordinates.values()})
        return function(**values)


_RANGE = Argument("r", RANGE)
_RANGE_STD = Argument("sigma_r", RANGE)
_AZIMUTH = Argument("beta", ANGLE)
_AZIMUTH_STD = Argument("sigma_beta", ANGLE_STD)
_CORRELATION = Argument("rho", CORRELATION)

SENSORS: Mapping[SensorName, Sensor] = {
    "polar": Sensor(
        module="polar",
        coordinates={"r": _RANGE, "azimuth": _AZIMUTH},
        noise={"range_std": _RANGE_STD, "azimuth_std": _AZIMUTH_STD, "correlation": _CORRELATION},
        correlated=(0, 1),
        azimuth_from="x",
    ),
    "spherical": Sensor(
        module="spherical",
        coordinates={"r": _RANGE, "azimuth": _AZIMUTH, "elevation": Argument("epsilon", ELEVATION)},
        noise={
            "range_std": _RANGE_STD,
            "azimuth_std": _AZIMUTH_STD,
            "elevation_std": Argument("sigma_epsilon", ANGLE_STD),
            "correlation": _CORRELATION,
        },
        correlated=(0, 1),
        azimuth_from="y",
    ),
    "polar_doppler": Sensor(
        module="polar_doppler",
        coordinates={"r": _RANGE, "azimuth": _AZIMUTH, "range_rate": Argument("rdot", RANGE_RATE)},
        noise={
            "range_std": _RANGE_STD,
            "azimuth_std": _AZIMUTH_STD,
            "range_rate_std": Argument("sigma_rdot", RANGE_RATE_STD),
            "correlation": _CORRELATION,
        },
        correlated=(0, 2),
        azimuth_from="x",
    ),
    "ruv": Sensor(
        module="ruv",
        coordinates={
            "r": _RANGE,
            "u": Argument("u", DIRECTION_COSINE),
            "v": Argument("v", DIRECTION_COSINE),
        },
        noise={
            "range_std": _RANGE_STD,
            "u_std": Argument("sigma_u", DIRECTION_COSINE_STD),
            "v_std": Argument("sigma_v", DIRECTION_COSINE_STD),
            "correlation": _CORRELATION,
        },
        correlated=(1, 2),
        azimuth_from=None,
        series="_semidefinite",
    ),
}
