"""How many terms an expression has when it is multiplied out is bounded without doing it."""

from typing import Any

import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.algebra.multiplied_out import CEILING, terms

x, y, z = sympy.symbols("x y z", positive=True)
polynomials: st.SearchStrategy[Any] = st.recursive(
    st.sampled_from([x, y, z, x + 1, y - z, x * y + 2]),
    lambda inner: (
        st.builds(lambda a, b: a + b, inner, inner)
        | st.builds(lambda a, b: a * b, inner, inner)
        | st.builds(lambda a, n: a**n, inner, st.integers(1, 4))
    ),
    max_leaves=4,
)


@given(polynomials)
def test_there_are_never_more_terms_than_the_bound(polynomial: Any):
    assert len(sympy.Add.make_args(sympy.expand(polynomial))) <= terms(polynomial)


@given(st.integers(1, 12), st.integers(1, 5))
def test_a_power_of_a_sum_of_different_symbols_is_counted_exactly(power: int, count: int):
    total = sympy.Add(*sympy.symbols(f"a:{count}", positive=True))
    assert terms(total**power) == len(sympy.Add.make_args(sympy.expand(total**power)))


def test_waves_are_two_exponentials_each_and_what_is_huge_is_not_counted_further():
    waves = sympy.Mul(*(sympy.cos(n * x) for n in range(1, 11)))
    assert terms(waves) == 2**10
    assert terms(sympy.Mul(*((x + n) for n in range(200)))) == CEILING
