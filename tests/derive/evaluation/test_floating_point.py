"""Bounds found in floating point hold what many digits say, and spare none of what would be the worst."""

import math
from random import Random

import pytest
import sympy

from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.comparing.counterexample import SAME, Relative, worst_over_domain
from radartrack.derive.checking.comparing.question_domain import Domain
from radartrack.derive.evaluation.floating_point import RoughEvaluator
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.evaluation.points import domain_points, round_points
from radartrack.derive.language.tensor import Tensor

NAMES = (
    "polar.decorrelated.covariance",
    "spherical.covariance.truth",
    "ruv.bias.averaged.second_order",
    "line.hessian",
)
x, y = sympy.symbols("x y", real=True)


@pytest.mark.parametrize("name", NAMES)
def test_the_true_value_lies_within_the_bound_all_over_the_domain(name: str) -> None:
    quantity = catalogue()[name]
    entries = quantity.expression.entries
    exact = Evaluator(Tensor((len(entries),), entries), quantity.symbols)
    rough = RoughEvaluator(entries, quantity.symbols)
    compared = 0
    for point in domain_points(quantity.symbols, 30):
        values = [point[symbol.name] for symbol in quantity.symbols]
        for (value, error), true in zip(rough(values) or (), exact(values), strict=False):
            compared += 1
            assert abs(value - true) <= error
    assert compared > 20 * len(entries)


def test_what_cancels_is_known_to_be_uncertain() -> None:
    found = RoughEvaluator([(x + y) - sympy.cos(x) - y + sympy.sqrt(y)], [x, y])([1e-9, 1e9])
    assert found is not None
    ((value, error),) = found
    assert 0 < error < 1e-5
    assert abs(value - (1e-9 - 1 + math.sqrt(1e9))) <= error


@pytest.mark.parametrize(
    ("expression", "point"),
    [(sympy.sqrt(x), -1.0), (sympy.exp(x), 1e4), (sympy.log(x), 0.0), (1 / x, 0.0), (x**20 * x**20, 1e20)],
)
def test_what_has_no_finite_value_has_no_bound(expression: sympy.Expr, point: float) -> None:
    assert RoughEvaluator([expression], [x])([point]) is None


def test_a_root_of_what_may_be_negative_for_all_that_is_known_has_no_bound() -> None:
    nothing = sympy.sqrt(sympy.cos(x) ** 2 + sympy.sin(x) ** 2 - 1)
    assert RoughEvaluator([nothing], [x])([0.3]) is None


@pytest.mark.parametrize("name", NAMES[:3])
def test_no_point_of_the_domain_is_worse_than_the_worst(name: str) -> None:
    quantity = catalogue()[name]
    derived = quantity.expression.entries[-1]
    symbols = quantity.symbols
    for extra in (symbols[0] * derived / 7, Random(1).choice(symbols) ** 2, sympy.cos(symbols[1]) * derived):
        relative = Relative(derived + extra, derived, derived**2, symbols)
        worst = worst_over_domain(relative, Domain(symbols), next(round_points(symbols)))
        assert relative.at(worst.point) == worst
        for point in domain_points(symbols, 40):
            assert relative.at(point).relative <= worst.relative * (1 + SAME)


def test_a_difference_that_is_the_same_everywhere_is_shown_at_the_round_point() -> None:
    quantity = catalogue()["polar.covariance.truth"]
    derived = quantity.expression[0, 0]
    start = next(round_points(quantity.symbols))
    relative = Relative(2 * derived, derived, derived**2, quantity.symbols)
    worst = worst_over_domain(relative, Domain(quantity.symbols), start)
    assert worst.point == start
    assert worst.relative == pytest.approx(1)
