"""The second-order terms of Taylor's formula for any function of two variables, by its second derivatives.

Only the quadratic polynomial with those derivatives matters, so it stands for the function.
"""

from __future__ import annotations

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.language.quantity import Conditioning, Quantity, scalar
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.moments.taylor import second_order_bias
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import METRE, ONE

f_xx = Variable("f_xx", "second derivative by the first variable", METRE, -1e6, 1e6)
f_xy = Variable("f_xy", "mixed derivative", METRE, -1e6, 1e6)
f_yy = Variable("f_yy", "second derivative by the second variable", METRE, -1e6, 1e6)
dx = Variable("dx", "increment of the first variable, in its unit", ONE, -1e3, 1e3)
dy = Variable("dy", "increment of the second variable, in its unit", ONE, -1e3, 1e3)
D_1 = Variable("D_1", "variance of the first variable, in its unit squared", ONE, 1e-12, 1e3)
D_2 = Variable("D_2", "variance of the second variable, in its unit squared", ONE, 1e-12, 1e3)
K_12 = Variable("K_12", "covariance of the variables, in their units", ONE, -1e3, 1e3)

DERIVATIVES = (f_xx, f_xy, f_yy)


def quadratic() -> Expr:
    """The polynomial without lower terms whose second derivatives are the given ones."""
    a, b, c = (sp.Symbol(name, real=True) for name in "abc")
    polynomial = a * dx**2 + b * dx * dy + c * dy**2
    pairs = ((a, dx, dx, f_xx), (b, dx, dy, f_xy), (c, dy, dy, f_yy))
    found = {one: wanted / sp.diff(polynomial, u, v).coeff(one) for one, u, v, wanted in pairs}
    return sp.expand(polynomial.xreplace(found))


def mean_shift() -> Expr:
    """The expectation of the quadratic term for errors of the given covariance."""
    shift = second_order_bias(Tensor((1,), (quadratic(),)), (dx, dy), ((D_1, K_12), (K_12, D_2)))
    return sp.expand(shift.entries[0])


# fmt: off - a table reads best with few lines a row
QUANTITIES = (
    scalar(
        "taylor.quadratic_term",
        "quadratic term of Taylor's formula for two variables",
        METRE,
        (*DERIVATIVES, dx, dy),
        cite("prosov", "(5)"),
        "the polynomial of second degree with these second derivatives",
        quadratic,
        is_difference=True,
    ),
    scalar(
        "taylor.mean_shift",
        "what the quadratic term adds to the mean of a function of two variables with errors",
        METRE,
        (*DERIVATIVES, D_1, D_2, K_12),
        cite("prosov", "(7)"),
        "L f",
        mean_shift,
        conditioning=Conditioning.TRUTH,
        is_difference=True,
    ),
)
# fmt: on


def quantities() -> tuple[Quantity, ...]:
    """The quadratic term, and what it adds to the mean."""
    return QUANTITIES
