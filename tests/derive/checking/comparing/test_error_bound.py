"""A bound is proved only where it holds everywhere, also between the points that a search tries."""

import math

import mpmath
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.comparing.error_bound import proved_within
from radartrack.derive.evaluation.many_digits import evaluate
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import ONE

X = Variable("x", "a number", ONE, -2.0, 2.0)
P = Variable("p", "a positive number", ONE, 0.5, 3.0)
LEAVES = st.sampled_from([X, P, sp.Integer(2), sp.Rational(1, 3), sp.pi])


def _grown(inner: st.SearchStrategy[Expr]) -> st.SearchStrategy[Expr]:
    return st.one_of(
        st.builds(lambda a, b: a + b, inner, inner),
        st.builds(lambda a, b: a * b, inner, inner),
        st.builds(lambda a: sp.sin(a) - sp.cos(2 * a), inner),
        st.builds(lambda a: 1 / (1 + a**2), inner),
        st.builds(lambda a: sp.sqrt(a**2 + 1), inner),
    )


@given(st.recursive(LEAVES, _grown, max_leaves=5), st.integers(0, 40), st.integers(0, 40))
@settings(max_examples=30, deadline=None)
def test_no_bound_is_proved_below_a_value(expression: Expr, i: int, j: int):
    point: dict[Symbol, float] = {X: X.low + (X.high - X.low) * i / 40, P: P.low + (P.high - P.low) * j / 40}
    value = abs(float(evaluate(expression, point)))
    assert not proved_within(expression, value * 0.999 - 1e-12, [X, P], most=5_000)


@pytest.mark.parametrize("place", ["0.1234567", "-1.7", "1.99"])
def test_a_narrow_peak_is_not_overlooked(place: str):
    peak = 1 / (1 + 10**12 * (X - sp.Rational(place)) ** 2)
    assert not proved_within(peak, 0.9, [X], most=30_000)
    assert proved_within(peak, 1.1, [X], most=4_000_000)


@pytest.mark.parametrize(
    ("error", "largest"),
    [
        (sp.sin(X) - X, 2 - math.sin(2)),
        (sp.exp(-(P**2)) * X, 2 * math.exp(-0.25)),
        (sp.sqrt(P) / (1 + P), 0.5),
        (sp.log(P), float(mpmath.log(3))),
    ],
)
def test_a_bound_is_proved_above_the_largest_value_and_not_below(error: Expr, largest: float):
    assert proved_within(error, largest * 1.02, [X, P], most=4_000_000)
    assert not proved_within(error, largest * 0.98, [X, P], most=30_000)


def test_what_has_no_interval_is_not_proved():
    assert not proved_within(sp.atan(X) / 1000, 1.0, [X])
