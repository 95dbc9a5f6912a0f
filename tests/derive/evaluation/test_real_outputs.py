"""Models of a user's own: derived where they can be, else refused with the symbol and the reason."""

import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from typer.testing import CliRunner, Result

from radartrack.cli import app
from radartrack.derive.evaluation.real_outputs import require_real
from radartrack.derive.language.model import Model
from radartrack.derive.language.source import Source
from radartrack.derive.language.variable import Variable, angle, correlation, deviation, length, speed
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.derive.stable.quantity_form import form_of
from radartrack.derive.symbolic import exact
from radartrack.derive.units import METRE, METRE_PER_SECOND, ONE, RADIAN
from radartrack.derive.writing.numpy_writer import Function, body, module_text
from tests.examples import share
from tests.written import module_of

r: Any = length("r", "range")
b: Any = angle("b", "azimuth")
u: Any = Variable("u", "a number", ONE, 0.5, 1.5)
v: Any = Variable("v", "a number", ONE, 0.5, 1.5)
NUMBERS = (deviation(u, 1e-3, 0.1), deviation(v, 1e-3, 0.1))


def model(**changes: Any) -> Model:
    """Range and azimuth to one coordinate, but for what is changed."""
    parts: dict[str, Any] = {
        "name": "mine",
        "title": "Mine",
        "measured": (r, b),
        "deviations": (deviation(r, 1e-3, 1e3), deviation(b, 1e-6, 0.5)),
        "outputs": {"x": r * sympy.cos(b)},
        "units": (METRE,),
        "source": Source("me", 2026),
    }
    return Model(**parts | changes)


def of_numbers(**outputs: Any) -> Model:
    """A map of two numbers without units."""
    units = (ONE,) * len(outputs)
    return model(measured=(u, v), deviations=NUMBERS, outputs=outputs, units=units)


def function_of(its: Model, word: str, folder: Path) -> Callable[..., np.ndarray]:
    """The generated function, as a user has it."""
    quantity = next(q for q in quantities_of(its) if q.name == f"{its.name}.{word}")
    function = Function(quantity, body(quantity, form_of(quantity)))
    module = module_of(module_text("One function", [function], {quantity.name: "not measured."}), folder)
    found: Callable[..., np.ndarray] = getattr(module, quantity.function)
    return found


@pytest.mark.parametrize(
    ("value", "meant"),
    [
        (0.1, sympy.Rational(1, 10)),
        (2, sympy.Integer(2)),
        (1e-3, sympy.Rational(1, 1000)),
        (0.1 * r, r / 10),
        (r**0.5, sympy.sqrt(r)),
        (sympy.cos(0.25 * b) * 1.5, 3 * sympy.cos(b / 4) / 2),
        (np.float64(0.3), sympy.Rational(3, 10)),
        (sympy.Float("0.1", 40) * r, r / 10),
    ],
)
def test_a_float_is_the_shortest_decimal_that_stands_for_it(value: Any, meant: sympy.Expr):
    assert exact(value) == meant


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_the_shortest_decimal_is_the_float_itself(value: float):
    assert float(exact(value)) == value


WRONG: dict[str, tuple[Callable[[], object], str]] = {
    "absolute value": (
        lambda: model(outputs={"x": r * sympy.Abs(b)}),
        r"output x: Abs\(b\) is not known to have deriv",
    ),
    "sign": (lambda: model(outputs={"x": r * sympy.sign(b)}), r"sign\(b\) is not known"),
    "whole part": (lambda: model(outputs={"x": r * sympy.floor(b)}), r"floor\(b\) is not known"),
    "cases": (lambda: model(outputs={"x": sympy.Piecewise((r, b > 0), (-r, True))}), r"Piecewise\(.* is not known"),
    "the larger": (lambda: model(outputs={"x": sympy.Max(r, 5)}), r"Max\(5, r\) is not known"),
    "imaginary": (lambda: model(outputs={"x": sympy.I * r}), "I is not known"),
    "a variable exponent": (lambda: model(outputs={"x": r * 2**b}), r"in 2\*\*b the exponent is no number"),
    "text": (lambda: model(outputs={"x": "r"}), "output x: it must be an expression or a number; given 'r'"),
    "no number": (lambda: model(outputs={"x": sympy.nan}), "output x: nan is not finite"),
    "infinite": (lambda: model(outputs={"x": math.inf}), "output x: inf is not finite"),
    "a square": (lambda: model(outputs={"x": r**2}), "output x is said to be in m; .* is in m"),
    "a sum of units": (lambda: model(outputs={"x": r + r**2}), "cannot be added"),
    "length and angle": (lambda: model(outputs={"x": r + b}), "cannot be added"),
    "rate for length": (lambda: model(units=(METRE_PER_SECOND,)), "is said to be in m/s; its expression .* is in m"),
    "arc for angle": (lambda: model(outputs={"x": r * b}, units=(RADIAN,)), "is said to be in rad"),
    "exchanged deviations": (
        lambda: model(deviations=(deviation(b, 1e-3, 1), deviation(r, 1e-3, 1))),
        "the deviation of r must have its unit, m",
    ),
    "negative deviations": (lambda: model(deviations=(deviation(r, -1, 1), deviation(b, 0, 1))), "no negative values"),
    "a correlation beyond one": (
        lambda: model(correlations={(r, b): Variable("rho", "correlation", ONE, -2.0, 1.0, is_correlation=True)}),
        "a correlation must be a number from -1 to 1",
    ),
    "a pair twice": (
        lambda: model(correlations={(r, b): correlation("rho", r, b), (b, r): correlation("eta", r, b)}),
        "each pair once",
    ),
    "nothing measured": (lambda: model(measured=(), deviations=()), "measured must name at least one"),
    "an output of two lines": (lambda: model(outputs={"x\ny": r}), "the name of an output must be one line"),
    "no outputs": (lambda: model(outputs={}, units=()), "outputs must name at least one"),
    "an endless domain": (lambda: length("r", "range", high=math.inf), "the domain of r must go from one finite"),
    "a domain of no numbers": (lambda: length("r", "range", low=math.nan), "the domain of r must go from one finite"),
    "a domain upside down": (lambda: length("r", "range", 10, 1), "the domain of r must go .*; given 10 to 1"),
    "an empty domain": (lambda: length("r", "range", 2, 1), "the domain of r"),
    "two lines": (lambda: model(title="one\ntwo"), "the title of mine must be one line of printable text"),
    "an escape": (lambda: length("r", "range \x1b[31m"), "the meaning of r must be one line of printable text"),
    "a surrogate": (lambda: length("r", "range \ud800"), "the meaning of r must be one line"),
    "a source of two lines": (lambda: model(source=Source("a", 1, "b\rc")), "the source of mine must be one line"),
    "no source": (lambda: model(source=Source("", None)), "the source of mine"),
    "a module's name": (
        lambda: model(name="loops"),
        "the model's name must not be conversions nor convert nor elementary nor loops",
    ),
    "another letter in code": (lambda: model(name="ﬁ"), "must be an identifier"),
    "a loop's name": (lambda: model(measured=(length("i", "range"), b)), "which generated code uses; given 'i'"),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_what_cannot_be_a_model_is_refused_on_one_line(wrong: str):
    make, said = WRONG[wrong]
    with pytest.raises((TypeError, ValueError), match=said) as caught:
        make()
    assert str(caught.value).isprintable()


@pytest.mark.parametrize(
    ("output", "said"),
    [
        (r * sympy.sqrt(b), r"output x: sqrt\(b\) is no real number at b = -3.14159, and b is -3.14159 to 3.14159"),
        (r * sympy.log(b), r"log\(b\) is no real number at b = -3.14159"),
        (r * sympy.asin(b), r"asin\(b\) is no real number at b = -3.14159"),
        (r * sympy.sqrt(sympy.cos(b)), r"sqrt\(cos\(b\)\) is no real number at b = "),
        (r * (b + 1) ** sympy.Rational(1, 3), r"\(b \+ 1\)\*\*\(1/3\) is no real number at b = "),
    ],
)
def test_a_map_that_is_real_on_a_part_of_its_domain_says_where_it_is_not(output: sympy.Expr, said: str):
    its = model(outputs={"x": output})
    with pytest.raises(ValueError, match=said):
        require_real(its.outputs.items(), its.arguments, its.measured)


@pytest.mark.parametrize(
    ("output", "said"),
    [
        (r / b, r"output x: 1/b has no value at b = \S+, and b is -3.14159 to 3.14159"),
        (r / sympy.sin(b / 2) ** 2, r"sin\(b/2\)\*\*\(-2\) has no value at b = "),
        (r * sympy.tan(b), r"tan\(b\) has no value at b = -?1.5708"),
        (r**2 / (r - 20), r"1/\(r - 20\) has no value at r = 20"),
    ],
)
def test_a_pole_inside_the_domain_is_named(output: sympy.Expr, said: str):
    its = model(outputs={"x": output})
    with pytest.raises(ValueError, match=said):
        require_real(its.outputs.items(), its.arguments, its.measured)


def test_the_end_of_a_domain_at_which_a_derivative_is_infinite_is_named():
    cosine = Variable("c", "direction cosine", ONE, -1.0, 1.0)
    with pytest.raises(ValueError, match=r"asin\(c\) has no derivative at c = -1, and c is -1 to 1"):
        require_real([("x", sympy.asin(cosine))], [cosine], [cosine])


LEAVES = st.sampled_from([u, v, 0.5, 1.25, sympy.Rational(1, 3), 2])
UNARY = [
    sympy.sin,
    sympy.cos,
    sympy.exp,
    sympy.log,
    sympy.sqrt,
    sympy.atan,
    sympy.asin,
    sympy.tanh,
    sympy.Abs,
    sympy.floor,
    lambda x: x**2,
    lambda x: x**-1.5,
    lambda x: x**0.3,
]


def _larger(parts: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    pairs = st.tuples(parts, parts)
    return st.one_of(
        pairs.map(lambda pair: pair[0] + pair[1]),
        pairs.map(lambda pair: pair[0] * pair[1]),
        pairs.map(lambda pair: pair[0] - 0.75 * pair[1]),
        st.tuples(st.sampled_from(UNARY), parts).map(lambda pair: pair[0](sympy.S.One * pair[1])),
    )


MAPS = st.recursive(LEAVES, _larger, max_leaves=4)
AT = {"u": 0.9, "v": 1.1}


def refusal_of(output: Any) -> str:
    """Why a map of two numbers is no model; empty for one that is."""
    try:
        its = of_numbers(x=output)
        require_real(its.outputs.items(), its.arguments, its.measured)
    except ValueError as error:
        return str(error)
    return ""


@given(MAPS)
@share(0.5)
def test_any_map_is_differentiated_as_numbers_say_or_refused_on_one_line(tmp_path_factory: Any, output: Any):
    refusal = refusal_of(output)
    if refusal:
        assert refusal.startswith("output x")
        assert refusal.isprintable()
        return
    its = of_numbers(x=output)
    h = sympy.lambdify((u, v), output, "mpmath")
    place = tuple(map(mpmath.mpf, AT.values()))
    slopes = [mpmath.diff(h, place, n) for n in ((1, 0), (0, 1))]
    bends = [mpmath.diff(h, place, n) for n in ((2, 0), (0, 2))]
    folder = tmp_path_factory.mktemp("map")
    jacobian = function_of(its, "jacobian", folder)(**AT)
    np.testing.assert_allclose(jacobian[0], np.array(slopes, dtype=float), rtol=1e-6, atol=1e-6)
    bias = function_of(its, "bias.second_order", folder)(**AT, sigma_u=0.1, sigma_v=0.2)
    expected = float((bends[0] * 0.01 + bends[1] * 0.04) / 2)
    np.testing.assert_allclose(bias[0], expected, rtol=1e-5, atol=1e-6)


SMOOTH = {
    "float coefficients": of_numbers(x=0.1 * u * sympy.cos(v), y=0.3 * u**1.0 * sympy.sin(0.5 * v)),
    "an angle squared": of_numbers(x=u * sympy.sin(v * v)),
    "a product of angles": of_numbers(x=sympy.sin(u * v), y=v),
    "an angle and a number": of_numbers(x=u * sympy.cos(v + 0.5)),
    "an angle and a part of pi": of_numbers(x=u * sympy.cos(v + sympy.pi / 4)),
    "exponential growth": of_numbers(x=u * sympy.exp(v)),
    "a bell": of_numbers(x=u * sympy.exp(-(v**2))),
    "a cube root": of_numbers(x=u * (2 + sympy.cos(v)) ** sympy.Rational(1, 3)),
    "a root in a root": of_numbers(x=sympy.sqrt(u + sympy.sqrt(v))),
    "a direction": of_numbers(x=sympy.atan2(u, v), y=sympy.sqrt(u**2 + v**2)),
    "a root beside a product": of_numbers(x=u + sympy.sqrt(u * v), y=v * sympy.sqrt(1 + u / v)),
    "a number": of_numbers(x=5.5),
    "a function of a number": of_numbers(x=(u + 1.25) * sympy.tanh(sympy.Rational(1, 3)), y=v),
}


@pytest.mark.parametrize("name", SMOOTH)
def test_the_bias_is_that_of_quadrature(name: str, tmp_path: Path):
    """To the order to which it is known: exactly, or to the fourth, with errors of a hundredth."""
    its = SMOOTH[name]
    closed = any(quantity.name == "mine.bias.truth" for quantity in quantities_of(its))
    nodes, weights = np.polynomial.hermite_e.hermegauss(12)
    weights = weights / weights.sum()
    sigma = 0.01
    h = sympy.lambdify((u, v), list(its.outputs.values()), "numpy")
    at = np.meshgrid(AT["u"] + sigma * nodes, AT["v"] + sigma * nodes, indexing="ij")
    average = [np.sum(np.outer(weights, weights) * value) for value in h(*at)]
    expected = np.array(average) - np.array(h(*AT.values()), dtype=float)
    word = "bias.truth" if closed else "bias.truth.fourth_order"
    found = function_of(its, word, tmp_path)(**AT, sigma_u=sigma, sigma_v=sigma)
    np.testing.assert_allclose(found, expected, rtol=1e-5, atol=1e-14)


@pytest.mark.parametrize("name", ["a direction", "a root beside a product"])
def test_errors_are_compared_with_what_is_neglected_for_any_map_that_can_be_undone(name: str, tmp_path: Path):
    validity = function_of(SMOOTH[name], "validity.linear", tmp_path)
    found = validity(**AT, sigma_u=1e-3, sigma_v=1e-3), validity(**AT, sigma_u=1e-6, sigma_v=1e-6)
    np.testing.assert_allclose(found[0], 1000 * found[1], rtol=1e-9)
    assert (found[0] < 0.01).all()


def test_two_models_of_one_name_are_not_taken_for_each_other(tmp_path: Path):
    one, other = (function_of(of_numbers(x=factor * u), "map", tmp_path)(**AT) for factor in (2, 3))
    assert (one[0], other[0]) == (2 * AT["u"], 3 * AT["u"])


SPEECH = 'a """ quotation \\N{x} \\ and \\'


def test_words_with_quotes_and_backslashes_stand_in_the_documentation_as_they_are(tmp_path: Path):
    said = length("r", SPEECH)
    its = model(measured=(said, b), title=SPEECH, source=Source(SPEECH, 2026), outputs={"x": said * sympy.cos(b)})
    documentation = function_of(its, "map", tmp_path).__doc__ or ""
    assert documentation.count(SPEECH) == 2


HEAD = """\
import sys
from sympy import *
from radartrack.derive import Model, Source, angle, deviation, length
from radartrack.derive.units import METRE
r, b = length("r", "range"), angle("b", "azimuth")
MODEL = Model("mine", "Mine", (r, b), (deviation(r, 1e-3, 1.0), deviation(b, 1e-6, 0.1)), {"x": %s}, (METRE,),
    Source("me", 2026))
"""


def regenerate(source: str, folder: Path) -> Result:
    path = folder / "model.py"
    path.write_text(source)
    return CliRunner().invoke(app, ["regenerate", "--model", str(path), "--out", str(folder / "out")])


@pytest.mark.parametrize(
    ("source", "said"),
    [
        (HEAD % "r*Abs(b)", "Abs(b) is not known to have derivatives"),
        (HEAD % "r*sqrt(b)", "output x: sqrt(b) is no real number at b = -3.14159"),
        (HEAD % "r**2", "output x is said to be in m"),
        ("import sys\nsys.exit(0)\n", "does not run: SystemExit: 0"),
        ("raise ValueError('one\\ntwo\\x1b[31m')\n", "does not run: ValueError: one two"),
        ("MODEL = 'a\\nb'\n", "MODEL is 'a"),
    ],
)
def test_the_command_refuses_on_one_line_and_writes_nothing(source: str, said: str, tmp_path: Path):
    result = regenerate(source, tmp_path)
    assert result.exit_code == 2
    assert said in result.stderr
    assert len(result.stderr.splitlines()) == 1
    assert result.stderr.strip().isprintable()
    assert not (tmp_path / "out").exists()


def test_what_cannot_be_written_is_refused_with_the_quantity(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    def fails(_: object) -> None:
        raise KeyError("no\nway")

    monkeypatch.setattr("radartrack._regeneration.numpy_modules.form_of", fails)
    result = regenerate(HEAD % "r*cos(b)", tmp_path)
    assert result.exit_code == 2
    assert "Nothing was written: mine.map cannot be derived: 'no" in result.stderr
    assert not (tmp_path / "out").exists()


def test_what_cannot_be_evaluated_over_its_domain_is_refused_with_the_quantity(tmp_path: Path):
    result = regenerate((HEAD % "r*exp(b)").replace("1e-6, 0.1", "1e-6, 1e4"), tmp_path)
    assert result.exit_code == 2
    assert re.search(r"Nothing was written: mine\.\S+ cannot be measured: the exponential of \S+ is not", result.stderr)
    assert not (tmp_path / "out").exists()


def test_the_ends_of_a_domain_may_be_any_real_numbers(tmp_path: Path):
    quarter = angle("q", "a quarter turn", 0, sympy.pi / 2)
    assert (quarter.low, quarter.high) == (0, math.pi / 2)
    deviations = deviation(r, 1, 2), deviation(quarter, 1e-3, 1.0)
    its = model(measured=(r, quarter), deviations=deviations, outputs={"x": r * sympy.cos(quarter)})
    assert "0 to 1.5708" in (function_of(its, "map", tmp_path).__doc__ or "")


def test_a_rate_of_a_speed_may_be_added_to_a_number():
    rate: Any = speed("rate", "range rate")
    model(
        measured=(rate,), deviations=(deviation(rate, 1, 2),), outputs={"x": 2 * rate + 0.5}, units=(METRE_PER_SECOND,)
    )
