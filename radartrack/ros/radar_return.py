"""The fields of `radar_msgs/RadarReturn` as plots of our conversions, and back.

    plots = rt.ros.plots_of(scan.returns, "spherical_doppler")
    rt.convert.spherical_doppler(**plots, range_std=0.5, ..., azimuth_from="x")

The message counts azimuths from the axis ahead of the radar, counter-clockwise (REP 103); a revision of it before that
said clockwise. Which sign a receding target's Doppler velocity has, it does not say. Both can be chosen.

Source: the messages `RadarReturn` and `RadarScan` of the package radar_msgs.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from typing import Any, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike

from radartrack._arrays.validation import RealArray, broadcast_shape, one_of, real_arrays, require_finite

Turning: TypeAlias = Literal["counter_clockwise", "clockwise"]
PositiveDoppler: TypeAlias = Literal["receding", "approaching"]
RosSensor: TypeAlias = Literal["polar", "spherical", "polar_doppler", "spherical_doppler"]

_FIELDS = {"r": "range", "azimuth": "azimuth", "elevation": "elevation", "range_rate": "doppler_velocity"}
_TAKEN: Mapping[RosSensor, tuple[str, ...]] = {
    "polar": ("r", "azimuth"),
    "spherical": ("r", "azimuth", "elevation"),
    "polar_doppler": ("r", "azimuth", "range_rate"),
    "spherical_doppler": ("r", "azimuth", "elevation", "range_rate"),
}


@dataclass(frozen=True)
class RadarReturn:
    """The fields of the message, of which a ROS message is made by `Message(**vars(it))`.

    Attributes:
        range: [m].
        azimuth: [rad].
        elevation: [rad], up; 0 for a radar that measures none.
        doppler_velocity: [m/s].
        amplitude: [dB].
    """

    range: float
    azimuth: float
    elevation: float = 0.0
    doppler_velocity: float = 0.0
    amplitude: float = 0.0


def plots_of(
    returns: Iterable[Any],
    sensor: RosSensor = "spherical_doppler",
    turning: Turning = "counter_clockwise",
    positive_doppler: PositiveDoppler = "receding",
) -> dict[str, RealArray]:
    """Read returns, which may be ROS messages, mappings of their fields, or `RadarReturn`.

    Args:
        returns: any number of them.
        sensor: the conversion that the plots are for; what it does not take is left out.
        turning: which way positive azimuths turn: "counter_clockwise", or "clockwise" as in older messages.
        positive_doppler: what a positive Doppler velocity means.

    Returns:
        By name what the conversion takes of a plot, in metres, radians and metres a second, shape (n,), in float64; the
        azimuth is counted counter-clockwise from the x axis ahead: `azimuth_from="x"`.

    Raises:
        TypeError: a return has not the fields, or one is no number.
        ValueError: a number is not finite, or a word is unknown.

    """
    taken = _TAKEN[one_of("sensor", sensor, _TAKEN)]
    signs = _signs(turning, positive_doppler)
    rows = [[_field(one, _FIELDS[name], number) for name in taken] for number, one in enumerate(returns)]
    columns = np.array(rows, dtype=np.float64).reshape(len(rows), len(taken)).T
    for name, values in zip(taken, columns, strict=True):
        require_finite(_FIELDS[name], values)
    return {name: signs.get(name, 1) * values for name, values in zip(taken, columns, strict=True)}


def returns_of(
    plots: Mapping[str, ArrayLike],
    amplitude: ArrayLike = 0.0,
    turning: Turning = "counter_clockwise",
    positive_doppler: PositiveDoppler = "receding",
) -> list[RadarReturn]:
    """Make returns of plots.

    Args:
        plots: `r`, `azimuth` counted counter-clockwise from the x axis ahead, and if measured `elevation` and
            `range_rate`, as `plots_of` returns them and `rt.simulate` makes them; all broadcast.
        amplitude: [dB].
        turning: which way positive azimuths are to turn.
        positive_doppler: what a positive Doppler velocity is to mean.

    Returns:
        One for each plot; what is not measured is 0, as the message says of the elevation.

    Raises:
        TypeError: a name is missing or unknown, or a value is not made of real numbers.
        ValueError: a number is not finite, the shapes do not broadcast to one axis, or a word is unknown.

    """
    signs = _signs(turning, positive_doppler)
    if not {"r", "azimuth"} <= set(plots) <= set(_FIELDS):
        raise TypeError(f"plots must have r and azimuth, and may have elevation and range_rate; got {sorted(plots)}")
    arrays = real_arrays({**plots, "amplitude": amplitude})
    for name, values in arrays.items():
        require_finite(name, values)
    shape = broadcast_shape(arrays)
    if len(shape) > 1:
        raise ValueError(f"plots must have one axis; got shape {shape}")
    spread = {name: np.broadcast_to(values, shape or 1).tolist() for name, values in arrays.items()}
    named = {_FIELDS.get(name, name): [signs.get(name, 1) * one for one in values] for name, values in spread.items()}
    return [RadarReturn(**dict(zip(named, row, strict=True))) for row in zip(*named.values(), strict=True)]


def _signs(turning: Turning, positive_doppler: PositiveDoppler) -> dict[str, int]:
    return {
        "azimuth": 1 if one_of("turning", turning, get_args(Turning)) == "counter_clockwise" else -1,
        "range_rate": 1
        if one_of("positive_doppler", positive_doppler, get_args(PositiveDoppler)) == "receding"
        else -1,
    }


def _field(one: Any, name: str, number: int) -> float:
    value = one.get(name) if isinstance(one, Mapping) else getattr(one, name, None)
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)):
        wanted = [field.name for field in fields(RadarReturn)]
        raise TypeError(f"return {number} must have the fields {wanted}, numbers; its {name} is {value!r}")
    return float(value)
