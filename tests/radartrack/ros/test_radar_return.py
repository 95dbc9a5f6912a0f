"""Returns of ROS are plots of ours, and back, in every convention that the message has had."""

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import radartrack as rt

NUMBERS = st.floats(-1e6, 1e6)
RETURNS = st.lists(st.builds(rt.ros.RadarReturn, NUMBERS, NUMBERS, NUMBERS, NUMBERS), max_size=5)


class Message:
    """Like one that ROS makes."""

    def __init__(self, **fields: float) -> None:
        self.__dict__.update(fields)


@given(RETURNS, st.sampled_from(["counter_clockwise", "clockwise"]), st.sampled_from(["receding", "approaching"]))
def test_there_and_back_is_the_same(returns: list[rt.ros.RadarReturn], turning: Any, doppler: Any) -> None:
    plots = rt.ros.plots_of(returns, turning=turning, positive_doppler=doppler)
    assert rt.ros.returns_of(plots, turning=turning, positive_doppler=doppler) == returns


def test_a_return_to_the_left_is_on_the_positive_y_axis_as_ros_says() -> None:
    left = rt.ros.RadarReturn(range=100.0, azimuth=np.pi / 2)
    plot: dict[str, Any] = dict(rt.ros.plots_of([left], "polar"))
    mean = rt.convert.polar(**plot, range_std=0.1, azimuth_std=1e-6, azimuth_from="x").mean
    np.testing.assert_allclose(mean, [[0.0, 100.0]], atol=1e-6)
    older = rt.ros.plots_of([left], "polar", turning="clockwise")
    np.testing.assert_allclose(older["azimuth"], [-np.pi / 2])


def test_a_target_that_closes_in_has_a_negative_range_rate() -> None:
    one = rt.ros.RadarReturn(100.0, 0.0, 0.0, doppler_velocity=20.0)
    assert rt.ros.plots_of([one], positive_doppler="approaching")["range_rate"].tolist() == [-20.0]


def test_messages_mappings_and_returns_are_read_alike() -> None:
    one = rt.ros.RadarReturn(1e3, 0.2, 0.1, -5.0, 12.0)
    kinds: Sequence[Any] = (one, asdict(one), Message(**asdict(one)))
    for kind in kinds:
        found = {name: values.tolist() for name, values in rt.ros.plots_of([kind]).items()}
        assert found == {"r": [1e3], "azimuth": [0.2], "elevation": [0.1], "range_rate": [-5.0]}


def test_what_is_not_measured_is_zero_and_the_amplitude_goes_along() -> None:
    returns = rt.ros.returns_of({"r": [1.0, 2.0], "azimuth": 0.5}, amplitude=[3.0, 4.0])
    assert returns == [rt.ros.RadarReturn(1.0, 0.5, amplitude=3.0), rt.ros.RadarReturn(2.0, 0.5, amplitude=4.0)]


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda: rt.ros.plots_of([{"range": 1.0}]), TypeError, "return 0 must have the fields .* its azimuth is None"),
        (lambda: rt.ros.plots_of([rt.ros.RadarReturn(np.nan, 0.0)]), ValueError, "range must be finite"),
        (lambda: rt.ros.plots_of([], turning="left"), ValueError, "turning must be one of"),  # type: ignore[arg-type]
        (lambda: rt.ros.plots_of([], "ruv"), ValueError, "sensor must be one of"),  # type: ignore[arg-type]
        (lambda: rt.ros.returns_of({"r": 1.0}), TypeError, "plots must have r and azimuth"),
        (lambda: rt.ros.returns_of({"r": np.ones((2, 2)), "azimuth": 0.0}), ValueError, "must have one axis"),
    ],
)
def test_what_is_no_return_is_refused(call: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        call()
