"""Which layer notices which fault."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.stable.quantity_form import form_of
from radartrack.verification.layers.dimensions import Dimensions
from radartrack.verification.layers.identity import Identity
from radartrack.verification.layers.monte_carlo import MonteCarlo
from radartrack.verification.layers.quadrature import Quadrature
from radartrack.verification.layers.ulp_search import Accuracy
from radartrack.verification.outcome import Layer, Verdict, examined
from radartrack.verification.program_compilation import compiled

LAYERS: list[Layer] = [Dimensions(), Identity(), Accuracy(points=60), Quadrature(), MonteCarlo(draws=1 << 20)]
NUMERIC = {"ulp", "quadrature", "Monte Carlo"}
Function = Callable[..., Any]


def off_diagonal_sign(values: np.ndarray, **_: Any) -> np.ndarray:
    return values * np.array([[1.0, -1.0], [-1.0, 1.0]])


def standard_deviations(values: np.ndarray, **_: Any) -> np.ndarray:
    return np.sign(values) * np.sqrt(np.abs(values))


def exchanged_coordinates(values: np.ndarray, **_: Any) -> np.ndarray:
    return values[..., ::-1, ::-1]


def degrees(_right: np.ndarray, **arguments: Any) -> np.ndarray:
    return function_of("polar.covariance.truth")(**(arguments | {"beta": np.degrees(arguments["beta"])}))


def last_digits(values: np.ndarray, **_: Any) -> np.ndarray:
    return values * (1 + 1e-13)


def seven_digits(values: np.ndarray, **_: Any) -> np.ndarray:
    return values * (1 + 1e-7)


def fourth_order(_right: np.ndarray, **arguments: Any) -> np.ndarray:
    return function_of("polar.covariance.linear")(**arguments)


def no_number(values: np.ndarray, **_: Any) -> np.ndarray:
    return values * np.nan


CODE: dict[Function, set[str]] = {
    off_diagonal_sign: NUMERIC,
    standard_deviations: {"dimensions", *NUMERIC},
    exchanged_coordinates: NUMERIC,
    degrees: {"dimensions", *NUMERIC},
    last_digits: {"ulp"},
    seven_digits: {"ulp", "quadrature"},
    fourth_order: NUMERIC,
    no_number: {"dimensions", *NUMERIC},
}
"""A fault of the code → the layers that must notice; the derivation is right, so identities hold."""


def function_of(name: str) -> Function:
    quantity = catalogue()[name]
    return compiled(form_of(quantity).expanded(), quantity.symbols)


def noticed(quantity: Quantity, function: Function) -> set[str]:
    return {layer.name for layer in LAYERS if layer(quantity, function).verdict is Verdict.FAILED}


@pytest.mark.parametrize("fault", CODE, ids=lambda fault: fault.__name__)
def test_a_fault_of_the_code_is_noticed_by_each_layer_that_should_notice_it(fault: Function):
    quantity = catalogue()["polar.covariance.truth"]
    right = function_of(quantity.name)
    assert noticed(quantity, lambda **arguments: fault(right(**arguments), **arguments)) == CODE[fault]


def test_code_that_breaks_down_has_failed():
    def broken(**_: Any) -> np.ndarray:
        raise ZeroDivisionError("no range")

    outcome = examined(Accuracy(points=20), catalogue()["polar.map"], broken)
    assert (outcome.verdict, outcome.detail) == (Verdict.FAILED, "ZeroDivisionError: no range")


@pytest.mark.parametrize("name", ["polar.covariance.truth", "polar.std.linear", "spherical.bias.averaged"])
def test_right_code_passes_every_layer(name: str):
    quantity = catalogue()[name]
    assert noticed(quantity, function_of(quantity.name)) == set()


DERIVATIONS: dict[str, tuple[Callable[[sp.Expr], sp.Expr], set[str]]] = {
    "a factor of two": (lambda _: sp.Integer(2), {"identity", "quadrature", "Monte Carlo"}),
    "a small share": (lambda _: 1 + sp.Rational(1, 10**15), {"identity"}),
    "a length too many": (lambda r: r, {"dimensions", "identity", "quadrature", "Monte Carlo"}),
}


@pytest.mark.parametrize("fault", DERIVATIONS)
def test_a_slip_of_the_derivation_that_the_code_repeats_is_noticed_where_the_definition_is_known(fault: str):
    quantity = catalogue()["polar.covariance.truth"]
    factor, layers = DERIVATIONS[fault]
    wrong = quantity.expression.map(lambda entry: entry * factor(quantity.symbols[0]))
    mistaken = replace(quantity, derivation=lambda: wrong, rewriting=None)
    right, r = function_of(quantity.name), factor(quantity.symbols[0])
    times = compiled(Tensor((), (r,)), quantity.symbols)

    def repeated(**arguments: Any) -> np.ndarray:
        return right(**arguments) * times(**arguments)[..., np.newaxis, np.newaxis]

    known = [layer for layer in LAYERS if layer.name != "ulp"]
    assert {layer.name for layer in known if layer(mistaken, repeated).verdict is Verdict.FAILED} == layers


@pytest.mark.parametrize("name", ["polar.map", "line.slope", "ruv.bias.truth.second_order", "finite_sample.C"])
def test_a_layer_that_does_not_apply_says_why(name: str):
    quantity = catalogue()[name]
    outcomes = [layer(quantity, compiled(quantity.expression, quantity.symbols)) for layer in LAYERS]
    silent = [outcome for outcome in outcomes if outcome.verdict is Verdict.NOT_APPLICABLE]
    assert silent
    assert all(outcome.detail and outcome.figure is None for outcome in silent)
