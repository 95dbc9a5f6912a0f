"""Functions beside quantities of models of one's own, whose coordinates may have no error, or vanish inside."""

import math
import tomllib
import warnings
from typing import Any

import numpy as np
import pytest

from radartrack.derive.reading.model_table import read_models
from radartrack.testing import CannotDiagnose, diagnose

TOML = """
[symbols]
r = { unit = "m", low = 1e3, high = 1e5 }
b = { unit = "rad" }
H = { unit = "m", low = 10, high = 900 }
p = { unit = "m", low = -10, high = 10 }
f = { unit = "1/m", low = 10, high = 1000 }
s_r = { unit = "m", low = 1, high = 100 }
s_b = { unit = "rad", low = 1e-6, high = 0.1 }
s_p = { unit = "m", low = 1e-6, high = 1e-3 }
[[model]]
name = "flat"
measured = ["r", "b"]
parameters = ["H"]
outputs = { x = "r*cos(b)", y = "r*sin(b)", z = "H" }
units = { x = "m", y = "m", z = "m" }
deviations = { r = "s_r", b = "s_b" }
[[model]]
name = "wave"
measured = ["p"]
parameters = ["f"]
outputs = { v = "sin(2*pi*f*p)" }
units = { v = "1" }
deviations = { p = "s_p" }
"""
MODELS = read_models(tomllib.loads(TOML))
DECAY = read_models(
    tomllib.loads("""
[symbols]
x = { unit = "m", low = -1e4, high = 1e4 }
v = { unit = "m/s", low = -300, high = 300 }
a = { unit = "1/s", low = 0.01, high = 1 }
T = { unit = "s", low = 0.1, high = 10 }
[[model]]
name = "decay"
measured = ["x", "v"]
parameters = ["a", "T"]
outputs = { x1 = "x + v*(1 - exp(-a*T))/a", v1 = "v*exp(-a*T)" }
units = { x1 = "m", v1 = "m/s" }
""")
)
COVARIANCE = "flat.covariance.linear"


def covariance(r: float, b: float, s_r: float, s_b: float) -> Any:
    slopes = np.array([[math.cos(b), -r * math.sin(b)], [math.sin(b), r * math.cos(b)], [0.0, 0.0]])
    return slopes @ np.diag([s_r**2, s_b**2]) @ slopes.T


def test_of_a_coordinate_without_error_the_covariance_is_right_and_its_diagonal_alone_is_told() -> None:
    assert diagnose(covariance, COVARIANCE, models=MODELS).agrees
    found = diagnose(lambda r, b, s_r, s_b: np.diag(covariance(r, b, s_r, s_b)), COVARIANCE, models=MODELS)
    assert "the diagonal of the result alone" in found.convention
    wrong = diagnose(lambda r, b, s_r, s_b: covariance(r, b, 2 * s_r, s_b), COVARIANCE, models=MODELS)
    assert wrong.verdict == "slip"


@pytest.mark.parametrize("size", [1, 2, 4])
def test_a_result_of_another_shape_is_refused_with_what_is_wanted(size: int) -> None:
    with pytest.raises(CannotDiagnose, match=rf"returns an array of shape \({size}, {size}\).*\(3, 3\) is wanted"):
        diagnose(lambda r, b, s_r, s_b: np.eye(size) * (r + b + s_r + s_b), COVARIANCE, models=MODELS)


def test_digits_that_are_lost_where_a_wave_vanishes_are_told_without_a_warning_and_no_code_is_named() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = diagnose(lambda p, f: math.sin(2 * math.pi * f * p), "wave.map", models=MODELS)
    assert found.agrees
    assert found.lost_digits is not None
    assert found.lost_digits.instead == ""
    assert "keeps" not in str(found)


def flat_covariance(z: Any, R: Any) -> Any:
    r, b = z
    jacobian = np.array([[math.cos(b), -r * math.sin(b)], [math.sin(b), r * math.cos(b)], [0, 0]])
    return jacobian @ R @ jacobian.T


def test_deviations_of_any_name_are_passed_as_a_covariance_matrix_and_slips_in_it_are_found() -> None:
    found = diagnose(flat_covariance, COVARIANCE, models=MODELS)
    assert found.agrees, str(found)
    assert found.arguments[1] == "R: the covariance matrix of s_r, s_b"

    def slipped(r: float, b: float, std_r: float, std_b: float) -> Any:
        return flat_covariance((r, b), np.diag([std_r**2, std_b]))

    assert diagnose(slipped, COVARIANCE, models=MODELS).convention == "variances in place of s_b"


def test_a_name_that_may_mean_a_symbol_leaves_it_to_the_parameter_that_has_its_name() -> None:
    """tau is a period where nothing else is; beside T it is a time constant."""

    def moved(state: Any, tau: float, T: float) -> Any:
        return np.array([[1, tau * (1 - math.exp(-T / tau))], [0, math.exp(-T / tau)]]) @ state

    found = diagnose(moved, "decay.map", models=DECAY)
    assert found.convention == "1/a in place of a"
    assert found.arguments == ("state: (x, v)", "tau: 1/a", "T: T")


def test_a_symbol_that_a_function_has_as_a_constant_is_named() -> None:
    def moved(x: float, v: float, T: float) -> Any:
        return x + v * 10 * (1 - math.exp(-T / 10)), v * math.exp(-T / 10)

    with pytest.raises(CannotDiagnose, match=r'the function takes no a; say the value it has: given=\{"a": \.\.\.\}'):
        diagnose(moved, "decay.map", models=DECAY)
    assert diagnose(moved, "decay.map", models=DECAY, given={"a": 0.1}).verdict in {"agrees", "loses_digits"}
