"""Generated code against the formula as derived, in arithmetic of fifty digits."""

import json
import re
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

import radartrack.generated
from radartrack.derive.evaluation.balls import exact_arithmetic
from radartrack.derive.language.quantity import Quantity
from radartrack.verification.domain_points import Points, sample
from radartrack.verification.error_in_ulp import errors
from radartrack.verification.rounding.certificates import kept, proved_bounds
from tests import conversions

POINTS = 60
HEADROOM = 1.0
LARGEST = {"polar": 8.0, "bistatic": 24.0}  # whose series have high powers of baseline over path
LARGEST_ELSEWHERE = 16.0
CERTIFICATES = kept()
RECORD = json.loads((Path(radartrack.generated.__path__[0]) / "accuracy.json").read_text())


def exact(quantity: Quantity, points: Points) -> np.ndarray:
    evaluator = exact_arithmetic()[1](quantity.expression, quantity.symbols)
    rows = zip(*(points[symbol.name].tolist() for symbol in quantity.symbols), strict=True)
    return np.array([[float(value) for value in evaluator(row)] for row in rows]).reshape(-1, *quantity.shape)


@pytest.mark.parametrize("quantity", conversions.QUANTITIES, ids=conversions.ids)
def test_the_error_is_the_stated_one_at_points_that_were_not_measured_and_within_the_contract(quantity: Quantity):
    found = errors(
        conversions.generated(quantity), quantity, sample(quantity, POINTS, seed=20), exact_arithmetic()[1]
    ).max()
    assert found <= RECORD[quantity.name]["ulp"] + HEADROOM
    assert found <= LARGEST.get(quantity.module, LARGEST_ELSEWHERE)


@pytest.mark.parametrize("quantity", conversions.QUANTITIES, ids=conversions.ids)
def test_the_docstring_states_the_proved_bound_and_where_there_is_none_the_measured_error(quantity: Quantity):
    text = " ".join((conversions.generated(quantity).__doc__ or "").split())
    bounds = proved_bounds(CERTIFICATES[quantity.name])
    start = "Accuracy: at most" if "double" in bounds else "Accuracy: measured, not proved: at most"
    stated = re.search(rf"{start} (\S+) ulp", text)
    assert stated is not None
    assert float(stated[1]) == pytest.approx(bounds.get("double", RECORD[quantity.name]["ulp"]), rel=1e-4)
    if "double" in bounds:
        correlates = any(symbol.is_correlation for symbol in quantity.symbols)
        assert ("with independent errors" in text) == correlates
        assert ("with correlations up to 0.99" in text) == ("correlated" in bounds)


@pytest.mark.parametrize(
    "quantity",
    [q for q in conversions.QUANTITIES if any(s.is_correlation for s in q.symbols)],
    ids=conversions.ids,
)
def test_correlated_errors_cost_no_digits_beside_the_independent_ones(quantity: Quantity):
    points = sample(quantity, POINTS, seed=21, correlated=True)
    independent = {s.name: points[s.name] * (not s.is_correlation) for s in quantity.symbols}
    expected = exact(quantity, points)
    scale = conversions.scale(quantity, exact(quantity, independent)) + np.abs(expected)
    assert (np.abs(conversions.generated(quantity)(**points) - expected) / scale).max() < 1e-13


def test_the_record_knows_every_generated_function_and_no_other():
    functions = {
        f"{path.stem}.{name}"
        for path in Path(radartrack.generated.__path__[0]).glob("[a-z]*.py")
        for name in getattr(import_module(f"radartrack.generated.{path.stem}"), "__all__", [])
    }
    module_and_function = (name.partition(".") for name in RECORD)
    assert {f"{module}.{function.replace('.', '_')}" for module, _, function in module_and_function} == functions


@pytest.mark.parametrize("quantity", conversions.of("validity.linear", "validity.second_order"), ids=conversions.ids)
@pytest.mark.parametrize("rho", [-1.0, 1.0])
def test_what_is_neglected_keeps_its_digits_at_full_correlation(quantity: Quantity, rho: float):
    points = sample(quantity, POINTS, seed=22)
    points |= {s.name: np.full(POINTS, rho) for s in quantity.symbols if s.is_correlation}
    expected = exact(quantity, points)
    np.testing.assert_allclose(conversions.generated(quantity)(**points), expected, rtol=1e-12)
