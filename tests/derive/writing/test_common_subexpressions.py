"""Common subexpressions: the same results, computed in a possible order, under names that do not collide."""

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.writing.common_subexpressions import with_common_parts
from tests.examples import share
from tests.expressions import exponential_polynomials

x, y = sympy.symbols("x y", real=True)
PART = sympy.Symbol("part", real=True)
expressions = exponential_polynomials(x, y)


def filled_in(definitions: dict[sympy.Symbol, sympy.Expr], results: list[sympy.Expr]) -> list[sympy.Expr]:
    known: dict[sympy.Symbol, sympy.Expr] = {}
    for symbol, definition in definitions.items():
        known[symbol] = definition.xreplace(known)
    return [result.xreplace(known) for result in results]


@given(expressions, st.lists(expressions, min_size=1, max_size=4))
@share(0.3)
def test_filling_the_names_in_again_gives_the_same_results(inner: sympy.Expr, outer: list[sympy.Expr]):
    results = [entry * PART**3 + inner for entry in outer]
    definitions, rewritten = with_common_parts({PART: inner}, results)
    for found, expected in zip(filled_in(definitions, rewritten), results, strict=True):
        assert sympy.expand(found - expected.xreplace({PART: inner})) == 0


@given(expressions, st.lists(expressions, min_size=1, max_size=4))
@share(0.3)
def test_every_part_is_defined_before_it_is_used_and_once(inner: sympy.Expr, outer: list[sympy.Expr]):
    definitions, rewritten = with_common_parts({PART: inner}, [entry * PART for entry in outer])
    allowed = {x, y}
    for symbol, definition in definitions.items():
        assert definition.free_symbols <= allowed
        allowed.add(symbol)
    assert all(result.free_symbols <= allowed for result in rewritten)
    names = [symbol.name for symbol in allowed]
    assert len(set(names)) == len(names)


def test_what_is_computed_twice_is_pulled_out_and_named_after_what_it_is():
    definitions, _ = with_common_parts({}, [sympy.sin(x) + y**2, sympy.sin(x) * y**2 * (x + 1), 1 / (x + 1)])
    assert {str(symbol): str(definition) for symbol, definition in definitions.items()} == {
        "sin_x": "sin(x)",
        "y_squared": "y**2",
        "sum_1": "x + 1",
    }


@pytest.mark.parametrize("name", ["x_squared", "sin_x", "sum_1", "product_1", "term_1"])
def test_names_of_parts_never_collide_with_symbols_that_are_there(name: str):
    taken = sympy.Symbol(name, real=True)
    shared = [sympy.sin(x), x**2, 1 / (x + y), x + y, x * y * sympy.cos(y)]
    results = [sympy.Add(*shared) + taken, sympy.Mul(*shared) * taken, *(part * y + taken for part in shared)]
    definitions, rewritten = with_common_parts({}, results)
    assert name not in {symbol.name for symbol in definitions}
    for found, expected in zip(filled_in(definitions, rewritten), results, strict=True):
        assert sympy.expand(found - expected) == 0
