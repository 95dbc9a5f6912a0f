"""Simulated errors of the six radars of Gorshkov & Zavizhenets beside the closed forms."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import scipy.stats

from radartrack.finite_sample_experiment import chi_square_ratio, compare, radial_radar
from radartrack.simulate import Radar

RADARS = [
    radial_radar(250.0, 35.0, 10.0),
    radial_radar(250.0, 25.0, 10.0),
    radial_radar(250.0, 15.0, 10.0),
    radial_radar(250.0, 15.0, 5.0),
    radial_radar(50.0, 1.0, 10.0),
    radial_radar(50.0, 1.0, 5.0),
]


@pytest.mark.parametrize("observer", RADARS)
def test_simulated_errors_lie_in_their_bands(observer: Radar) -> None:
    """False alarm once in a million for each radar; an error of a deviation of 2 % would be seen."""
    found = compare(observer)
    assert found.without.inside
    assert found.with_rate.inside
    low, high = found.gain_band
    known = ~np.isnan(found.expected_gain)
    assert np.all((low <= found.gain)[known] & (found.gain <= high)[known])
    width = (found.without.high - found.without.low)[known] / found.without.expected[known]
    assert width.max() < 0.03


def test_a_wrong_deviation_leaves_the_bands() -> None:
    found = compare(RADARS[2])
    wrong = compare(radial_radar(255.0, 15.0, 10.0))
    assert not found.with_rate._replace(measured=wrong.with_rate.measured).inside


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        (
            {"radar": Radar("polar", 1.0, {"range_std": 1.0, "azimuth_std": 0.1})},
            ValueError,
            "radar must be of the sensor",
        ),
        ({"radar": replace(RADARS[0], site=(1e4, 0.0))}, ValueError, "at the origin"),
        ({"radar": replace(RADARS[0], detection_probability=0.9)}, ValueError, "miss nothing"),
        ({"start": (1e5, -200.0)}, ValueError, "start must be range, speed and acceleration"),
        ({"start": (1e5, np.nan, 0.0)}, ValueError, "velocity must be two or three finite numbers"),
        *(
            ({"false_alarm": wrong}, ValueError, "false_alarm must be from 1e-09 to 0.5")
            for wrong in (0, 1e-20, -1, 1.5, np.nan)
        ),
        *(({"false_alarm": wrong}, TypeError, "false_alarm must be a real number") for wrong in ("x", None, True)),
    ],
)
def test_what_the_bands_do_not_hold_for_is_refused_by_name(
    change: dict[str, Any], error: type[Exception], message: str
) -> None:
    arguments: dict[str, Any] = {"radar": RADARS[0], "trials": 10}
    with pytest.raises(error, match=message):
        compare(**arguments | change)


def test_the_quantiles_are_those_of_the_chi_square_distribution() -> None:
    freedom = np.array([1e3, 1e5, 1e7])
    for probability in (1e-8, 0.3, 1 - 1e-8):
        exact = scipy.stats.chi2.ppf(probability, freedom) / freedom
        assert np.all(np.abs(chi_square_ratio(freedom, probability) / exact - 1) < 2e-4)
