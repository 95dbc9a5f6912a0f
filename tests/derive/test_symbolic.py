"""Functions that stand for what loses digits: one value in every arithmetic, and derivatives that are theirs."""

import math
from inspect import unwrap
from pathlib import Path
from types import ModuleType

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy.core import random

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation import balls
from radartrack.derive.evaluation.many_digits import evaluate
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.writing.numpy_writer import PRELUDE, helpers
from tests.examples import share
from tests.written import module_of

x = sp.Symbol("x", real=True)
ORDERS = st.integers(0, 6)
SIZES = st.floats(-14, 1.5).map(lambda exponent: 10.0**exponent)
SIGNS = st.sampled_from([-1.0, 1.0])


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    folder: Path = tmp_path_factory.mktemp("written")
    return module_of(PRELUDE + helpers("_stumpff( _third("), folder)


def series(at: float, order: int) -> mpmath.mpf:
    with mpmath.workdps(100):
        terms = range(200)
        return mpmath.fsum((-1) ** k * mpmath.mpf(at) ** (2 * k) / mpmath.factorial(order + 2 * k) for k in terms)


def cubic(at: float) -> mpmath.mpf:
    with mpmath.workdps(60):
        roots = mpmath.polyroots([4, 0, -3, -mpmath.mpf(at)], maxsteps=500, extraprec=400)
        return max((mpmath.re(root) for root in roots if abs(mpmath.im(root)) < 1e-40), default=mpmath.nan)


@given(order=ORDERS, size=SIZES, sign=SIGNS)
@share(1.0)
def test_stumpffs_functions_are_their_series_in_every_arithmetic(
    written: ModuleType, order: int, size: float, sign: float
) -> None:
    at = sign * size
    call, expected = sp.stumpff(x, sp.Integer(order)), series(at, order)
    largest = 1 / mpmath.factorial(order)
    assert abs(evaluate(call, {x: at}) - expected) < 1e-50 * largest
    if balls.trustworthy():
        [found] = balls.Balls(Tensor((), (call,)), [x])([at])
        assert abs(float(found) - float(expected)) <= 1e-15 * largest
    assert abs(float(written._stumpff(np.array(at), order)) - float(expected)) <= 1e-15 * max(1.0, size) * largest
    if size < min(order, 3):
        assert float(written._stumpff(np.array(at), order)) == pytest.approx(float(expected), rel=1e-15)


@pytest.mark.parametrize("order", range(7))
def test_stumpffs_functions_are_finite_at_zero_and_plain_elsewhere(written: ModuleType, order: int) -> None:
    call = sp.stumpff(x, sp.Integer(order))
    assert float(evaluate(call, {x: 0.0})) == pytest.approx(1 / math.factorial(order), rel=1e-15)
    assert float(written._stumpff(np.array(0.0), order)) == pytest.approx(1 / math.factorial(order), rel=3e-16)
    assert abs(evaluate(call.expanded(), {x: 1.5}) - series(1.5, order)) < 1e-50


@given(order=st.integers(0, 5), at=st.floats(-3, 3))
@share(0.3)
def test_the_derivative_of_stumpffs_functions_is_that_of_their_series(order: int, at: float) -> None:
    slope = sp.diff(sp.stumpff(x, sp.Integer(order)), x)
    with mpmath.workdps(60):
        terms = range(1, 100)
        expected = mpmath.fsum(
            (-1) ** k * 2 * k * mpmath.mpf(at) ** (2 * k - 1) / mpmath.factorial(order + 2 * k) for k in terms
        )
        assert abs(evaluate(slope, {x: at}) - expected) < mpmath.mpf(10) ** -48


@given(size=st.floats(-6, 11))
@share(0.3)
def test_the_third_part_of_an_angle_solves_its_cubic_in_every_arithmetic(written: ModuleType, size: float) -> None:
    at = 10.0**size
    expected = cubic(at)
    assert evaluate(sp.third(x), {x: at}) == pytest.approx(float(expected), rel=1e-15)
    assert evaluate(sp.third(x).expanded(), {x: at}).real == pytest.approx(float(expected), rel=1e-15)
    assert float(written._third(np.array(at))) == pytest.approx(float(expected), rel=1e-15)
    slope = sp.diff(sp.third(x), x)
    assert evaluate(slope, {x: at}) == pytest.approx(float(1 / (12 * expected**2 - 3)), rel=1e-14)


@given(order=st.integers(2, 6), at=st.floats(-5, 5).filter(lambda value: abs(value) > 0.1))
@share(0.2)
def test_what_is_written_without_digits_lost_is_the_same_function(order: int, at: float) -> None:
    for kind in (sp.stumpff, sp.remainder):
        call = x * kind(2 * x, sp.Integer(order)) + 1
        assert abs(evaluate(sp.unguarded(call), {x: at}) - evaluate(call, {x: at})) < mpmath.mpf(10) ** -45


def test_factors_are_looked_for_in_the_same_way_in_every_process():
    a, b, c = (sp.Symbol(name, real=True) for name in "abc")
    product = sp.expand((a**2 + 3 * b * c - 5) * (b**3 - a * c + 7) * (c**2 * a + b - 2))
    drawn = []
    for seed in (1, 2, 3):
        random.seed(seed)
        unwrap(sp.factor)(product)
        drawn.append(random.rng.getstate())
    random.seed(0)
    assert random.rng.getstate() != drawn[0]  # it draws
    assert drawn[0] == drawn[1] == drawn[2]
