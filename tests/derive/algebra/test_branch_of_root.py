"""Nested roots: what vanishes for one sign of a root is told from what vanishes for none."""

import pytest

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.branch_of_root import vanishes_on_a_branch
from radartrack.derive.symbolic import Expr

a, b = sp.Symbol("a", positive=True), sp.Symbol("b", positive=True)
w = sp.sqrt(a**2 + b)
DENESTED = [
    (sp.sqrt(2 * a**2 + b + 2 * a * w), a + w),
    (sp.sqrt(2 * a**2 + b - 2 * a * w), w - a),
    (sp.sqrt((a - w) ** 2), a - w),
    (1 / sp.sqrt(2 * a**2 + b + 2 * a * w), (w - a) / b),
    (sp.sqrt(5 + 2 * sp.sqrt(6)) * a, a * (sp.sqrt(2) + sp.sqrt(3))),
]


@pytest.mark.parametrize(("nested", "plain"), DENESTED)
def test_a_nested_root_is_its_plain_form_on_a_branch(nested: Expr, plain: Expr):
    assert vanishes_on_a_branch(nested - plain)
    assert vanishes_on_a_branch(nested + plain)


@pytest.mark.parametrize(("nested", "plain"), DENESTED)
@pytest.mark.parametrize("change", [2, sp.Rational(9, 10), b])
def test_what_is_another_function_vanishes_on_no_branch(nested: Expr, plain: Expr, change: Expr):
    assert not vanishes_on_a_branch(nested - change * plain)
    assert not vanishes_on_a_branch(nested - plain + change)
