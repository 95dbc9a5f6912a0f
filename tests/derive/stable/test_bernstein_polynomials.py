"""Sums of terms of one sign for polynomials in attenuations."""

from fractions import Fraction

import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive import symbolic as sp
from radartrack.derive.stable.bernstein_polynomials import Decay, bernstein
from tests.examples import share

DECAYS = tuple(Decay.of((n,), s**2, Fraction(1)) for n, s in enumerate(sympy.symbols("a b", positive=True)))


@given(
    st.dictionaries(
        st.tuples(st.integers(-3, 4), st.integers(-3, 4)),
        st.fractions(-5, 5, max_denominator=7).filter(bool),
        max_size=5,
    )
)
@share(0.4)
def test_bernstein_is_the_polynomial_that_it_was_given(coefficients: dict[tuple[int, int], Fraction]):
    rewritten = bernstein(frozenset(coefficients.items()), DECAYS).expression
    shortfalls = {decay.shortfall: 1 - decay.attenuation for decay in DECAYS}
    expected = sum(
        sympy.Rational(c) * DECAYS[0].attenuation ** m * DECAYS[1].attenuation ** n
        for (m, n), c in coefficients.items()
    )
    assert sympy.expand(sp.Integer(0) + rewritten.subs(shortfalls) - expected) == 0


@given(root=st.fractions(Fraction(1, 10), Fraction(9, 10), max_denominator=20), margin=st.integers(1, 5))
@share(0.4)
def test_what_is_positive_between_zero_and_one_ends_as_a_sum_that_hardly_cancels(root: Fraction, margin: int):
    """(q − root)² + margin; its own terms, with −2 root q among them, would cancel."""
    coefficients = {(2,): Fraction(1), (1,): -2 * root, (0,): root**2 + margin}
    rewritten = bernstein(frozenset(coefficients.items()), DECAYS[:1]).expression
    for attenuation in (Fraction(1, 1000), root, Fraction(999, 1000)):
        at = {DECAYS[0].attenuation: sympy.Rational(attenuation), DECAYS[0].shortfall: 1 - sympy.Rational(attenuation)}
        terms = [term.subs(at) for term in sympy.Add.make_args(sympy.expand(rewritten))]
        assert sum(map(abs, terms)) <= 3 * sum(terms)
