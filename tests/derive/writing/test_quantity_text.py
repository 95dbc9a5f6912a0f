"""A formula shown as text, LaTeX or code is the derived formula, read back."""

from pathlib import Path

import numpy as np
import pytest
import sympy

from radartrack.derive.language.quantity import Quantity
from radartrack.derive.reading import FormulaError, read_latex, read_text, to_expression
from radartrack.derive.writing import quantity_text
from radartrack.verification.domain_points import sample
from tests import conversions
from tests.written import module_of

LONG = ("decorrelated", "fourth_order", "semidefinite", "validity")
SHOWN = [
    quantity
    for quantity in conversions.QUANTITIES
    if quantity.module in {"polar", "polar_doppler", "ruv"} and not any(part in quantity.name for part in LONG)
]


def entries(expression: object) -> list[sympy.Expr]:
    return [e for part in expression for e in entries(part)] if isinstance(expression, tuple) else [expression]


def assert_same_function(quantity: Quantity, found: list[sympy.Expr]) -> None:
    point = {name: values[0] for name, values in sample(quantity, 1, seed=3, correlated=True).items()}
    symbols = {symbol: sympy.Rational(float(point[symbol.name])) for symbol in quantity.symbols}
    assert len(found) == len(quantity.expression.entries)
    for shown, derived in zip(found, quantity.expression, strict=True):
        a, b = (sympy.N(e.subs(symbols), 30, maxn=800) for e in (shown, derived))
        assert abs(a - b) <= 1e-25 * (abs(a) + abs(b))


@pytest.mark.parametrize("quantity", SHOWN, ids=conversions.ids)
def test_the_text_is_read_back_as_the_derived_formula(quantity: Quantity):
    symbols = {symbol.name: symbol for symbol in quantity.symbols}
    whole = to_expression(read_text(quantity_text.text(quantity), symbols), symbols)
    assert_same_function(quantity, entries(whole))
    one_by_one = [
        to_expression(read_text(quantity_text.text(quantity, index), symbols), symbols)
        for index in np.ndindex(quantity.shape)
    ]
    assert_same_function(quantity, one_by_one)


@pytest.mark.parametrize("quantity", SHOWN, ids=conversions.ids)
def test_the_latex_of_an_entry_is_read_back_as_the_derived_formula(quantity: Quantity):
    symbols = {symbol.name: symbol for symbol in quantity.symbols}
    found = [
        to_expression(read_latex(quantity_text.latex(quantity, index), symbols), symbols)
        for index in np.ndindex(quantity.shape)
    ]
    assert_same_function(quantity, found)


@pytest.mark.parametrize("quantity", SHOWN, ids=conversions.ids)
def test_the_code_computes_what_the_generated_function_does(quantity: Quantity, tmp_path: Path):
    points = sample(quantity, 5, seed=4)
    expected = conversions.generated(quantity)(**points)
    names = ", ".join(points)
    for index in [None, *np.ndindex(quantity.shape)]:
        statements = quantity_text.python(quantity, index).replace("\n", "\n    ")
        source = f"import numpy as np\n\n\ndef run({names}):\n    {statements}\n    return result\n"
        run = module_of(source, tmp_path).run
        for n, row in enumerate(zip(*points.values(), strict=True)):
            whole = expected[n] if index is None else expected[n][index]
            scale = conversions.scale(quantity, expected[n])
            tolerance = 1e-14 * (scale if index is None else scale[index])
            assert (np.abs(np.asarray(run(*row)) - whole) <= tolerance).all()


@pytest.mark.parametrize(
    ("name", "latex"),
    [
        ("sigma_beta", r"\sigma_{\beta}"),
        ("sigma_r", r"\sigma_{r}"),
        ("rdot", r"\dot{r}"),
        ("sigma_rdot", r"\sigma_{\dot{r}}"),
        ("predicted_sigma_beta", r"\sigma_{\beta}^{p}"),
        ("epsilon", r"\varepsilon"),
        ("rho", r"\rho"),
    ],
)
def test_symbols_are_typeset_as_in_the_literature(name: str, latex: str):
    assert quantity_text.latex_name(sympy.Symbol(name)) == latex


def test_matrices_and_tensors_are_typeset_in_rows():
    jacobian, hessian = (next(q for q in SHOWN if q.name == f"polar.{name}") for name in ("jacobian", "hessian"))
    assert quantity_text.latex(jacobian).count(r"\\") == 1
    assert quantity_text.latex(hessian).count(r"\begin{pmatrix}") == 2


def test_the_reader_refuses_what_is_not_printed():
    with pytest.raises(FormulaError):
        read_text("__import__('os')", ["r"])
