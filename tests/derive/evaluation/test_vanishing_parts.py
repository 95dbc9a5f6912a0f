"""Kinks, and ends of what is real, that lie between the points at which a map is tried."""

import pytest
import sympy

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.real_outputs import require_real
from radartrack.derive.evaluation.vanishing_parts import critical_parts, vanishing_points
from radartrack.derive.language.variable import Variable, angle
from radartrack.derive.units import METRE, ONE

b = angle("b", "azimuth")
u = Variable("u", "a number", ONE, -1.0, 1.0)
v = Variable("v", "a number", ONE, -1.0, 1.0)
w = Variable("w", "a number on every scale", ONE, 1e-6, 1e6)
d = Variable("d", "a distance", METRE, 0.0, 1000.0)
SEVENTH = sympy.Rational(1, 7)
TENTH = sympy.Rational(1, 10)


def refusal_of(output: sympy.Expr) -> str:
    symbols = sorted(output.free_symbols, key=str)
    try:
        require_real([("x", output)], symbols, symbols)
    except ValueError as error:
        return str(error)
    return ""


@pytest.mark.parametrize(
    ("output", "said"),
    [
        (sp.acos(sp.cos(b)), "acos(cos(b)) lacks derivatives at b = 0, and b is -3.14159 to 3.14159"),
        (sp.asin(sp.sin(b)), "asin(sin(b)) lacks derivatives at b = -1.5708, and b is -3.14159 to 3.14159"),
        (sp.sqrt(w**2 - 6 * w + 9), "sqrt(w**2 - 6*w + 9) lacks derivatives at w = 3, and w is 1e-06 to 1e+06"),
        (sp.sqrt((d - 500) ** 2 - TENTH), "sqrt((d - 500)**2 - 1/10) is no real number at d = 499."),
        (sp.log((d - 500) ** 2 - TENTH), "log((d - 500)**2 - 1/10) is no real number at d = 499."),
        (sp.log(1 + sp.cos(3 * b)), "log(cos(3*b) + 1) has no value at b = -1.0472"),
        (sp.sqrt(sp.expand((u - v - SEVENTH) ** 2)), "lacks derivatives at u = "),
        (sp.hypot(u - v - SEVENTH, 2 * u - 2 * v - 2 * SEVENTH), "lacks derivatives at u = "),
        (1 / sp.expand((u - v - SEVENTH) ** 2), " has no value at u = "),
    ],
)
def test_what_ends_between_the_points_that_are_tried_is_found_and_named(output: sympy.Expr, said: str) -> None:
    assert said in refusal_of(output)
    assert refusal_of(output).isprintable()


@pytest.mark.parametrize(
    "output",
    [
        sp.sqrt((u - SEVENTH) ** 2 + v**2),  # a radar in the middle of its plane
        sp.atan2(u - SEVENTH, v),
        sp.hypot(u - SEVENTH, v),
        sp.asin(sp.sin(3 * u) * sp.cos(v) * 9 / 10),
        sp.sqrt(u**2 + sympy.Rational(1, 10**12)),
        sp.log(sympy.Rational(1001, 1000) - sp.cos(b)),
        sp.acos(sp.cos(b) * (1 - sympy.Rational(1, 10**6))),
        (w - 3) ** 2 * sp.log(w),
        sp.atan(sp.tan(u)),
    ],
)
def test_what_is_smooth_but_for_single_points_of_a_plane_is_accepted(output: sympy.Expr) -> None:
    assert refusal_of(output) == ""


def test_a_point_at_which_a_part_vanishes_is_as_near_as_many_digits_say() -> None:
    ((part, vanishing),) = critical_parts(sp.acos(sp.cos(b - SEVENTH)))
    ((number, place),) = vanishing_points([vanishing], [b])
    assert (part, number) == (sp.acos(sp.cos(b - SEVENTH)), 0)
    assert abs(place[b] - 1 / 7) < 1e-9
