"""Common products: the same results, from no more multiplications, in a possible order."""

import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.writing.common_products import with_common_products
from radartrack.derive.writing.common_subexpressions import with_common_parts
from tests.derive.writing.test_common_subexpressions import PART, expressions, filled_in, x, y
from tests.examples import share

a, b, c, d = sympy.symbols("a b c d", real=True)


def multiplications(definitions: dict[sympy.Symbol, sympy.Expr], results: list[sympy.Expr]) -> int:
    products = [one.atoms(sympy.Mul) for one in [*definitions.values(), *results]]
    return sum(len(product.args) - 1 for some in products for product in some)


@given(expressions, st.lists(expressions, min_size=1, max_size=4))
@share(0.3)
def test_results_are_the_same_and_everything_is_defined_before_it_is_used(inner: sympy.Expr, outer: list[sympy.Expr]):
    results = [entry * PART**3 + inner for entry in outer]
    before = with_common_parts({PART: inner}, results)
    definitions, rewritten = with_common_products(*before)
    for found, expected in zip(filled_in(definitions, rewritten), results, strict=True):
        assert sympy.expand(found - expected.xreplace({PART: inner})) == 0
    allowed = {x, y}
    for symbol, definition in definitions.items():
        assert definition.free_symbols <= allowed
        assert symbol not in allowed
        allowed.add(symbol)
    assert all(result.free_symbols <= allowed for result in rewritten)
    assert multiplications(definitions, rewritten) <= multiplications(*before)


def test_what_most_products_share_is_computed_once():
    definitions, results = with_common_products({}, [2 * a * b * c + d, a * b * d, sympy.sin(a * b * c), a * c / b])
    assert {str(symbol): str(value) for symbol, value in definitions.items()} == {
        "product_1": "a*b",
        "product_2": "c*product_1",
    }
    assert list(map(str, results)) == ["d + 2*product_2", "d*product_1", "sin(product_2)", "a*c/b"]


def test_a_name_that_is_there_is_not_taken_again():
    taken = sympy.Symbol("product_1", real=True)
    definitions, _ = with_common_products({taken: a + b}, [a * b * c * taken, a * b * d])
    assert [str(symbol) for symbol in definitions] == ["product_1", "product_2"]
