"""How large what is neglected is: a size, whatever sign what it is divided by has."""

import math

import mpmath
import pytest
import sympy

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.language.model import Model
from radartrack.derive.language.source import Source
from radartrack.derive.language.variable import Variable, angle, deviation
from radartrack.derive.moments.validity_of_linearisation import validity
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import ONE, RADIAN

x, y = (Variable(name, "number of either sign", ONE, -3.0, 3.0) for name in "xy")
b, up = angle("b", "azimuth"), angle("up", "elevation", -1.5, 1.5)
WAYS = [
    (sp.sin(b), b, 0.8), (sp.sin(b), b, 2.2), (sp.cos(b), b, 2.9), (sp.cos(b), b, -0.6), (sp.sin(b) ** 3, b, -2.75),
    (sp.sin(up), up, -1.4), (sp.sin(7 * x), x, 1.3), (x**2, x, -1.7), (x**3, x, -0.4), (sp.exp(-(x**2)), x, 2.9),
    (1 / (x + 4), x, -2.2), (x**2 * y, x, -0.9), (y * sp.exp(2 * x), x, 0.7), (sp.atan2(x, y), x, -1.1),
]  # fmt: skip


def ratios(model: Model, formulas: str, *values: float) -> list[float]:
    return [float(one) for one in Evaluator(validity(model, formulas), (*model.arguments, *model.deviations))(values)]


@pytest.mark.parametrize(("output", "variable", "at"), WAYS, ids=str)
def test_of_one_quantity_it_is_the_neglected_derivative_by_the_slope(output: Expr, variable: Variable, at: float):
    unit = RADIAN if isinstance(output, sp.atan2) else ONE
    source, others = Source("nobody", None), tuple(s for s in (y,) if output.has(s))
    model = Model("m", "t", (variable,), (deviation(variable, 1e-9, 1.0),), {"o": output}, (unit,), source, {}, others)
    function = sympy.lambdify(variable, output.subs(y, -2), "mpmath")
    for formulas, order, spread in (("linear", 2, math.sqrt(3) / 2), ("second_order", 3, math.sqrt(15) / 6)):
        slope, neglected = (abs(mpmath.diff(function, at, n)) for n in (1, order))
        expected = float(neglected / slope * spread * 0.01 ** (order - 1))
        assert ratios(model, formulas, at, *[-2.0] * len(others), 0.01) == pytest.approx([expected], rel=1e-6)


@pytest.mark.parametrize("at", [-2.0, 2.0])
def test_of_coordinates_of_either_sign_too(at: float):
    deviations = (deviation(x, 1e-9, 1.0), deviation(y, 1e-9, 1.0))
    model = Model("m", "t", (x, y), deviations, {"product": x * y, "same": y}, (ONE, ONE), Source("nobody", None))
    assert ratios(model, "linear", 1.5, at, 0.3, 0.1) == pytest.approx([0.1 / 2, 0])
