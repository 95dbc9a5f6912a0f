"""Sine, cosine, e^x and e^x − 1 beside correctly rounded values, at their limits, and as they are written."""

import math
import os
from hashlib import sha256

import numpy as np
import pytest

from radartrack.generated import elementary
from radartrack.verification.elementary.elementary_campaign import REACH, TYPES, drawn, largest, over_arrays
from radartrack.verification.elementary.elementary_certificates import kept
from radartrack.verification.elementary.elementary_checker import FUNCTIONS

ARGUMENTS = int(os.environ.get("RADARTRACK_ARGUMENTS", "3000"))  # of each function in each precision
EACH = pytest.mark.parametrize(("name", "precision"), [(name, kind) for kind in TYPES for name in FUNCTIONS])
DIGESTS = {
    "sin": "26c9db9f8807ed0b",
    "cos": "bd7ecf93a1c94213",
    "exp": "3e7fb905d33dbedd",
    "expm1": "cef27dd6c910d16f",
}


def of_precision(name: str, precision: str):
    return over_arrays(name + ("" if precision == "double" else "_single"))


def spread(reach: float, count: int = 20_000) -> np.ndarray:
    """Arguments that no library has computed: multiples of an irrational share, and their products."""
    shares = (np.arange(count) * 0.6180339887498949) % 1.0
    return (2 * shares - 1) * np.where(np.arange(count) % 2, reach, 1.0)


@EACH
def test_no_error_is_above_the_proved_bound(name: str, precision: str):
    pytest.importorskip("flint")
    found = largest(name, precision, ARGUMENTS, seed=7)
    assert found.ulp <= kept()[precision][name]["bound"] <= 1.0
    assert found.correct > 0.9


@pytest.mark.parametrize("precision", TYPES)
@pytest.mark.parametrize("name", ["sin", "cos"])
def test_the_sign_of_an_angle_is_that_of_its_sine_and_not_of_its_cosine(name: str, precision: str):
    angles = drawn(name, precision, 2000, np.random.default_rng(3))
    function = of_precision(name, precision)
    np.testing.assert_array_equal(function(-angles), (-1 if name == "sin" else 1) * function(angles))


@pytest.mark.parametrize("precision", TYPES)
def test_beyond_the_largest_angle_there_is_no_sine(precision: str):
    reach = REACH[precision]["sin"]
    assert reach == (elementary.LARGEST_ANGLE if precision == "double" else elementary.LARGEST_ANGLE_SINGLE)
    edge = np.array([reach, -reach], TYPES[precision])
    beyond = np.append(np.nextafter(edge, 2 * edge), np.array([np.inf, -np.inf, np.nan], edge.dtype))
    with np.errstate(invalid="ignore"):
        for name in ("sin", "cos"):
            assert np.isfinite(of_precision(name, precision)(edge)).all()
            assert np.isnan(of_precision(name, precision)(beyond)).all()


@pytest.mark.parametrize("precision", TYPES)
def test_exponentials_end_in_zero_and_infinity(precision: str):
    arguments = np.array([-np.inf, -1e30, -120.0, 0.0, 1e30, np.inf, np.nan], TYPES[precision])
    with np.errstate(all="ignore"):
        powers = of_precision("exp", precision)(arguments)
        less_one = of_precision("expm1", precision)(arguments)
    small = math.exp(-120.0) if precision == "double" else 0.0
    np.testing.assert_allclose(powers, [0.0, 0.0, small, 1.0, np.inf, np.inf, np.nan], rtol=1e-15)
    np.testing.assert_array_equal(less_one, [-1.0, -1.0, -1.0, 0.0, np.inf, np.inf, np.nan])


def test_plain_numbers_give_what_arrays_give():
    for name in FUNCTIONS:
        arguments = spread(700.0, 300)
        one_by_one = [getattr(elementary, name)(x) for x in arguments.tolist()]
        np.testing.assert_array_equal(over_arrays(name)(arguments), one_by_one)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_results_have_the_same_bits_on_every_machine(name: str):
    reach = {"sin": 32768.0, "cos": 32768.0}.get(name, 700.0)
    assert sha256(over_arrays(name)(spread(reach)).astype("<f8").tobytes()).hexdigest()[:16] == DIGESTS[name]
