"""Models, symbols, units, tensors and the catalogue say what they are and refuse what does not fit."""

import copy
import pickle
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.catalogue import UnknownQuantity, catalogue, find
from radartrack.derive.language.model import Model, predicted
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.source import Source
from radartrack.derive.language.tensor import Tensor, indices
from radartrack.derive.language.variable import angle, correlation, deviation, length, speed
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.derive.sensors import models
from radartrack.derive.symbolic import cos, sin
from radartrack.derive.units import METRE, METRE_PER_SECOND, ONE, RADIAN, SECOND, Unit

POLAR = models()["polar"]
r, beta = POLAR.measured
fractions = st.fractions(-3, 3, max_denominator=4)
units = st.builds(Unit, fractions, fractions, fractions)


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        ({"name": "no name"}, "the model's name must be an identifier of Python and no keyword; given 'no name'"),
        ({"measured": (length("lambda", "wavelength"), beta)}, "no keyword; given 'lambda'"),
        ({"measured": (length("np", "power"), beta)}, "which generated code uses; given 'np'"),
        ({"measured": (length("_r", "range"), beta)}, "must not begin with _"),
        ({"measured": (length("predicted_sigma_beta", "range"), beta)}, "a symbol's name must occur once"),
        (
            {"deviations": POLAR.deviations[:1]},
            "deviations must be one for each measured quantity, or none: given 1, measured 2",
        ),
        ({"units": (METRE,)}, "units must be one for each output: given 1 for 2"),
        ({"correlations": {(r, r): POLAR.correlations[r, beta]}}, "two different measured quantities"),
        ({"correlations": {(r, length("q", "other")): POLAR.correlations[r, beta]}}, "two different measured"),
        ({"measured": (r, length("r", "again"))}, "must occur once; given r, r"),
        ({"outputs": {"x": r, "y": length("q", "unknown") + beta}}, "output y may use r, beta only"),
    ],
)
def test_what_does_not_fit_is_named(change: dict[str, Any], complaint: str):
    with pytest.raises(ValueError, match=complaint):
        replace(POLAR, **{"correlations": {}, **change} if "measured" in change else change)


def test_the_covariance_holds_deviations_and_correlations_in_the_order_of_the_measured():
    sigma_r, sigma_beta = POLAR.deviations
    (rho,) = POLAR.correlations.values()
    assert POLAR.covariance == ((sigma_r**2, rho * sigma_r * sigma_beta), (rho * sigma_r * sigma_beta, sigma_beta**2))
    turned = replace(POLAR, correlations={(beta, r): rho})
    assert turned.covariance == POLAR.covariance
    names = [symbol.name for symbol in POLAR.prediction_symbols]
    assert names == ["predicted_sigma_r", "predicted_sigma_beta", "predicted_rho"]
    assert "predict" in predicted(sigma_r).meaning


def test_errors_without_a_correlation_are_independent():
    assert replace(POLAR, correlations={}).covariance[0][1] == 0


def test_a_new_model_of_a_few_lines_gives_every_quantity():
    x = length("x", "depth")
    model = Model("echo", "An echo", (x,), (deviation(x, 0.1, 10),), {"t": x**2}, (METRE**2,), Source("me", None))
    names = {quantity.name for quantity in quantities_of(model)}
    assert {f"echo.{name}" for name in ("map", "bias.truth", "covariance.averaged", "unbiased.estimate")} <= names
    (bias,) = next(q for q in quantities_of(model) if q.name == "echo.bias.truth").expression
    assert bias == model.deviations[0] ** 2


@given(units, units, units, st.integers(-3, 3))
def test_units_multiply_like_powers(a: Unit, b: Unit, c: Unit, n: int):
    assert (a * b) * c == a * (b * c)
    assert a * b == b * a
    assert a * a**-1 == ONE == a / a
    assert (a * b) ** n == a**n * b**n
    assert a ** Fraction(1, 2) * a ** Fraction(1, 2) == a


@pytest.mark.parametrize(
    ("unit", "text"),
    [
        (ONE, "1"),
        (METRE, "m"),
        (METRE_PER_SECOND, "m/s"),
        (METRE**2 / RADIAN, "m^2/rad"),
        (METRE * RADIAN, "m·rad"),
        (SECOND**-1, "1/s"),
        (METRE ** Fraction(1, 2), "m^(1/2)"),
    ],
)
def test_units_are_printed_as_engineers_write_them(unit: Unit, text: str):
    assert str(unit) == text


@pytest.mark.parametrize("symbol", [r, beta, speed("v", "speed"), angle("a", "angle"), correlation("c", r, beta)])
def test_symbols_keep_what_they_know_when_copied_and_pickled(symbol: sympy.Symbol):
    for twin in (copy.copy(symbol), pickle.loads(pickle.dumps(symbol))):  # noqa: S301 - its own
        assert twin == symbol
        assert vars_of(twin) == vars_of(symbol)


def vars_of(symbol: sympy.Symbol) -> list[object]:
    return [symbol.name, symbol.meaning, symbol.unit, symbol.low, symbol.high, symbol.assumptions0]


def test_domains_above_zero_are_positive_in_the_algebra():
    assert sympy.sqrt(r**2) == r
    assert sympy.sqrt(beta**2) == sympy.Abs(beta)
    assert r.logarithmic
    assert not beta.logarithmic
    assert correlation("c", r, beta).is_correlation
    assert not beta.is_correlation


@given(st.lists(st.integers(1, 3), max_size=3))
def test_tensors_are_filled_in_row_major_order(shape: list[int]):
    tensor = Tensor.build(tuple(shape), lambda *index: index)
    assert [index for index, _ in tensor.items()] == list(tensor) == list(indices(tuple(shape)))
    assert all(tensor[index] == index for index in tensor)
    assert list(tensor.map(len)) == [len(shape)] * len(tensor.entries)
    if shape:
        assert [entry for part in tensor.parts() for entry in part] == list(tensor)


def test_models_stand_in_alphabetical_order_under_their_own_names():
    assert list(models()) == sorted(models())
    assert {"polar", "polar_doppler", "spherical"} <= set(models())
    assert all(model.name == name for name, model in models().items())
    assert POLAR.map.entries == (r * cos(beta), r * sin(beta))


def test_every_quantity_has_a_name_of_its_own_and_says_what_it_is_conditioned_on():
    assert all(name == quantity.name for name, quantity in catalogue().items())
    functions = [(quantity.module, quantity.function) for quantity in catalogue().values()]
    assert len(set(functions)) == len(functions)
    for quantity in catalogue().values():
        assert quantity.meaning
        assert quantity.word
        assert str(quantity.source)
        expected = not quantity.name.endswith((".map", ".jacobian", ".hessian"))
        if quantity.module in models() and "validity" not in quantity.name:
            assert (quantity.conditioning is not Conditioning.NONE) == expected


@pytest.mark.parametrize("quantity", [q for q in catalogue().values() if q.module == "polar"], ids=lambda q: q.name)
def test_the_formula_has_the_announced_shape_and_symbols(quantity: Quantity):
    assert quantity.expression.shape == quantity.shape
    used = {symbol for entry in quantity.expression for symbol in entry.free_symbols}
    assert used <= set(quantity.symbols)


@pytest.mark.parametrize(
    ("wrong", "hint"),
    [
        ("polar.bias.avaraged", "did you mean polar.bias.averaged"),
        ("polr.map", "polar.map"),
        ("zzz", "`radartrack list` shows all names"),
    ],
)
def test_unknown_names_are_answered_with_the_nearest(wrong: str, hint: str):
    with pytest.raises(UnknownQuantity) as caught:
        find(wrong)
    assert repr(wrong) in str(caught.value)
    assert hint in str(caught.value)


@pytest.mark.parametrize("printed", [sympy.pycode, sympy.ccode, sympy.fcode, sympy.julia_code, sympy.octave_code])
def test_code_printers_take_a_variable_for_a_symbol(printed: Callable[[sympy.Expr], str]):
    assert "sigma_r" in printed(POLAR.deviations[0] ** 2)


def test_formulas_lambdify():
    function = sympy.lambdify(POLAR.measured, list(POLAR.map), "numpy", cse=True)
    assert function(2.0, 0.0) == [2.0, 0.0]


def test_a_deviation_is_known_by_what_the_model_says_and_by_its_name() -> None:
    spread = length("s", "spread of the range")
    model = replace(POLAR, name="mine", deviations=(spread, POLAR.deviations[1]))
    assert [sigma.deviation_of for sigma in model.deviations] == ["r", "beta"]
    assert [predicted(sigma).deviation_of for sigma in model.deviations] == ["r", "beta"]
    assert model.deviations[0] == spread
    assert spread.deviation_of == ""
    again = pickle.loads(pickle.dumps(model.deviations[0]))  # noqa: S301 - our own
    assert (again.deviation_of, again.on(1.0, 2.0).deviation_of, again.below(3.0).deviation_of) == ("r", "r", "r")
