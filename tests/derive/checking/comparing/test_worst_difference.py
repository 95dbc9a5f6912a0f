"""The worst difference is the worst: no example is above it, and no corner or zero of where radars work either."""

from __future__ import annotations

import math
from functools import partial
from random import Random

import pytest

from radartrack.derive.checking.check import check
from radartrack.derive.checking.comparing.domain_search import summits
from radartrack.derive.checking.comparing.working_domain import working, works
from radartrack.derive.evaluation.points import Point
from radartrack.derive.language.variable import Variable, deviation, length
from radartrack.derive.units import ONE

W = "(1 - u**2 - v**2)"
RUV_ZZ = (
    f"sigma_r**2*{W} + sigma_u**2*r**2*u**2/{W} + sigma_v**2*r**2*v**2/{W}"
    f" + sigma_r**2*(sigma_u**2*u**2 + sigma_v**2*v**2)/{W}"
    f" + r**2*sigma_u**4*(1 - v**2)**2/(2*{W}**3) + r**2*sigma_v**4*(1 - u**2)**2/(2*{W}**3)"
)


def test_what_vanishes_on_the_axes_alone_is_found_there() -> None:
    library = f"r**2/2*(u**2*v**2/{W}**3 - (u**2 + v**2)/{W}**2 - 1/{W})"
    verdict = check(
        "ruv.covariance.second_order[2,2]", f"{RUV_ZZ} + sigma_u**2*sigma_v**2*{library}", given={"rho": "0"}
    )
    example = verdict.counterexample
    assert example is not None
    assert example.largest_relative_difference == pytest.approx(0.5, rel=0.01)
    assert check(
        "ruv.covariance.second_order[2,2]",
        f"{RUV_ZZ} + sigma_u**2*sigma_v**2*r**2*u**2*v**2/{W}**3",
        given={"rho": "0"},
    ).is_equal


SLIPS = [
    ("polar.map[0]", "r*sin(beta)"),
    ("polar.bias.second_order[1]", "-r*sin(beta)*sigma_beta**2"),
    ("polar.covariance.linear[0,1]", "(sigma_r**2 + r**2*sigma_beta**2)*sin(beta)*cos(beta)"),
    ("polar.covariance.linear[0,0]", "sigma_r**2*cos(beta)**2 + r*sigma_beta**2*sin(beta)**2"),
    ("polar.jacobian[1,0]", "cos(beta)"),
    ("observe.polar_doppler.map[2]", "(x*vx - y*vy)/sqrt(x**2 + y**2)"),
    ("observe.spherical.map[2]", "atan2(z, sqrt(x**2 + y**2 + z**2))"),
    ("finite_sample.degree1.range.covariance[0,0]", "sigma_r**2*(4*k + 2)/(k*(k + 1))"),
]


@pytest.mark.parametrize(("name", "formula"), SLIPS)
def test_the_worst_is_never_below_the_example_and_says_what_it_is_measured_against(name: str, formula: str) -> None:
    example = check(name, formula).counterexample
    assert example is not None
    assert example.relative_difference is not None
    assert example.largest_relative_difference is not None
    assert example.largest_relative_difference >= example.relative_difference
    assert example.measured_against.startswith("the derived value where radars work")
    assert example.printed is not None
    assert example.relative_difference == pytest.approx(abs(example.printed - example.derived) / abs(example.derived))


def test_a_term_that_matters_for_the_worst_radars_alone_is_as_bad_as_at_their_corner() -> None:
    found = check("polar.bias.truth[0]", "-r*cos(beta)*sigma_beta**2/2", given={"rho": "0"}).counterexample
    assert found is not None
    sigma = 0.262  # rad, the worst that is taken for a radar
    expected = sigma**2 / 2 / (1 - math.exp(-(sigma**2) / 2)) - 1
    assert found.largest_relative_difference == pytest.approx(expected, rel=0.01)


def test_no_radar_measures_a_millimetre_at_a_hundred_thousand_kilometres() -> None:
    r = length("r", "range")
    sigma_r = deviation(r, low=1e-3, high=1e4)
    assert not works((r, sigma_r), {"r": 1e8, "sigma_r": 1e-3})
    assert works((r, sigma_r), {"r": 5e4, "sigma_r": 50.0})
    narrowed, _ = working((r, sigma_r))
    assert r.low < narrowed.low < narrowed.high < r.high


def height(peak: Point, point: Point) -> float:
    return 1 / (0.01 + sum((point[name] - value) ** 2 for name, value in peak.items()))


@pytest.mark.parametrize("low", [-1.0, 0.0, 1e-3])
def test_a_search_finds_a_corner_a_zero_and_a_peak_between(low: float) -> None:
    symbols = [Variable(name, "a number", ONE, low, 1.0) for name in "abc"]
    chance = Random(3)
    for _ in range(10):
        peak = {s.name: chance.choice([s.low, s.high, chance.uniform(s.low, s.high)]) for s in symbols}
        (best, *_) = summits(partial(height, peak), symbols, lambda _: True, [])
        assert all(abs(best[name] - value) < 0.1 for name, value in peak.items())
