"""The error measure: what it is measured against, and that it sees an error of known size."""

import math

import numpy as np
import pytest
import sympy
from numpy.typing import ArrayLike

from radartrack.derive.catalogue import find
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.source import Source
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import length
from radartrack.derive.units import METRE, RADIAN, Unit
from radartrack.verification.error_in_ulp import errors

a, b = length("a", "a length"), length("b", "another")
POINT = {"a": np.array([3.0, 1e6]), "b": np.array([4.0, 1e-3])}


def quantity(name: str, axes: tuple[tuple[Unit, ...], ...], *entries: sympy.Expr) -> Quantity:
    shape = tuple(len(axis) for axis in axes)
    tensor = Tensor(shape, entries)
    return Quantity(name, "", axes, (a, b), Conditioning.NONE, Source("nobody", None), "", lambda: tensor)


def found(of: Quantity, *columns: ArrayLike) -> list[float]:
    values = np.stack([np.broadcast_to(column, (2,)) for column in columns], axis=-1).reshape(2, *of.shape)
    return errors(lambda **_: values, of, POINT).tolist()


VECTOR = quantity("any.vector", ((METRE, METRE, RADIAN),), a, b, a / b)
MATRIX = quantity("any.covariance", ((METRE, METRE),) * 2, a**2, 0 * a, 0 * a, b**2)


def test_the_exact_value_has_no_error():
    scalar = quantity("any.scalar", (), a * b)
    assert found(scalar, np.array([12.0, 1000.0])) == [0.0, pytest.approx(0.0, abs=1)]


@pytest.mark.parametrize("ulps", [1, 7, 1000])
def test_a_scalar_is_measured_against_itself(ulps: int):
    scalar = quantity("any.scalar", (), a + 0 * b)
    assert found(scalar, POINT["a"] + ulps * np.spacing(POINT["a"])) == [ulps, ulps]


def test_a_vector_is_measured_against_the_norm_of_what_shares_its_unit():
    off = 8 * np.spacing(np.hypot(POINT["a"], POINT["b"]))
    values = [POINT["a"], POINT["b"] + off, POINT["a"] / POINT["b"]]
    assert found(VECTOR, *values) == pytest.approx([8, 8], rel=0.2)
    values = [POINT["a"], POINT["b"], POINT["a"] / POINT["b"] * (1 + 2.0**-49)]
    assert found(VECTOR, *values) == pytest.approx([8, 8], rel=1)


def test_a_covariance_is_measured_against_the_root_of_both_variances():
    off = 5 * np.spacing(POINT["a"] * POINT["b"])
    assert found(MATRIX, POINT["a"] ** 2, off, 0, POINT["b"] ** 2) == pytest.approx([5, 5], abs=0.6)
    worse = found(MATRIX, POINT["a"] ** 2, 0, 0, POINT["b"] ** 2 + np.spacing(POINT["a"] ** 2))
    assert worse[1] > 1e6


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_what_is_not_finite_is_infinitely_wrong(bad: float):
    assert found(VECTOR, np.full(2, bad), POINT["b"], POINT["a"] / POINT["b"]) == [math.inf, math.inf]


def test_what_should_vanish_and_does_not_is_infinitely_wrong():
    zero = quantity("any.scalar", (), a - a)
    assert found(zero, np.array([0.0, 1e-300])) == [0.0, math.inf]


def test_swapped_results_are_seen_in_a_real_quantity():
    polar = find("polar.map")
    swapped = errors(
        lambda r, beta: np.stack([r * np.sin(beta), r * np.cos(beta)], -1),
        polar,
        {"r": np.array([5.0]), "beta": np.array([0.3])},
    )
    assert swapped[0] > 1e15
