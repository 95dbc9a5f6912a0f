"""What is written is what was derived: a form is proved or refused."""

from dataclasses import replace

import pytest
import sympy

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, ring_over
from radartrack.derive.catalogue import find
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.stable_form import NotProved, StableForm
from radartrack.derive.stable.quantity_form import form_of, readable
from tests import conversions

CLOSED = [q for q in conversions.QUANTITIES if q.module == "polar" and not {"std", "validity"} & set(q.name.split("."))]


@pytest.mark.parametrize("quantity", CLOSED, ids=conversions.ids)
def test_the_readable_form_is_the_derived_one_without_calls_that_nobody_prints(quantity: Quantity):
    ring = ring_over(quantity.symbols)
    for shown, derived in zip(readable(quantity), quantity.expression, strict=True):
        assert not shown.has(sp.expm1)
        assert shown.free_symbols <= set(quantity.symbols)
        assert ExponentialPolynomial.read(shown, ring) == ExponentialPolynomial.read(derived, ring)


def test_a_form_of_ones_own_is_taken_when_it_is_equal():
    quantity = find("polar.map")
    _, beta = quantity.symbols
    c = sympy.Symbol("c")
    own = StableForm({c: sp.cos(beta)}, quantity.expression.map(lambda entry: entry.xreplace({sp.cos(beta): c})))
    assert form_of(replace(quantity, name="polar.own", rewriting=lambda: own)) is own


@pytest.mark.parametrize(("factor", "term"), [(-1, 0), (2, 0), (1, sympy.Rational(1, 10**40))])
def test_a_form_of_ones_own_that_differs_is_not_proved(factor: int, term: sympy.Expr):
    quantity = find("polar.bias.truth")
    wrong = StableForm({}, quantity.expression.map(lambda entry: factor * entry + term))
    with pytest.raises(NotProved):
        form_of(replace(quantity, name="polar.wrong", rewriting=lambda: wrong))


SCALED = [
    find(f"bistatic.{row}") for row in ("map", "jacobian", "bias.second_order", "covariance.linear", "std.linear")
]
PATH = find("bistatic.map").symbols[0]


@pytest.mark.parametrize("quantity", SCALED, ids=conversions.ids)
def test_lengths_over_one_of_them_leave_the_quantity_what_it_was(quantity: Quantity):
    at = {symbol: sympy.Rational(3, 7) for symbol in quantity.symbols} | {PATH: sympy.Integer(2)}
    form = form_of(quantity)
    lengths = {symbol for symbol in quantity.symbols if symbol.unit.metre} - {PATH}
    assert not any(entry.free_symbols & lengths for entry in form.entries)
    for written, derived in zip(form.expanded(), quantity.expression, strict=True):
        assert abs(sympy.N(written.xreplace(at) - derived.xreplace(at), 40, maxn=200)) < 1e-30
