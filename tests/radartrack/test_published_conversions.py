"""What papers print for independent errors, typed from them, is what the derivations give; proved, not measured.

λ = exp(−σ²/2) and λ' = exp(−2σ²) of an angle's error, as the papers abbreviate. The difference of two formulas
becomes a polynomial in λ, sines, cosines, ranges and deviations; it is zero modulo sin² + cos² = 1.
"""

from functools import reduce
from operator import mul
from typing import Any

import pytest
import sympy as sp

from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.variable import Variable
from radartrack.derive.sensors import models

Matrix = dict[tuple[int, ...], sp.Expr]
SYMBOLS: dict[str, Variable] = {s.name: s for m in models().values() for s in (*m.measured, *m.noise_symbols)}
r, beta, epsilon, rho = (SYMBOLS[name] for name in ("r", "beta", "epsilon", "rho"))
s_r, s_b, s_e = (SYMBOLS[f"sigma_{name}"] for name in ("r", "beta", "epsilon"))
sin, cos, exp, cosh, sinh = sp.sin, sp.cos, sp.exp, sp.cosh, sp.sinh

FACTORS = {s_b: sp.Symbol("lambda_beta", positive=True), s_e: sp.Symbol("lambda_epsilon", positive=True)}


def attenuation(sigma: Any, half_squares: int = 1) -> Any:
    """Exp(−n σ²/2)."""
    return exp(-sp.Rational(half_squares, 2) * sigma**2)


def polynomial(expression: Any) -> Any:
    """Without exponentials, hyperbolic functions, and sines of multiples."""
    exponentials = expression.rewrite([cosh, sinh], exp)
    named = exponentials.replace(exp, lambda exponent: in_factors(sp.expand(exponent)))
    return sp.expand(sp.expand_trig(named))


def in_factors(exponent: Any) -> Any:
    """Exp(−n σ²/2) → λⁿ."""
    powers = (factor ** (-2 * exponent.coeff(sigma, 2)) for sigma, factor in FACTORS.items())
    assert not (exponent - sum(sigma**2 * exponent.coeff(sigma, 2) for sigma in FACTORS))
    return reduce(mul, powers)


def is_zero(expression: Any) -> bool:
    numerator, _ = sp.fraction(sp.together(polynomial(expression)))
    angles = [beta, epsilon]
    placeholders = {f(angle): sp.Symbol(f"{f.__name__}_{angle}") for angle in angles for f in (sin, cos)}
    squares = [placeholders[sin(a)] ** 2 + placeholders[cos(a)] ** 2 - 1 for a in angles]
    _, remainder = sp.reduced(sp.expand(numerator.xreplace(placeholders)), squares, *placeholders.values())
    return bool(remainder == 0)


def derived(name: str) -> Matrix:
    """The entries of a quantity without correlation."""
    expression = catalogue()[name].expression
    return {index: entry.xreplace({rho: sp.Integer(0)}) for index, entry in expression.items()}


def symmetric(upper: Matrix) -> Matrix:
    return upper | {(b, a): entry for (a, b), entry in upper.items()}


# Lerro and Bar-Shalom 1993: the polar conversion, averaged given the measurement.

b2 = s_b**2
LERRO_BIAS: Matrix = {
    (0,): r * cos(beta) * (exp(-b2) - exp(-b2 / 2)),
    (1,): r * sin(beta) * (exp(-b2) - exp(-b2 / 2)),
}
LERRO_COVARIANCE = symmetric(
    {
        (0, 0): r**2
        * exp(-2 * b2)
        * (cos(beta) ** 2 * (cosh(2 * b2) - cosh(b2)) + sin(beta) ** 2 * (sinh(2 * b2) - sinh(b2)))
        + s_r**2
        * exp(-2 * b2)
        * (cos(beta) ** 2 * (2 * cosh(2 * b2) - cosh(b2)) + sin(beta) ** 2 * (2 * sinh(2 * b2) - sinh(b2))),
        (1, 1): r**2
        * exp(-2 * b2)
        * (sin(beta) ** 2 * (cosh(2 * b2) - cosh(b2)) + cos(beta) ** 2 * (sinh(2 * b2) - sinh(b2)))
        + s_r**2
        * exp(-2 * b2)
        * (sin(beta) ** 2 * (2 * cosh(2 * b2) - cosh(b2)) + cos(beta) ** 2 * (2 * sinh(2 * b2) - sinh(b2))),
        (0, 1): sin(beta) * cos(beta) * exp(-4 * b2) * (s_r**2 + (r**2 + s_r**2) * (1 - exp(b2))),
    }
)

# Mo et al. 1998: unbiased; Duan et al. 2004: modified unbiased.

lb, le = attenuation(s_b), attenuation(s_e)
lb4, le4 = attenuation(s_b, 4), attenuation(s_e, 4)
half, quarter = sp.Rational(1, 2), sp.Rational(1, 4)
SQUARE = r**2 + s_r**2

MO_POLAR: Matrix = {(0,): r * cos(beta) / lb, (1,): r * sin(beta) / lb}
MO_POLAR_COVARIANCE = symmetric(
    {
        (0, 0): (lb**-2 - 2) * r**2 * cos(beta) ** 2 + half * SQUARE * (1 + lb4 * cos(2 * beta)),
        (1, 1): (lb**-2 - 2) * r**2 * sin(beta) ** 2 + half * SQUARE * (1 - lb4 * cos(2 * beta)),
        (0, 1): (lb**-2 - 2) * r**2 * cos(beta) * sin(beta) + half * SQUARE * lb4 * sin(2 * beta),
    }
)
DUAN_POLAR: Matrix = {(0,): lb * r * cos(beta), (1,): lb * r * sin(beta)}
DUAN_POLAR_COVARIANCE = symmetric(
    {
        (0, 0): -(lb**2) * r**2 * cos(beta) ** 2 + half * SQUARE * (1 + lb4 * cos(2 * beta)),
        (1, 1): -(lb**2) * r**2 * sin(beta) ** 2 + half * SQUARE * (1 - lb4 * cos(2 * beta)),
        (0, 1): -(lb**2) * r**2 * sin(beta) * cos(beta) + half * SQUARE * lb4 * sin(2 * beta),
    }
)

# In space the papers count the azimuth counter-clockwise from x: their x is the compass's y.

ABOVE, BELOW = 1 + le4 * cos(2 * epsilon), 1 - le4 * cos(2 * epsilon)


def in_space(across: Any, up: Any, mixed: Any) -> Matrix:
    """The covariance that both papers have but for three factors, of r² in the plane, upwards, and mixed."""
    c, s, ce, se = cos(beta), sin(beta), cos(epsilon), sin(epsilon)
    tilted = half * SQUARE * lb * le4 * sin(2 * epsilon)
    return symmetric(
        {
            (1, 1): across * r**2 * c**2 * ce**2 + quarter * SQUARE * (1 + lb4 * cos(2 * beta)) * ABOVE,
            (0, 0): across * r**2 * s**2 * ce**2 + quarter * SQUARE * (1 - lb4 * cos(2 * beta)) * ABOVE,
            (2, 2): up * r**2 * se**2 + half * SQUARE * BELOW,
            (0, 1): across * r**2 * s * c * ce**2 + quarter * SQUARE * lb4 * sin(2 * beta) * ABOVE,
            (1, 2): mixed * r**2 * c * se * ce + tilted * c,
            (0, 2): mixed * r**2 * s * se * ce + tilted * s,
        }
    )


def position(in_plane: Any, up: Any) -> Matrix:
    return {
        (0,): in_plane * r * sin(beta) * cos(epsilon),
        (1,): in_plane * r * cos(beta) * cos(epsilon),
        (2,): up * r * sin(epsilon),
    }


MO_SPACE = position(1 / (lb * le), 1 / le)
MO_SPACE_COVARIANCE = in_space((lb * le) ** -2 - 2, le**-2 - 2, lb**-1 * le**-2 - lb**-1 - lb)
DUAN_SPACE = position(lb * le, le)
DUAN_SPACE_COVARIANCE = in_space(-((lb * le) ** 2), -(le**2), -lb * le**2)

PUBLISHED: dict[str, Matrix] = {
    "polar.bias.averaged": LERRO_BIAS,
    "polar.covariance.averaged": LERRO_COVARIANCE,
    "polar.unbiased.estimate": MO_POLAR,
    "polar.unbiased.covariance": MO_POLAR_COVARIANCE,
    "polar.posterior.estimate": DUAN_POLAR,
    "polar.posterior.covariance": DUAN_POLAR_COVARIANCE,
    "spherical.unbiased.estimate": MO_SPACE,
    "spherical.unbiased.covariance": MO_SPACE_COVARIANCE,
    "spherical.posterior.estimate": DUAN_SPACE,
    "spherical.posterior.covariance": DUAN_SPACE_COVARIANCE,
}


@pytest.mark.parametrize("name", PUBLISHED)
def test_the_published_formula_is_the_derived_one(name: str) -> None:
    formulas, expected = derived(name), PUBLISHED[name]
    assert formulas.keys() == expected.keys()
    for index, formula in formulas.items():
        assert is_zero(formula - expected[index]), index


@pytest.mark.parametrize("name", PUBLISHED)
def test_a_formula_with_another_factor_is_not_proved(name: str) -> None:
    formulas, expected = derived(name), PUBLISHED[name]
    for index, formula in formulas.items():
        assert not is_zero(formula - expected[index] * lb)
        assert not is_zero(formula + expected[index])
