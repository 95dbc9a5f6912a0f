"""Points of the domain: inside it, over every scale, the same for the same seed."""

import subprocess
import sys

import numpy as np
import pytest

from radartrack.derive.catalogue import catalogue, find
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.units import RADIAN
from radartrack.verification.domain_points import sample
from tests import conversions

QUANTITY = find("polar.decorrelated.covariance")


@pytest.mark.parametrize("quantity", catalogue().values(), ids=conversions.ids)
def test_points_lie_in_the_domain_and_whole_numbers_are_whole(quantity: Quantity):
    points = sample(quantity, 400, seed=1, correlated=True)
    assert list(points) == [symbol.name for symbol in quantity.symbols]
    for symbol in quantity.symbols:
        values = points[symbol.name]
        assert values.shape == (400,)
        slack = 0.02 if symbol.unit == RADIAN else 0.0
        assert symbol.low - slack <= values.min()
        assert values.max() <= symbol.high + slack
        if symbol.whole:
            assert (values == np.round(values)).all()
        if symbol.at_most is not None:
            assert (values <= points[symbol.at_most.name]).all()


def test_lengths_and_deviations_spread_over_every_decade():
    points = sample(QUANTITY, 2000)
    for symbol in QUANTITY.symbols:
        if symbol.low > 0:
            decades = np.log10(symbol.low), np.log10(symbol.high)
            counts, _ = np.histogram(np.log10(points[symbol.name]), bins=8, range=decades)
            assert counts.min() > 150


def test_angles_go_round_and_come_close_to_where_sines_and_cosines_vanish():
    beta = sample(QUANTITY, 2000)["beta"]
    assert np.histogram(beta, bins=8, range=(-np.pi, np.pi))[0].min() > 100
    off = np.abs(beta / (np.pi / 4) - np.round(beta / (np.pi / 4)))
    assert np.mean(off < 1e-6) > 0.1
    assert (off[off < 1e-6] > 0).any()


def test_correlations_are_drawn_only_when_asked_for():
    assert not sample(QUANTITY, 50)["rho"].any()
    drawn = sample(QUANTITY, 500, correlated=True)["rho"]
    assert drawn.min() < -0.9
    assert drawn.max() > 0.9


def test_the_same_seed_gives_the_same_points_and_another_one_others():
    first, again, other = sample(QUANTITY, 20, seed=3), sample(QUANTITY, 20, seed=3), sample(QUANTITY, 20, seed=4)
    for name in first:
        np.testing.assert_array_equal(first[name], again[name])
    assert (first["r"] != other["r"]).all()


def test_points_do_not_depend_on_the_hash_seed():
    code = (
        "from radartrack.derive.catalogue import find; from radartrack.verification.domain_points import sample;"
        "print([v.tolist() for v in sample(find('polar.bias.truth'), 3, seed=9).values()])"
    )
    outputs = {
        subprocess.run(
            [sys.executable, "-c", code], env={"PYTHONHASHSEED": seed}, capture_output=True, check=True
        ).stdout
        for seed in ("0", "1")
    }
    assert len(outputs) == 1
