"""A quantity as a NumPy function in a module."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy

from radartrack.derive import symbolic as sp
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.source import Source
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable, length
from radartrack.derive.stable.attenuation import stable_form
from radartrack.derive.units import METRE, ONE
from radartrack.derive.writing.numpy_writer import Function, body, docstring, module_text
from tests.written import module_of

r = length("r", "a length")
a = Variable("a", "a number", ONE, -1.0, 1.0)
SOURCE = Source("Somebody", 1998, "(7)")


def function(*entries: sympy.Expr, shape: tuple[int, ...], symbols: tuple[Variable, ...] = (r, a)) -> Function:
    tensor = Tensor(shape, entries)
    axes = tuple((METRE,) * size for size in shape)
    quantity = Quantity("any.thing", "a thing", axes, symbols, Conditioning.TRUTH, SOURCE, "some word", lambda: tensor)
    return Function(quantity, body(quantity, StableForm({}, tensor)))


def module(*functions: Function):
    text = module_text("Things", functions, {f.quantity.name: "measured." for f in functions})
    return text, functions


def test_repeated_and_constant_entries_broadcast(tmp_path: Path):
    text, _ = module(function(sp.sin(a) * r, sp.Integer(0), sp.sin(a) * r, sympy.Rational(1, 3), shape=(2, 2)))
    assert text.count("np.sin") == 1
    result = module_of(text, tmp_path).thing(r=np.ones((3, 1)), a=np.zeros(4) + 0.5)
    assert result.shape == (3, 4, 2, 2)
    np.testing.assert_array_equal(result[2, 3], [[np.sin(0.5), 0], [np.sin(0.5), 1 / 3]])


def test_scalars_and_single_arguments(tmp_path: Path):
    text, _ = module(function(r**2, shape=(), symbols=(r,)))
    thing = module_of(text, tmp_path).thing
    assert thing(r=3) == 9.0
    assert isinstance(thing(r=3), np.float64)
    assert thing(r=np.ones((2, 3))).shape == (2, 3)


def test_a_formula_without_symbols_is_a_number(tmp_path: Path):
    text, _ = module(function(sp.sqrt(1 - 2 / sp.pi), shape=(), symbols=()))
    value = module_of(text, tmp_path).thing()
    assert value == pytest.approx(float(sp.sqrt(1 - 2 / sp.pi)), rel=1e-15)


def test_what_vanishes_is_guarded_without_a_warning(tmp_path: Path):
    text, _ = module(function(sp.ratio(a, r), shape=(), symbols=(a, r)))
    thing = module_of(text, tmp_path).thing
    np.testing.assert_array_equal(thing(a=[1.0, 3.0], r=[0.0, 2.0]), [0.0, 1.5])
    assert thing(a=1.0, r=0.0) == 0.0
    assert thing(a=np.array([3], np.float32), r=np.array([2], np.float32)).dtype == np.float32


def test_the_digest_is_of_the_code_alone():
    plain = function(r * a, shape=())
    other_words = Function(replace(plain.quantity, meaning="another", source=Source("Else", 2000)), plain.body)
    other_code = function(r * a + 1, shape=())
    assert plain.digest == other_words.digest != other_code.digest
    assert plain.text("x") != other_words.text("x")


def test_the_header_changes_with_the_code_and_not_with_the_accuracy():
    first, other = function(r * a, shape=()), function(r * a + 1, shape=())
    headers = [
        module_text("Things", [f], {"any.thing": text})[:200]
        for f, text in ((first, "1."), (first, "2."), (other, "1."))
    ]
    assert headers[0] == headers[1] != headers[2]


def test_the_docstring_says_where_the_formula_stands_and_what_its_arguments_are():
    text = docstring(function(r * a, a, shape=(2,)).quantity, "measured well.")
    for fact in ("A thing.", "any.thing", "some word", "Somebody 1998 (7)", "truth-conditioned", "(2)", "unit m"):
        assert fact in text
    assert "r: a length [m], 1 to 1e+08." in text
    assert "Accuracy: measured well." in text
    assert max(map(len, text.splitlines())) <= 106


def test_arguments_are_the_symbols_by_keyword_in_their_order():
    lines = function(r * a, shape=()).text("x").splitlines()
    assert lines[0] == "def thing(*, r: npt.ArrayLike, a: npt.ArrayLike) -> Floats:"


def test_public_names_are_listed():
    text, _ = module(function(r * a, shape=()))
    assert '__all__ = [\n    "thing",\n]' in text


def test_a_symbol_may_be_called_like_an_intermediate(tmp_path: Path):
    odd = Variable("cos_a", "a number called like the cosine of another", ONE, -1.0, 1.0)
    tensor = Tensor((), (sp.cos(a) ** 2 + odd,))
    quantity = Quantity("any.thing", "a thing", (), (a, odd), Conditioning.TRUTH, SOURCE, "some word", lambda: tensor)
    text, _ = module(Function(quantity, body(quantity, stable_form(tensor))))
    assert module_of(text, tmp_path).thing(a=0.3, cos_a=2.0) == pytest.approx(np.cos(0.3) ** 2 + 2.0, rel=1e-15)
