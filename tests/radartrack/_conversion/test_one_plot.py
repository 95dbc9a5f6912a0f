"""One plot in plain numbers: what it is in an array, with the same errors."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import convert as conversions
from radartrack._conversion import many_plots
from radartrack.convert import Method
from tests.examples import share
from tests.radartrack.plots import OF_THE_PLOT, PLOTS, SENSORS, WITH_AZIMUTH, assert_agree, convert, plots

ULP = np.finfo(float).eps


@pytest.mark.parametrize("azimuth_from", ["x", "y"])
@pytest.mark.parametrize("method", OF_THE_PLOT)
@pytest.mark.parametrize("sensor", SENSORS)
@given(data=st.data())
@share(0.3)
def test_a_plot_alone_is_within_rounding_the_same_plot_in_an_array(
    sensor: str, method: Method, azimuth_from: str, data: st.DataObject
) -> None:
    plot = data.draw(plots(sensor))
    convention = {"azimuth_from": azimuth_from} if sensor in WITH_AZIMUTH else {}
    alone = convert(sensor, method, **plot, **convention)
    row = convert(sensor, method, **{name: [value] for name, value in plot.items()}, **convention)
    assert alone.mean.shape == row.mean.shape[1:]
    assert alone.covariance.shape == row.covariance.shape[1:]
    assert_agree(alone.mean, row.mean[0], np.linalg.norm(row.mean), 16 * ULP)
    independent = convert(sensor, method, **plot | {"correlation": 0.0}, **convention).covariance
    deviations = np.sqrt(np.diagonal(independent))
    assert_agree(alone.covariance, row.covariance[0], np.outer(deviations, deviations), 64 * ULP)


@pytest.mark.parametrize("method", OF_THE_PLOT)
@pytest.mark.parametrize("sensor", SENSORS)
def test_plain_numbers_take_no_arrays(sensor: str, method: Method, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(many_plots, "real_arrays", lambda _: pytest.fail("the general way was taken"))
    convert(sensor, method)
    convert(sensor, method, r=900, range_std=np.float64(40), correlation=0)


@pytest.mark.parametrize("kind", [int, float, np.float64])
def test_any_plain_number_gives_the_same_bits(kind: type) -> None:
    for sensor in SENSORS:
        expected, got = convert(sensor, "unbiased", r=900.0), convert(sensor, "unbiased", r=kind(900))
        assert {part.dtype for part in got} == {np.dtype(np.float64)}
        np.testing.assert_array_equal(got.mean, expected.mean)
        np.testing.assert_array_equal(got.covariance, expected.covariance)


@pytest.mark.parametrize(
    "value",
    [True, np.True_, None, "1", 1j, math.nan, math.inf, -math.inf, 1e101, 10**400, -1.0, -5e-324, [], {}],
)
@pytest.mark.parametrize("sensor", SENSORS)
def test_what_is_refused_is_refused_in_the_words_for_arrays(sensor: str, value: Any) -> None:
    for name in PLOTS[sensor]:
        messages: list[Any] = []
        for other in (0.0, np.array(0.0)):  # the array leads the general way
            arguments = {"correlation": other, name: value}
            try:
                messages.append(("taken", convert(sensor, "linear", **arguments).mean.shape))
            except (TypeError, ValueError) as error:
                messages.append((type(error), str(error)))
        assert messages[0] == messages[1]


def test_numbers_that_are_not_possible_together_are_refused_in_the_words_for_arrays() -> None:
    message = r"^sqrt\(u\^2 \+ v\^2\) \+ 5 max\(u_std, v_std\) must be from 0 .*got 1\.0"
    for u in (0.7, np.array(0.7)):
        with pytest.raises(ValueError, match=message):
            convert("ruv", "unbiased", u=u, v=0.7)


def test_single_precision_stays_single() -> None:
    assert conversions.polar(np.float32(900), np.float32(1), np.float32(9), np.float32(0.1)).mean.dtype == np.float32
