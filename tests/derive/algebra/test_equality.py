import math
from collections.abc import Callable
from random import Random

import pytest
import sympy
from sympy import Abs, Integer, Rational, acos, atan, atan2, cbrt, cos, cosh, exp, log, pi, sin, sinh, sqrt, tan, tanh

from radartrack.derive import check
from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.algebra.exponential_polynomial import Effort, ExponentialPolynomial, TooLong, ring_over
from radartrack.derive.language.variable import Variable
from radartrack.derive.units import ONE

x, y, u, v = sympy.symbols("x y u v", real=True)
r, s, k, C = sympy.symbols("r s k C", positive=True)
n = Variable("n", "a whole number from 3", ONE, 3, 100, whole=True)

IDENTITIES = [
    (sin(2 * x), 2 * sin(x) * cos(x)),
    (sin(x / 2) ** 2, (1 - cos(x)) / 2),
    (cos(3 * x), 4 * cos(x) ** 3 - 3 * cos(x)),
    (sin(x) * cos(y), (sin(x + y) + sin(x - y)) / 2),
    (tan(x), sin(x) / cos(x)),
    (1 + tan(x) ** 2, 1 / cos(x) ** 2),
    (tanh(x) * cosh(x), sinh(x)),
    (cosh(2 * s**2) - cosh(s**2), 2 * sinh(3 * s**2 / 2) * sinh(s**2 / 2)),
    (exp(-2 * s**2) * (cosh(2 * s**2) - cosh(s**2)), (1 - exp(-(s**2))) * (1 - exp(-3 * s**2)) / 2),
    (exp(x) * exp(y), exp(x + y)),
    (1 / ((k + 1) * (k + 2)), 1 / (k + 1) - 1 / (k + 2)),
    ((60 * C + k**2 - 4) / (k**2 - 1), 1 + (60 * C - 3) / ((k - 1) * (k + 1))),
    (sqrt(1 - u**2 - v**2) ** 2, 1 - u**2 - v**2),
    (u / sqrt(1 - u**2), u * sqrt(1 - u**2) / (1 - u**2)),
    (1 / (1 + sqrt(x**2 + 1)), (sqrt(x**2 + 1) - 1) / x**2),
    (sqrt((x**2 + y**2) / 3), sqrt(3) * sqrt(x**2 + y**2) / 3),
    (sqrt(r**2 * s**2 * cos(x) ** 2 + r**2 * sin(x) ** 2), r * sqrt(1 + (s**2 - 1) * cos(x) ** 2)),
    (sqrt(8) * x, 2 * sqrt(2) * x),
    (Abs(sin(x)), sqrt((1 - cos(2 * x)) / 2)),
    (sqrt(1 - 2 / pi), sqrt((pi - 2) / pi)),
    (sqrt(r**2 * (1 - 2 / pi) + s * (1 - 2 / pi)), sqrt(1 - 2 / pi) * sqrt(r**2 + s)),
    (sqrt(x * r / (2 - pi)), sqrt(-x * r) / sqrt(pi - 2)),
    (sqrt(x**2 * r + y**2 * r + x**2 * s**2 + y**2 * s**2), sqrt(x**2 + y**2) * sqrt(r + s**2)),
    (sqrt((k + C) / (k**2 + r)), sqrt(k + C) / sqrt(k**2 + r)),
    (cbrt(8 * (r + s) ** 4 * x), 2 * (r + s) * cbrt(r + s) * cbrt(x)),
    (sqrt((x**2 - y) ** 4 * s), (x**2 - y) ** 2 * sqrt(s)),
    (sqrt(x**2 * y**6), Abs(x * y) * y**2),
    (sqrt(s / (x - y) ** 2), sqrt(s / (x**2 - 2 * x * y + y**2))),
    (sqrt(s / ((x - 1) * (x - y) ** 2)), sqrt(s / (sympy.expand((x - 1) * (x - y) ** 2)))),
    (sqrt((n**2 - 4) * x), sqrt(n - 2) * sqrt(n + 2) * sqrt(x)),
    (sqrt((3 * n**2 - 3 * n - 17) / (n - 2)), sqrt(3 * n**2 - 3 * n - 17) / sqrt(n - 2)),
    (atan2(y, x), atan2(y, 2 * x - x)),
    (atan2(y * (1 + 1 / r), x), atan2(y + y / r, x)),
    (cos(x / r) ** 2 + sin(x / r) ** 2, Integer(1)),
    (cos(2 * x / r), 2 * cos(x / r) ** 2 - 1),
    (exp(-(x**2) / (2 * r**2)) ** 2, exp(-(x**2) / r**2)),
    (log(r) + atan(x), atan(x) + log(r)),
    (sqrt(y / (x**2 + r)), sqrt(y) / sqrt(x**2 + r)),
    (sqrt(1 / ((x**2 + s) * (y**4 + x**2))), 1 / (sqrt(x**2 + s) * sqrt(y**4 + x**2))),
    ((r ** Rational(1, 3)) ** 2 * r, r ** Rational(5, 3)),
]

DIFFERENT = [
    (x, y),
    (sin(x), cos(x)),
    (sqrt(x**2), x),
    (Abs(x), -x),
    (sqrt(x**2 + y**2), x + y),
    (Abs(sqrt(cos(x))) ** 2, cos(x)),
    (Abs(sqrt(cos(x)) + 1), sqrt(cos(x)) + 1),
    (atan2(y, x), atan2(x, y)),
    (acos(u), acos(v)),
    (exp(-(s**2)), 1 - s**2),
    (cosh(s**2), cosh(2 * s**2)),
    (1 / (k + 1), 1 / (k + 2)),
    (x / x - 1 + y, y + Rational(1, 10**30)),
    (sqrt(Integer(2)), Rational(665857, 470832)),
    (sqrt(x * (1 - 4 / pi)), sqrt(1 - 4 / pi) * sqrt(x)),
    (sqrt((k**2 - 4) / (k - 1)), sqrt(k**2 - 4) / sqrt(k - 1)),
    (sqrt((n - 4) / (n - 5)), sqrt(n - 4) / sqrt(n - 5)),
    (sqrt((x - 1) * (y - 1)), sqrt(x - 1) * sqrt(y - 1)),
    (sqrt((x - 1) ** 6), (x - 1) ** 3),
    (sqrt(1 / (r + (sqrt(x) - 1) * (sqrt(x) + 1) + 1)) * sqrt(r + (sqrt(x) - 1) * (sqrt(x) + 1) + 1), Integer(1)),
    (sqrt(n**2 - 4), n - 2),
]


@pytest.mark.parametrize(("first", "second"), IDENTITIES, ids=str)
def test_identities_are_proved(first: sympy.Expr, second: sympy.Expr) -> None:
    assert proved_equal(first, second)
    assert proved_equal(second, first)


@pytest.mark.parametrize(("first", "second"), DIFFERENT, ids=str)
def test_nothing_false_is_proved(first: sympy.Expr, second: sympy.Expr) -> None:
    assert not proved_equal(first, second)


@pytest.mark.parametrize("seed", range(25))
def test_what_is_proved_for_random_formulas_holds_in_numbers(seed: int) -> None:
    random = Random(seed)
    first, second = _formula(random, 3), _formula(random, 3)
    candidates = [(first, sympy.expand(first)), (first, second), (first + second, sympy.together(second + first))]
    for one, other in candidates:
        same = _agree(one, other, random)
        assert same or not proved_equal(one, other)
    assert proved_equal(*candidates[0])


def test_a_division_by_zero_is_never_equal_to_anything() -> None:
    vanishing = sin(x) ** 2 + cos(x) ** 2 - 1
    assert not proved_equal(1 / vanishing, 1 / vanishing + 1)


def test_a_root_keeps_its_sign() -> None:
    assert not proved_equal(sqrt((x - 1) ** 2), x - 1)
    assert not proved_equal(sqrt(x**2 * y**2), x * y)
    assert not proved_equal(sqrt(1 / (x + r)) * sqrt(x + r), Integer(1))
    assert not proved_equal(sqrt(1 / (x**2 - r)) * sqrt(x**2 - r), Integer(1))


def test_a_formula_that_is_too_long_for_algebra_is_not_proved_and_compared_in_numbers() -> None:
    long = " + ".join(f"cos({n}*beta)" for n in range(1, 9))
    other = long.replace("cos(1*", "sin(pi/2 + ")
    formula = f"r*cos(beta)*({long})**64*sqrt(sin(beta)**2)/(abs(sin(beta))*({other})**64)"
    assert check("polar.map[0]", formula).is_equal
    tall = sympy.Add(*(cos(n * x) for n in range(1, 9))) ** 64
    assert not proved_equal(tall * (sin(y) ** 2 + cos(y) ** 2), tall)


def test_effort_counts_the_products_of_monomials_and_those_of_powers() -> None:
    ring = ring_over([x, y])
    value = ExponentialPolynomial.read(x + y + sin(x), ring)
    with Effort(16 + 1):
        _ = value * value
        with pytest.raises(TooLong):
            _ = value * value
    with pytest.raises(TooLong), Effort(1000):
        _ = ExponentialPolynomial.read(x + y + 1, ring) ** 60
    with Effort(1), Effort(16):
        _ = value * value
    _ = value * value  # counted no longer


def _formula(random: Random, depth: int) -> sympy.Expr:
    if depth == 0:
        return random.choice([x, y, r, s, k, Integer(random.randint(1, 4)), Rational(1, random.randint(2, 5))])
    first, second = _formula(random, depth - 1), _formula(random, depth - 1)
    shapes: list[Callable[[], sympy.Expr]] = [
        lambda: first + second,
        lambda: first - second,
        lambda: first * second,
        lambda: first**2 + second,
        lambda: first / (1 + second**2),
        lambda: sin(x) * first + second,
        lambda: cos(y) * cosh(s**2) + first,
        lambda: exp(-(s**2)) * first - second,
        lambda: first * sqrt(1 + r**2),
    ]
    return random.choice(shapes)()


def _agree(first: sympy.Expr, second: sympy.Expr, random: Random) -> bool:
    symbols = [x, y, r, s, k]
    one, other = (sympy.lambdify(symbols, expression, "math") for expression in (first, second))
    points = [[random.uniform(0.3, 1.7) for _ in symbols] for _ in range(5)]
    return all(math.isclose(one(*p), other(*p), rel_tol=1e-8, abs_tol=1e-10) for p in points)
