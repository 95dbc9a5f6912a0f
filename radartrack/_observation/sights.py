"""What each sensor measures of which state, and where that has no derivative."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from radartrack._arrays.validation import (
    RANGE,
    Domain,
    RealArray,
    require_trailing_shape,
    require_within,
)
from radartrack._arrays.validation import RANGE_RATE as SPEED
from radartrack._conversion.sensors import SENSORS, AzimuthFrom, SensorName, chosen_axis
from radartrack.generated import observe as formulas

SightName: TypeAlias = (
    SensorName | Literal["bearing", "range_difference", "range_rate_difference", "bistatic_range_rate"]
)
Kind: TypeAlias = Literal["map", "jacobian", "hessian"]

POSITION = Domain(" m", 1e150, 1e15, "squares of larger numbers overflow", signed=True)
POLE = {np.dtype(np.float64): 1e-100, np.dtype(np.float32): 1e-12}

PLANE, SPACE = ("x", "y"), ("x", "y", "z")
MOVING_IN_PLANE, MOVING_IN_SPACE = (*PLANE, "vx", "vy"), (*SPACE, "vx", "vy", "vz")
_EXCHANGED = {"x": "y", "y": "x", "vx": "vy", "vy": "vx"}
RECEIVER = tuple(f"receiver_{axis}" for axis in SPACE)


@dataclass(frozen=True, slots=True)
class Sight:
    """What is measured of a state.

    Attributes:
        name: of the formulas.
        state: the components of a state that they take.
        outputs: what is measured.
        azimuth_from: the axis that the formulas count the azimuth from, or on which they have the transmitter.
        site: the coordinates of the other site, by its public name.
        place: where no derivative exists.
        axes: the coordinates that are zero there.
    """

    name: SightName
    state: tuple[str, ...]
    outputs: tuple[str, ...]
    azimuth_from: AzimuthFrom | None = None
    site: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    place: str = "the radar"
    axes: tuple[str, ...] = PLANE

    @property
    def positions(self) -> tuple[str, ...]:
        """The components that are positions; they come first."""
        return tuple(name for name in self.state if name in SPACE)

    @property
    def azimuths(self) -> list[int]:
        """The places of the outputs that are the same after a whole turn."""
        return [place for place, name in enumerate(self.outputs) if name == "azimuth"]

    def order(self, azimuth_from: AzimuthFrom | None) -> list[int]:
        """The places of the components that the formulas take for this choice of axis.

        Raises:
            TypeError, ValueError: the word is none of the two, or there is no choice.

        """
        kept = chosen_axis(self.name, self.azimuth_from, azimuth_from) == self.azimuth_from
        return [self.state.index(name if kept else _EXCHANGED.get(name, name)) for name in self.state]

    def read_state(self, name: str, values: RealArray) -> None:
        """Check the components of states along the last axis.

        Raises:
            ValueError: a component is out of place.

        """
        require_trailing_shape(name, values, (len(self.state),))
        for place, component in enumerate(self.state):
            require_within(f"{component} of {name}", values[..., place], POSITION if component in SPACE else SPEED)

    def read_site(self, given: Mapping[str, RealArray]) -> dict[str, RealArray]:
        """The coordinates of the other site, by symbol.

        Raises:
            ValueError: a coordinate is out of place.

        """
        values: dict[str, RealArray] = {}
        for name, symbols in self.site.items():
            array = given[name]
            if len(symbols) > 1:
                require_trailing_shape(name, array, (len(symbols),))
            require_within(name, array, POSITION if len(symbols) > 1 else RANGE)
            parts = np.moveaxis(array, -1, 0) if len(symbols) > 1 else [array]
            values |= dict(zip(symbols, (off_pole(part) for part in parts), strict=True))
        return values

    def evaluate(self, kind: Kind, components: Sequence[RealArray], site: Mapping[str, RealArray]) -> RealArray:
        """A formula at states, one array a component, of which `off_pole` has been told where derivatives are asked."""
        function: Callable[..., RealArray] = getattr(formulas, f"{self.name}_{kind}")
        return function(**dict(zip(self.state, components, strict=True)), **site)

    def off_poles(self, components: Sequence[RealArray], site: Mapping[str, RealArray]) -> list[RealArray]:
        """The components with those positions set to zero, or to the other site's, that are too near to divide by."""
        sites = dict(zip(self.positions, site.values(), strict=False))
        return [
            off_pole(part, sites.get(name)) if name in SPACE else part
            for name, part in zip(self.state, components, strict=True)
        ]

    def require_derivatives(self, name: str, states: RealArray, site: Mapping[str, RealArray]) -> None:
        """Check that states, in the order of the formulas, do not lie where a measurement has no derivative.

        Raises:
            ValueError: some do.

        """
        least = POLE[states.dtype]
        away = POSITION._replace(signed=False, smallest=least, reason="there is no derivative nearer to it")
        axes = [self.state.index(axis) for axis in self.axes]
        require_within(f"{name}'s distance from {self.place}", np.abs(states[..., axes]).max(axis=-1), away)
        if site:
            there = [site[key] for key in site] + [np.zeros(())] * (len(axes) - len(site))
            offsets = [np.abs(states[..., axis] - at) for axis, at in zip(axes, there, strict=True)]
            farther = away._replace(largest=2 * away.largest, largest_single=2 * away.largest_single)
            [word] = self.site
            place = "the transmitter" if word == "baseline" else "the other receiver"
            require_within(
                f"{name}'s distance from {place}", np.stack(np.broadcast_arrays(*offsets)).max(axis=0), farther
            )


def off_pole(values: RealArray, site: RealArray | None = None) -> RealArray:
    """Coordinates of which those that are too small to divide by twice are zero, and those too near a site are its."""
    least = POLE[np.dtype(values.dtype)]
    kept = np.where(np.abs(values) < least, 0, values)
    return kept if site is None else np.where(np.abs(kept - site) < least, site, kept)


def site_of(sight: Sight, given: Mapping[str, ArrayLike]) -> dict[str, ArrayLike]:
    """The other site as it was given.

    Raises:
        TypeError: it is missing, or there is none.

    """
    if set(given) != set(sight.site):
        allowed = f"{[*sight.site]}" if sight.site else "no site"
        raise TypeError(f"sensor {sight.name!r} takes {allowed} beside the state; got {sorted(given)}")
    return dict(given)


def _of_sensor(name: SensorName, state: tuple[str, ...], **more: object) -> Sight:
    sensor = SENSORS[name]
    return Sight(name, state, tuple(sensor.coordinates), sensor.azimuth_from, **more)  # type: ignore[arg-type]


_VERTICAL = "the vertical axis"
SIGHTS: Mapping[SightName, Sight] = {
    "polar": _of_sensor("polar", PLANE),
    "spherical": _of_sensor("spherical", SPACE, place=_VERTICAL),
    "polar_doppler": _of_sensor("polar_doppler", MOVING_IN_PLANE),
    "spherical_doppler": _of_sensor("spherical_doppler", MOVING_IN_SPACE, place=_VERTICAL),
    "ruv": _of_sensor("ruv", SPACE, axes=SPACE),
    "bistatic": _of_sensor("bistatic", PLANE, site={"baseline": ("baseline",)}),
    "bearing": Sight("bearing", PLANE, ("azimuth",), "x"),
    "range_difference": Sight(
        "range_difference", SPACE, ("range_difference",), None, {"receiver": RECEIVER}, axes=SPACE
    ),
    "range_rate_difference": Sight(
        "range_rate_difference", MOVING_IN_SPACE, ("range_rate_difference",), None, {"receiver": RECEIVER}, axes=SPACE
    ),
    "bistatic_range_rate": Sight(
        "bistatic_range_rate", MOVING_IN_PLANE, ("path_rate",), "x", {"baseline": ("baseline",)}
    ),
}
