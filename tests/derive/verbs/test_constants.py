"""What holds no variable is a coefficient, whatever it is: integrals and expectations with roots and divisors."""

import mpmath
import pytest
from mpmath import mpf

from radartrack.derive.checking.asking import ask_identity
from radartrack.derive.checking.question.declared_world import world_of
from radartrack.derive.evaluation.many_digits import evaluate

SYMBOLS = {name: {"unit": "1", "low": 0.1, "high": 5} for name in ("tau", "c", "T")}
WORLD = world_of([{"symbols": SYMBOLS}])
POINT = {"tau": mpf("0.7"), "c": mpf("1.3"), "T": mpf("2.1")}
INTEGRANDS = {
    "exp(-s/tau)": lambda s, p: mpmath.exp(-s / p["tau"]),
    "s*exp(-s/tau)/(1 + c)": lambda s, p: s * mpmath.exp(-s / p["tau"]) / (1 + p["c"]),
    "sqrt(c)*s^2/tau^3": lambda s, p: mpmath.sqrt(p["c"]) * s**2 / p["tau"] ** 3,
    "cos(s/tau)*exp(-s*sqrt(c))": lambda s, p: mpmath.cos(s / p["tau"]) * mpmath.exp(-s * mpmath.sqrt(p["c"])),
    "sin(c)*s + cos(c*s/tau)^2": lambda s, p: mpmath.sin(p["c"]) * s + mpmath.cos(p["c"] * s / p["tau"]) ** 2,
    "(1 - exp(-s/tau))^2/(c + tau)": lambda s, p: (1 - mpmath.exp(-s / p["tau"])) ** 2 / (p["c"] + p["tau"]),
}


@pytest.mark.parametrize("text", INTEGRANDS)
def test_an_integral_is_what_quadrature_gives(text: str):
    question = ask_identity(f"integral({text}, s, 0, T)", "T", world=WORLD)
    (derived,) = question.reference.entries
    value = evaluate(derived, {symbol: POINT[symbol.name] for symbol in derived.free_symbols})
    expected = mpmath.quad(lambda s: INTEGRANDS[text](s, POINT), [0, POINT["T"]])
    assert mpmath.almosteq(value, expected, 1e-10)


@pytest.mark.parametrize("text", ["cos(T/tau)", "T^2*exp(-T/tau)/(1 + c)", "sqrt(c)*sin(T)*T"])
def test_an_expectation_is_what_quadrature_gives(text: str):
    question = ask_identity(f"expectation({text}, {{T: c/tau}})", "T", world=WORLD)
    (derived,) = question.reference.entries
    value = evaluate(derived, {symbol: POINT[symbol.name] for symbol in derived.free_symbols})
    (formula,) = ask_identity(text, "T", world=WORLD).reference.entries

    def weighted(x: mpf) -> mpf:
        point = {**POINT, "T": POINT["T"] + x * POINT["c"] / POINT["tau"]}
        known = {symbol: point[symbol.name] for symbol in formula.free_symbols}
        return evaluate(formula, known) * mpmath.exp(-(x**2) / 2) / mpmath.sqrt(2 * mpmath.pi)

    assert mpmath.almosteq(value, mpmath.quad(weighted, [-9, -3, 0, 3, 9]), 1e-8)
