"""Ordinary least squares of a coordinate on time: the consistent way to the error of one coordinate.

A target flies x = d + v t; times are known, and each x has an independent error of variance σ². The
expectation of a quadratic form in the errors is σ² times half the sum of its second derivatives. So the
degrees of freedom are derived, plot by plot: each plot has one less its leverage.
"""

from __future__ import annotations

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.language.quantity import Conditioning, Quantity, scalar
from radartrack.derive.language.stable_form import NotProved
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.derive.tracks.least_squares_line import root_of_linear
from radartrack.derive.units import METRE, METRE_PER_SECOND, ONE, SECOND

t = Variable("t", "time of a plot", SECOND, -1e4, 1e4)
x = Variable("x", "coordinate of a plot", METRE, -1e6, 1e6)
v = Variable("v", "speed of the target along the coordinate", METRE_PER_SECOND, -1e4, 1e4)
mean_t = Variable("mean_t", "mean of the times", SECOND, -1e4, 1e4)
n = Variable("n", "number of plots", ONE, 3.0, 1e6)
S_tt = Variable("S_tt", "sum of (t - mean_t)^2", SECOND**2, 1.0, 1e10)
S_tx = Variable("S_tx", "sum of (t - mean_t)(x - mean_x)", SECOND * METRE, -1e8, 1e8)
S_xx = Variable("S_xx", "sum of (x - mean_x)^2", METRE**2, 1e-2, 1e12)
SOURCE = cite("gauss1823")


def slope() -> Expr:
    """The speed at which the sum of the squared residuals is least, the intercept being the best for it."""
    residual_squares = S_xx - 2 * v * S_tx + v**2 * S_tt
    return root_of_linear(sp.diff(residual_squares, v), v)


def leverage() -> Expr:
    """The share of its own error that the fitted line takes from a plot.

    Of the sum of the squared residuals, Σ e² − (Σ e)²/n − (Σ (t − t̄) e)²/S_tt, half the second derivative by
    one error is what is left of its square; all that does not depend on this error is constant here.
    """
    error, squares, sum_of_errors, sum_along_time = (
        sp.Symbol(name, real=True) for name in ("error", "squares", "sum_of_errors", "sum_along_time")
    )
    along_time = ((t - mean_t) * error + sum_along_time) ** 2 / S_tt
    left = error**2 + squares - (error + sum_of_errors) ** 2 / n - along_time
    return 1 - sp.diff(left, error, 2) / 2


def degrees_of_freedom() -> Expr:
    """What the leverages leave of n: the expected sum of squared residuals is this times the variance."""
    left = 1 - leverage()
    return sp.cancel(n * left.xreplace({t: mean_t}) + S_tt * sp.diff(left, t, 2) / 2)


def variance() -> Expr:
    """The unbiased estimate of the variance of one error.

    Raises:
        NotProved: when the sum of squared residuals depends on the speed of the target.
    """
    left = S_xx - S_tx**2 / S_tt
    faster = left.xreplace({S_tx: S_tx + v * S_tt, S_xx: S_xx + 2 * v * S_tx + v**2 * S_tt})
    if sp.cancel(faster - left) != sp.Integer(0):
        raise NotProved("the sum of squared residuals of the ordinary fit should not depend on the speed")
    return left / degrees_of_freedom()


# fmt: off - a table reads best with few lines a row
QUANTITIES = (
    scalar(
        "line.ordinary.slope",
        "speed fitted by ordinary least squares of a coordinate on time",
        METRE_PER_SECOND,
        (S_tt, S_tx),
        SOURCE,
        "the zero of the derivative of the sum of squared residuals",
        slope,
    ),
    scalar(
        "line.ordinary.leverage",
        "share of its own error that the fitted line takes from a plot",
        ONE,
        (t, mean_t, n, S_tt),
        SOURCE,
        "1 - d2(sum of squared residuals)/d(error)2/2",
        leverage,
    ),
    scalar(
        "line.ordinary.degrees_of_freedom",
        "expected sum of squared residuals over the variance of one error",
        ONE,
        (n,),
        SOURCE,
        "sum of (1 - leverage)",
        degrees_of_freedom,
        conditioning=Conditioning.TRUTH,
    ),
    scalar(
        "line.ordinary.variance",
        "unbiased estimate of the error variance of a coordinate on a straight track",
        METRE**2,
        (n, S_tt, S_tx, S_xx),
        SOURCE,
        "sum of squared residuals over degrees of freedom",
        variance,
        conditioning=Conditioning.MEASUREMENT,
        is_difference=True,
    ),
)
# fmt: on


def quantities() -> tuple[Quantity, ...]:
    """Slope, leverage, degrees of freedom, and the variance that they give."""
    return QUANTITIES
