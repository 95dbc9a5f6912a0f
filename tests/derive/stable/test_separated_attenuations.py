"""The shortest form of a polynomial in several attenuations in which nothing cancels."""

from collections.abc import Mapping
from fractions import Fraction
from math import prod

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.stable import separated_attenuations
from radartrack.derive.stable.bernstein_polynomials import Decay, Monomial, bernstein
from radartrack.derive.stable.separated_attenuations import without_cancellation
from radartrack.derive.stable.term_sizes import term_sizes
from tests.examples import share

DECAYS = tuple(Decay.of((n,), s**2, Fraction(1)) for n, s in enumerate(sympy.symbols("a b c", positive=True)))
Polynomial = dict[Monomial, Fraction]
ONE = Fraction(1)
SHORTFALLS: tuple[Polynomial, ...] = ({(0, 0): ONE, (1, 0): -ONE}, {(0, 0): ONE, (0, 1): -ONE})
ALLOWED = 30  # times: two bits for each of several factors; what cancels loses 1e5 times as much at these places


def written(polynomial: Polynomial) -> sympy.Expr:
    return without_cancellation(frozenset(polynomial.items()), DECAYS[: len(next(iter(polynomial)))])


def length(expression: sympy.Expr) -> int:
    return sum(len(part.args) for part in sympy.preorder_traversal(expression) if part.is_Add)


def product(*factors: Polynomial) -> Polynomial:
    found: Polynomial = {(0,) * len(next(iter(factors[0]))): Fraction(1)}
    for factor in factors:
        terms = [(tuple(map(sum, zip(p, q, strict=True))), x * y) for p, x in found.items() for q, y in factor.items()]
        found = {powers: sum((y for q, y in terms if q == powers), Fraction(0)) for powers, _ in terms}
    return found


def total(*polynomials: Polynomial) -> Polynomial:
    keys = {powers for one in polynomials for powers in one}
    return {powers: sum((one.get(powers, Fraction(0)) for one in polynomials), Fraction(0)) for powers in keys}


def point(shortfalls: Mapping[int, Fraction]) -> dict[sympy.Symbol, sympy.Rational]:
    found: dict[sympy.Symbol, sympy.Rational] = {}
    for n, shortfall in shortfalls.items():
        found |= {DECAYS[n].attenuation: 1 - sympy.Rational(shortfall), DECAYS[n].shortfall: sympy.Rational(shortfall)}
    return found


def value(polynomial: Polynomial, shortfalls: Mapping[int, Fraction]) -> Fraction:
    terms = (c * prod((1 - shortfalls[d]) ** n for d, n in enumerate(powers)) for powers, c in polynomial.items())
    return sum(terms, Fraction(0))


polynomials = st.integers(2, 3).flatmap(
    lambda decays: st.dictionaries(
        st.tuples(*[st.integers(-3, 4) if decays == 2 else st.integers(-1, 2)] * decays),
        st.fractions(-5, 5, max_denominator=7).filter(bool),
        min_size=1,
        max_size=5,
    )
)
shares = st.sampled_from([Fraction(1, 10**12), Fraction(1, 10**5), Fraction(1, 7), Fraction(2, 3), Fraction(99, 100)])


@given(polynomials, st.lists(st.integers(1, 10**9), min_size=9, max_size=9))
@share(0.2)
def test_what_is_written_is_the_polynomial_that_was_given(polynomial: Polynomial, places: list[int]):
    """By exact values at points that no polynomial of such a degree knows."""
    for first in (0, 3, 6):
        shortfalls = {d: Fraction(place, 10**9 + 7) for d, place in enumerate(places[first : first + 3])}
        found = sympy.Rational(written(polynomial).subs(point(shortfalls)))
        assert Fraction(int(found.p), int(found.q)) == value(polynomial, shortfalls)


@given(polynomials, st.tuples(shares, shares, shares))
@share(0.1)
def test_terms_are_hardly_larger_than_those_of_the_form_of_one_degree(
    polynomial: Polynomial, places: tuple[Fraction, ...]
):
    whole = bernstein(frozenset(polynomial.items()), DECAYS[: len(next(iter(polynomial)))])
    at = point(dict(enumerate(places)))
    size, before = (sympy.Rational(term_sizes(one).subs(at)) for one in (written(polynomial), whole.expression))
    assert size <= ALLOWED * max(before, abs(sympy.Rational(whole.expression.subs(at))))


@given(
    st.lists(
        st.tuples(*[st.tuples(st.integers(0, 2), st.integers(-2, 2))] * 2, st.fractions(Fraction(1, 5), 5)),
        min_size=1,
        max_size=3,
    ),
    st.tuples(shares, shares),
)
@share(0.4)
def test_a_sum_of_products_of_shortfalls_cancels_nowhere(
    parts: list[tuple[tuple[int, int], tuple[int, int], Fraction]], places: tuple[Fraction, Fraction]
):
    """However much smaller one error is than the other: what vanishes with it has it as a factor."""
    polynomial = total(*(
        product(
            *[SHORTFALLS[0]] * first[0],
            *[SHORTFALLS[1]] * second[0],
            {(first[1], second[1]): coefficient},
        )
        for first, second, coefficient in parts
    ))  # fmt: skip
    polynomial = {powers: c for powers, c in polynomial.items() if c}
    at = point(dict(enumerate(places)))
    exact = value(polynomial, dict(enumerate(places)))
    assert sympy.Rational(term_sizes(written(polynomial)).subs(at)) <= ALLOWED * sympy.Rational(exact)


@pytest.mark.parametrize(
    ("polynomial", "most"),
    [
        (product({(-1, -1): ONE, (1, 1): -ONE}, {(-1, 0): ONE, (3, 0): ONE}), 8),
        (product({(0, -1): ONE, (0, 3): -ONE}, {(-2, 0): ONE, (4, 0): -ONE}), 12),
        ({(-2, -2): ONE, (0, 0): Fraction(-7, 4), (0, 4): ONE / 4, (4, 0): ONE / 4, (4, 4): ONE / 4}, 24),
    ],
    ids=["factors of both", "a factor of each", "what each adds"],
)
def test_what_has_factors_or_parts_is_short(polynomial: Polynomial, most: int):
    """The third is the variance of an unbiased estimate in space across the direction of the plot."""
    whole = bernstein(frozenset(polynomial.items()), DECAYS[:2])
    assert length(written(polynomial)) <= most < whole.terms


def test_a_sum_of_changing_sign_is_in_parts_only_where_these_are_no_larger(monkeypatch: pytest.MonkeyPatch):
    """The covariance of the same estimate, which is negative for small errors and positive for large ones."""
    polynomial: Polynomial = {(-2, -1): ONE, (0, 0): Fraction(-2), (4, 0): ONE / 2, (4, 2): ONE / 2}
    whole = bernstein(frozenset(polynomial.items()), DECAYS[:2])
    assert whole.sign == 0
    assert length(written(polynomial)) < whole.terms
    monkeypatch.setattr(separated_attenuations, "MORE", 0)
    without_cancellation.cache_clear()
    assert written(polynomial) == whole.expression
    without_cancellation.cache_clear()
