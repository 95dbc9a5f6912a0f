"""Nesting of sums: the same polynomial, nothing multiplied out, fewer operations."""

from fractions import Fraction

import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive import symbolic as sp
from radartrack.derive.stable.horner import nested

a, b, c, d = (sp.Symbol(name, real=True) for name in "abcd")
Terms = dict[tuple[int, ...], Fraction]


def sums(least: int) -> st.SearchStrategy[Terms]:
    """Of products of powers, none less than the least."""
    powers = st.tuples(*(st.integers(least, 5) for _ in range(3)))
    return st.dictionaries(powers, st.fractions(-3, 3, max_denominator=4).filter(bool), min_size=1, max_size=9)


def polynomial(terms: Terms) -> sp.Expr:
    return sp.Add(*(sp.Rational(n) * a**i * b**j * (1 + c) ** k for (i, j, k), n in terms.items()))


def operations(expression: sp.Expr) -> int:
    """Sums and products, with powers as repeated products; a sign is free."""
    if expression.is_Atom:
        return 0
    inside = sum(map(operations, expression.args))
    if isinstance(expression, sp.Pow):
        return inside + int(expression.exp) - 1
    signs = sum(argument == -1 for argument in expression.args)
    return inside + len(expression.args) - 1 - signs


@given(sums(least=-2))
def test_it_is_the_same_function(terms: Terms) -> None:
    assert sympy.cancel(nested(polynomial(terms)) - polynomial(terms)) == 0


@given(sums(least=0))
def test_without_quotients_it_takes_no_more_operations(terms: Terms) -> None:
    """Of b + b/c, which has one product less than b (1 + 1/c), the same cannot be said."""
    assert operations(nested(polynomial(terms))) <= operations(polynomial(terms))


@given(sums(least=-2), st.sampled_from([(0.3, 0.7, 0.2), (0.9, 0.1, 0.5)]))
def test_positive_terms_stay_positive_terms(terms: Terms, point: tuple[float, float, float]) -> None:
    """What has no cancellation gets none."""
    positive = polynomial({powers: abs(number) for powers, number in terms.items()})
    assert not [number for number in nested(positive).atoms(sp.Rational) if number < 0 and number not in range(-9, 0)]
    assert nested(positive).subs(dict(zip((a, b, c), point, strict=True))) > 0


def test_powers_are_taken_out_one_after_the_other() -> None:
    assert str(nested(a**3 + 2 * a**2 + 3 * a + 4)) == "a*(a*(a + 2) + 3) + 4"


def test_products_of_sums_stay_products() -> None:
    assert nested((a + b) * (c - d)) == (a + b) * (c - d)
    assert str(nested(sp.exp(-a) * (b - c) ** 2 + d * (b - c))) == "(b - c)*(d + (b - c)*exp(-a))"


def test_opposite_sums_are_written_with_the_same_signs() -> None:
    first, second = nested(a * b - a * c), nested(d * c - d * b)
    assert first == a * (b - c)
    assert second == -d * (b - c)


def test_functions_are_nested_inside() -> None:
    assert nested(sp.sqrt(a * b + a * c)) == sp.sqrt(a * (b + c))
