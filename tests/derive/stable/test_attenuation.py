"""Stable forms: the same function, without cancellation, and never unproved."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy
from hypothesis import assume, given
from hypothesis import strategies as st

from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, NotExponentialPolynomial, ring_over
from radartrack.derive.language.stable_form import NotProved, StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.stable import attenuation
from radartrack.derive.stable.attenuation import Wave, stable_form
from radartrack.derive.stable.bernstein_polynomials import Decay
from radartrack.derive.stable.separated_attenuations import without_cancellation
from radartrack.derive.writing.numpy_expression import code
from tests.examples import share
from tests.expressions import NONZERO, number
from tests.written import module_of

r, sigma = sympy.symbols("r sigma", positive=True)
beta, gamma = sympy.symbols("beta gamma", real=True)
q = sympy.Symbol("q", positive=True)
RING = ring_over([r, sigma, beta, gamma])


@pytest.fixture(autouse=True)
def forget_forms():
    """Forms are kept once they are proved; a test that breaks a rule must see it applied."""
    for function in vars(attenuation).values():
        getattr(function, "cache_clear", lambda: None)()


def vector(*entries: sympy.Expr) -> Tensor[sympy.Expr]:
    return Tensor((len(entries),), entries)


@st.composite
def attenuated(draw: st.DrawFn) -> sympy.Expr:
    """Monomials times powers of e^(-σ²), negative ones too, times waves in two angles."""
    terms = []
    for _ in range(draw(st.integers(1, 4))):
        powers = [draw(st.integers(0, 2)) for _ in range(2)]
        wave = draw(st.sampled_from([sympy.Integer(1), sympy.sin, sympy.cos]))
        angle = draw(st.sampled_from([beta, 2 * beta, beta + gamma, 2 * beta - gamma, 3 * gamma]))
        decay = sympy.exp(-draw(st.integers(-2, 4)) * sigma**2 / draw(st.sampled_from([1, 2])))
        terms.append(draw(NONZERO) * r ** powers[0] * sigma ** powers[1] * decay * (wave if wave == 1 else wave(angle)))
    return sympy.Add(*terms)


@given(st.lists(attenuated(), min_size=1, max_size=3))
@share(0.3)
def test_the_form_is_the_same_function(entries: list[sympy.Expr]):
    form = stable_form(vector(*entries))
    point = {
        r: sympy.Rational(7, 2),
        sigma: sympy.Rational(1, 3),
        beta: sympy.Rational(5, 7),
        gamma: -sympy.Rational(9, 8),
    }
    for found, expected in zip(form.expanded(), entries, strict=True):
        assert abs(number(found, point) - number(expected, point)) < 1e-40
        assert ExponentialPolynomial.read(found, RING) == ExponentialPolynomial.read(expected, RING)


@given(st.lists(attenuated(), min_size=1, max_size=3))
@share(0.3)
def test_entries_use_defined_intermediates_and_all_of_them_are_used(entries: list[sympy.Expr]):
    form = stable_form(vector(*entries))
    known = {r, sigma, beta, gamma}
    for symbol, definition in form.definitions.items():
        assert definition.free_symbols <= known
        known.add(symbol)
    used = {s for e in (*form.entries, *form.definitions.values()) for s in e.free_symbols}
    assert set(form.definitions) <= used <= known


@given(
    zeros=st.lists(st.integers(1, 4), min_size=1, max_size=3),
    positive=st.lists(st.tuples(st.integers(0, 4), st.integers(1, 5)), min_size=1, max_size=3),
    shift=st.integers(-3, 3),
)
@share(0.3)
def test_what_vanishes_with_the_error_keeps_its_digits_down_to_the_smallest_errors(
    zeros: list[int], positive: list[tuple[int, int]], shift: int, tmp_path_factory: pytest.TempPathFactory
):
    """q^s · Π(1 − q^k) · Σ c q^n with c > 0, expanded, is positive for 0 < q < 1 and tiny beside its terms near 1."""
    polynomial = sympy.Mul(*(1 - q**k for k in zeros), sum(c * q**n for n, c in positive))
    expanded = sympy.expand(sympy.expand(polynomial) * q**shift)
    form = stable_form(vector(sympy.expand(expanded.subs(q, sympy.exp(-(sigma**2))))))
    lines = [f"    {symbol.name} = {code(definition)}" for symbol, definition in form.definitions.items()]
    source = "\n".join(["import numpy as np", "def run(sigma):", *lines, f"    return {code(form.entries[0,])}"])
    run = module_of(source, tmp_path_factory.mktemp("form")).run
    for error in (1e-9, 1e-5, 0.01, 0.3, 1.0):
        exact = number(polynomial * q**shift, {q: sympy.exp(-(sympy.Rational(error) ** 2))}, 60)
        assert abs(float(run(np.float64(error))) / exact - 1) < 1e-14


def test_the_forms_that_the_method_is_known_for():
    bias = (1 - 2 * sympy.exp(-(sigma**2) / 2) + sympy.exp(-(sigma**2))) * r
    form = stable_form(vector(bias))
    assert str(form.entries[0,]) == "r*shortfall_sigma**2"
    assert [str(definition) for definition in form.definitions.values()] == ["-expm1(-sigma**2/2)"]


@pytest.mark.parametrize("factor", [sympy.Integer(2), sympy.Integer(-1), 1 + sympy.Rational(1, 10**30)])
def test_a_wrong_factor_in_a_rewriting_is_not_proved(monkeypatch: pytest.MonkeyPatch, factor: sympy.Expr):
    right = without_cancellation
    monkeypatch.setattr(attenuation, "without_cancellation", lambda *arguments: factor * right(*arguments))
    with pytest.raises(NotProved):
        stable_form(vector(r * sympy.exp(-(sigma**2)) - r * sympy.exp(-2 * sigma**2)))


def test_a_wrong_wave_is_not_proved(monkeypatch: pytest.MonkeyPatch):
    right = attenuation._unit_circle
    monkeypatch.setattr(attenuation, "_unit_circle", lambda wave, turns, degree: right(wave, -turns, degree))
    with pytest.raises(NotProved):
        stable_form(vector(r * sympy.sin(beta) * sympy.exp(-(sigma**2))))


@pytest.mark.parametrize(("part", "wrong"), [(Wave, sympy.sin), (Decay, sympy.exp)])
def test_a_wrong_definition_of_an_intermediate_is_not_proved(
    monkeypatch: pytest.MonkeyPatch, part: type[Wave | Decay], wrong: Callable[..., sympy.Expr]
):
    right = part.definitions

    def definitions(self: Any) -> dict[sympy.Symbol, sympy.Expr]:
        return {
            symbol: wrong(*definition.atoms(sympy.Function).pop().args) for symbol, definition in right(self).items()
        }

    monkeypatch.setattr(part, "definitions", definitions)
    with pytest.raises(NotProved):
        stable_form(vector(r * sympy.cos(beta) * (1 - sympy.exp(-(sigma**2)))))


@given(st.integers(1, 6), st.integers(1, 6))
def test_angles_in_unlike_steps_are_joined(a: int, b: int):
    assume(a != b)
    entry = sympy.cos(beta / a) + r * sympy.sin(beta / b)
    (found,) = stable_form(vector(entry)).expanded()
    assert ExponentialPolynomial.read(found, RING) == ExponentialPolynomial.read(entry, RING)


def test_zero_and_constants_stay_themselves():
    form = stable_form(vector(sympy.Integer(0), sympy.Rational(3, 2), r))
    assert list(form.entries) == [0, sympy.Rational(3, 2), r]
    assert not form.definitions


def test_what_is_no_exponential_polynomial_is_refused():
    with pytest.raises(NotExponentialPolynomial):
        stable_form(vector(sympy.sqrt(r)))


def test_only_keeps_what_the_entries_need_in_order():
    a, b, c = sympy.symbols("a b c")
    form = StableForm({a: r**2, b: a + 1, c: sympy.sin(r)}, vector(b, c))
    assert list(form.only(vector(b)).definitions) == [a, b]
    assert list(form.only(vector(c)).definitions) == [c]
    assert list(form.expanded()) == [r**2 + 1, sympy.sin(r)]
