"""Random exact expressions."""

import random
from fractions import Fraction
from typing import Any

import mpmath
import sympy
from hypothesis import strategies as st

from radartrack.derive import symbolic as sp

NUMBERS = st.fractions(min_value=-3, max_value=3, max_denominator=6).map(
    lambda q: sympy.Rational(q.numerator, q.denominator)
)
NONZERO = NUMBERS.filter(bool)


def linear(*symbols: sympy.Symbol) -> st.SearchStrategy[sympy.Expr]:
    """Linear forms."""
    weights = st.tuples(*(NUMBERS for _ in symbols))
    return weights.map(lambda numbers: sympy.Add(*(w * s for w, s in zip(numbers, symbols, strict=True))))


def monomials(*symbols: sympy.Symbol, degree: int = 2) -> st.SearchStrategy[sympy.Expr]:
    """Monomials with a number in front."""
    powers = st.tuples(*(st.integers(0, degree) for _ in symbols))
    products = powers.map(lambda ns: sympy.Mul(*(s**n for s, n in zip(symbols, ns, strict=True))))
    return st.builds(sympy.Mul, NONZERO, products)


def oscillations(*symbols: sympy.Symbol) -> st.SearchStrategy[sympy.Expr]:
    """Functions that are exponentials in disguise, of linear forms."""
    functions = st.sampled_from([sympy.sin, sympy.cos, sympy.exp, sympy.sinh, sympy.cosh, sp.expm1])
    return st.builds(lambda function, form: function(form), functions, linear(*symbols))


def exponential_polynomials(*symbols: sympy.Symbol) -> st.SearchStrategy[sympy.Expr]:
    """Sums of monomials times up to two such functions."""
    factors = st.lists(oscillations(*symbols), max_size=2)
    terms = st.builds(lambda monomial, fs: sympy.Mul(monomial, *fs), monomials(*symbols), factors)
    return st.lists(terms, min_size=1, max_size=3).map(lambda found: sympy.Add(*found))


def rational_points(*symbols: sympy.Symbol) -> st.SearchStrategy[dict[sympy.Symbol, sympy.Rational]]:
    """A small rational for each symbol."""
    return st.fixed_dictionaries(dict.fromkeys(symbols, NUMBERS))


def number(expression: sympy.Expr, point: dict[sympy.Symbol, Any], digits: int = 60) -> mpmath.mpc:
    """The value at a point, by SymPy's own evaluation."""
    plain = expression.replace(sp.expm1, lambda x: sympy.exp(x) - 1)
    plain = plain.replace(sp.hypot, lambda x, y: sympy.sqrt(x**2 + y**2))
    with mpmath.workdps(digits):
        return mpmath.mpmathify(sympy.N(plain.subs(point), digits, maxn=500))


def random_points(symbols: list[sympy.Symbol], count: int, low: Fraction, high: Fraction) -> list[dict[Any, Any]]:
    """The same rational points every time."""
    generator = random.Random(5)
    span = high - low

    def draw() -> sympy.Rational:
        value = low + span * Fraction(generator.randint(1, 999), 1000)
        return sympy.Rational(value.numerator, value.denominator)

    return [{symbol: draw() for symbol in symbols} for _ in range(count)]
