"""Expressions are ordered by what is printed, whatever was printed before."""

from random import Random

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.term_order import by_name
from radartrack.derive.catalogue import catalogue

NAMES = ("polar.covariance.averaged", "ruv.jacobian", "finite_sample.degree2.range_rate.covariance")


def parts() -> list[sp.Expr]:
    """Everything that formulas of several kinds are made of, in some order."""
    found = {part for name in NAMES for e in catalogue()[name].expression for part in walk(e)}
    return sorted(found, key=lambda part: Random(str(part)).random())


def walk(expression: sp.Expr) -> list[sp.Expr]:
    return [expression, *(part for argument in expression.args for part in walk(argument))]


def test_numbers_come_first_and_the_rest_as_printed() -> None:
    assert len(parts()) > 100
    assert by_name(parts()) == sorted(parts(), key=lambda part: (not part.is_Number, str(part)))


def test_the_order_given_makes_no_difference() -> None:
    assert by_name(reversed(parts())) == by_name(parts())
