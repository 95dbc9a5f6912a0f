"""What the measurement models are called in public, and which values their arguments may have."""

from collections.abc import Callable, Iterator, Mapping
from importlib import import_module
from types import MappingProxyType
from typing import Literal, NamedTuple, TypeAlias, get_args

import numpy as np

from radartrack._arrays.validation import (
    ANGLE,
    ANGLE_STD,
    CORRELATION,
    DIRECTION_COSINE,
    DIRECTION_COSINE_STD,
    ELEVATION,
    PATH,
    PATH_AZIMUTH_STD,
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
SensorName: TypeAlias = Literal["polar", "spherical", "polar_doppler", "spherical_doppler", "ruv", "bistatic"]

MARGIN = 5  # deviations; nearer to where a map has no derivative its series are of no use
DIRECTION = Domain("", 0.999, 0.999, "at the edge of the unit circle the root has no derivative")
TRIANGLE = Domain("", 0.999, 0.999, "a path as short as the baseline has no target off it")
ROUND_THE_BASELINE = Domain("", 1.0, 1.0, "over a larger angle near the baseline the range is no power series")


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
        parameters: what the map takes beside the coordinates, which is known without error.
    """

    module: SensorName
    coordinates: Mapping[str, Argument]
    noise: Mapping[str, Argument]
    correlated: tuple[int, int]
    azimuth_from: AzimuthFrom | None
    series: str = ""
    parameters: Mapping[str, Argument] = MappingProxyType({})

    @property
    def arguments(self) -> dict[str, Argument]:
        """All public arguments, in the order of those of the formulas."""
        return {**self.coordinates, **self.parameters, **self.noise}

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

    def chosen_axis(self, azimuth_from: AzimuthFrom | None) -> AzimuthFrom | None:
        """Where the azimuth is counted from, which is where the formulas count it from if nothing is said.

        Raises:
            TypeError, ValueError: the word is none of the two, or there is no azimuth.

        """
        return chosen_axis(self.module, self.azimuth_from, azimuth_from)

    def cartesian(self, measured: RealArray, known: Mapping[str, float], azimuth_from: AzimuthFrom | None) -> RealArray:
        """The map of measured quantities along the last axis, with the parameters by name."""
        values = dict(zip(self.coordinates, np.moveaxis(measured, -1, 0), strict=True))
        values |= {name: np.asarray(value) for name, value in known.items()}
        named = {symbol: values[name] for name, (symbol, _) in {**self.coordinates, **self.parameters}.items()}
        found = self.evaluate("map", named)
        return found[..., [1, 0, *range(2, found.shape[-1])]] if self.is_turned(azimuth_from) else found

    def read(self, plot: Mapping[str, RealArray]) -> dict[str, RealArray]:
        """Check the values of all arguments, by name; they are returned by symbol.

        Raises:
            ValueError: a value is out of place, or the shapes do not broadcast.

        """
        for name, (_, domain) in self.arguments.items():
            require_within(name, plot[name], domain)
        broadcast_shape(plot)
        values = self.by_symbol(plot)
        self.require_possible(values)
        return values

    def by_symbol(self, plot: Mapping[str, RealArray]) -> dict[str, RealArray]:
        """The values of all arguments, which are given by name."""
        return {symbol: plot[name] for name, (symbol, _) in self.arguments.items()}

    def require_possible(self, values: Mapping[str, RealArray] | Mapping[str, float], of: str = "") -> None:
        """Check what no argument says alone: that errors do not take a plot to where the map has no derivative.

        Args:
            values: by symbol; their shapes broadcast.
            of: what to add to the names of the arguments in a message.

        Raises:
            ValueError: they do.

        """
        for name, array, domain in self.conditions(values, of):
            require_within(name, array, domain)

    def conditions(
        self, values: Mapping[str, RealArray] | Mapping[str, float], of: str = ""
    ) -> Iterator[tuple[str, RealArray, Domain]]:
        """What `require_possible` checks: the name, the values and the interval of each quantity."""
        if "u" in self.coordinates:
            yield _reach(values, of)
        if "path" in self.coordinates:
            yield from _of_triangle(values, of)

    def evaluate(self, word: str, values: Mapping[str, RealArray]) -> RealArray:
        """Call a generated function with the values, by symbol, that it takes."""
        formulas = import_module(f"radartrack.generated.{self.module}")
        named = word if hasattr(formulas, word) else f"{word}{self.series}"
        function: Callable[..., RealArray] = getattr(formulas, named)
        if word == "map":
            measured = (*self.coordinates.values(), *self.parameters.values())
            return function(**{symbol: values[symbol] for symbol, _ in measured})
        return function(**values)


def chosen_axis(sensor: str, default: AzimuthFrom | None, azimuth_from: AzimuthFrom | None) -> AzimuthFrom | None:
    """Where the azimuth of a sensor is counted from; None without an azimuth.

    Raises:
        TypeError, ValueError: the word is none of the two, or there is no azimuth.

    """
    if azimuth_from is None:
        return default
    if default is None:
        raise ValueError(f"azimuth_from must be None for sensor {sensor!r}; got {azimuth_from!r}")
    chosen: AzimuthFrom = one_of("azimuth_from", azimuth_from, get_args(AzimuthFrom))
    return chosen


def _reach(values: Mapping[str, RealArray] | Mapping[str, float], of: str) -> tuple[str, RealArray, Domain]:
    """Directions stay in the unit circle despite their errors."""
    reach = np.hypot(values["u"], values["v"])
    reach = reach + MARGIN * np.maximum(values["sigma_u"], values["sigma_v"])
    return f"sqrt(u^2 + v^2) + {MARGIN} max(u_std, v_std){of}", np.asarray(reach), DIRECTION


def _of_triangle(
    values: Mapping[str, RealArray] | Mapping[str, float], of: str
) -> Iterator[tuple[str, RealArray, Domain]]:
    """The path stays longer than the baseline, and the azimuth off the angles at which a shorter one has no end.

    As a function of the azimuth the range has poles at the imaginary angles whose cosine is path over baseline.
    """
    path, baseline = values["path"], values["baseline"]
    share = (baseline + MARGIN * np.asarray(values["sigma_path"])) / path
    yield f"(baseline + {MARGIN} path_std)/path{of}", np.asarray(share), TRIANGLE
    with np.errstate(divide="ignore", over="ignore"):  # without a baseline the pole is at infinity
        pole = np.arccosh(path / (np.asarray(baseline) + 0.0))  # of a zero with a sign the ratio would be negative
    turned = MARGIN * np.asarray(values["sigma_beta"]) / pole
    yield f"{MARGIN} azimuth_std/arccosh(path/baseline){of}", np.asarray(turned), ROUND_THE_BASELINE


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
    "spherical_doppler": Sensor(
        module="spherical_doppler",
        coordinates={
            "r": _RANGE,
            "azimuth": _AZIMUTH,
            "elevation": Argument("epsilon", ELEVATION),
            "range_rate": Argument("rdot", RANGE_RATE),
        },
        noise={
            "range_std": _RANGE_STD,
            "azimuth_std": _AZIMUTH_STD,
            "elevation_std": Argument("sigma_epsilon", ANGLE_STD),
            "range_rate_std": Argument("sigma_rdot", RANGE_RATE_STD),
            "correlation": _CORRELATION,
        },
        correlated=(0, 3),
        azimuth_from="y",
    ),
    "bistatic": Sensor(
        module="bistatic",
        coordinates={"path": Argument("path", PATH), "azimuth": _AZIMUTH},
        parameters={"baseline": Argument("baseline", RANGE)},
        noise={
            "path_std": Argument("sigma_path", RANGE),
            "azimuth_std": Argument("sigma_beta", PATH_AZIMUTH_STD),
            "correlation": _CORRELATION,
        },
        correlated=(0, 1),
        azimuth_from="x",
        series="_semidefinite",
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
