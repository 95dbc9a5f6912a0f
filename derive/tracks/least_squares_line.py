"""The straight line y = k x + d of least perpendicular distance, for any number of weighted points.

Sums over points are needed of polynomials of second degree only. About the weighted mean these are exactly
Σ w p(x, y) = W p(x̄, ȳ) + ½ (S_xx ∂²p/∂x² + 2 S_xy ∂²p/∂x∂y + S_yy ∂²p/∂y²),
with W the sum of the weights and S the weighted sums of squares and products about the mean. So nothing below
depends on how many points there are. Weighted distances v·l, as in (5) of Gao et al., are weights w = v².
"""

from __future__ import annotations

from functools import cache

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.language.quantity import Conditioning, Quantity, scalar
from radartrack.derive.language.stable_form import NotProved, StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import METRE, ONE, RADIAN

x = Variable("x", "first coordinate of a point", METRE, -1e6, 1e6)
y = Variable("y", "second coordinate of a point", METRE, -1e6, 1e6)
k = Variable("k", "slope of the line", ONE, -10.0, 10.0)
d = Variable("d", "intercept of the line", METRE, -1e6, 1e6)
W = Variable("W", "sum of the weights of the points", ONE, 1e-3, 1e6)
mean_x = Variable("mean_x", "weighted mean of the first coordinates", METRE, -1e6, 1e6)
mean_y = Variable("mean_y", "weighted mean of the second coordinates", METRE, -1e6, 1e6)
S_xx = Variable("S_xx", "weighted sum of (x - mean_x)^2", METRE**2, 1e-2, 1e12)
S_xy = Variable("S_xy", "weighted sum of (x - mean_x)(y - mean_y)", METRE**2, -1e8, 1e8)
S_yy = Variable("S_yy", "weighted sum of (y - mean_y)^2", METRE**2, 1e-2, 1e12)


def total(polynomial: Expr) -> Expr:
    """The weighted sum over all points of a polynomial of second degree in x and y."""
    squares = S_xx * sp.diff(polynomial, x, 2) + S_yy * sp.diff(polynomial, y, 2)
    return W * polynomial.xreplace({x: mean_x, y: mean_y}) + squares / 2 + S_xy * sp.diff(polynomial, x, y)


def root_of_linear(expression: Expr, symbol: Symbol) -> Expr:
    """Where an expression that is linear in a symbol vanishes."""
    return sp.cancel(-expression.xreplace({symbol: sp.Integer(0)}) / sp.diff(expression, symbol))


@cache
def distance() -> Expr:
    """The distance of a point from the line, positive above it.

    Its square is the least squared distance to any point of the line.

    Raises:
        NotProved: when it is not.
    """
    signed = (y - k * x - d) / sp.sqrt(1 + k**2)
    along = sp.Symbol("along", real=True)
    squared = (x - along) ** 2 + (y - k * along - d) ** 2
    least = squared.xreplace({along: root_of_linear(sp.diff(squared, along), along)})
    if sp.cancel(least - signed**2) != sp.Integer(0):
        raise NotProved(f"{signed} is not the distance to the nearest point of the line")
    return signed


@cache
def objective() -> Expr:
    """The weighted sum of the squared distances."""
    return total(distance() ** 2)


def gradient() -> Tensor[Expr]:
    """The derivatives by slope and intercept, which vanish at the best line."""
    return Tensor((2,), tuple(sp.diff(objective(), symbol) for symbol in (k, d)))


def hessian() -> Tensor[Expr]:
    """The second derivatives by slope and intercept."""
    return Tensor.build((2, 2), lambda i, j: sp.diff(objective(), (k, d)[i], (k, d)[j]))


def intercept() -> Expr:
    """The best intercept for a given slope: the line passes through the weighted mean."""
    return sp.expand(root_of_linear(sp.diff(objective(), d), d))


@cache
def profile() -> Expr:
    """The objective as a function of the slope alone, the intercept being the best."""
    return sp.cancel(objective().xreplace({d: intercept()}))


@cache
def condition() -> Expr:
    """A quadratic in the slope with the sign of the profile's derivative, which is 2/(1 + k²)² times it."""
    return sp.expand(sp.cancel(sp.diff(profile(), k) * (1 + k**2) ** 2 / 2))


@cache
def spread() -> Expr:
    """The root of the condition's discriminant: the scatter along the best line less that across it."""
    a, b, c = (condition().coeff(k, power) for power in (2, 1, 0))
    return sp.sqrt(b**2 - 4 * a * c)


def stationary() -> tuple[Expr, Expr]:
    """Both slopes at which the profile is stationary: the best line, and across it the worst."""
    a, b = condition().coeff(k, 2), condition().coeff(k, 1)
    return (-b + spread()) / (2 * a), (-b - spread()) / (2 * a)


@cache
def slope() -> Expr:
    """The slope of the best line: the stationary one at which the profile is convex.

    Where the derivative 2 q/(1 + k²)² vanishes, the second derivative is 2 q'/(1 + k²)², so the sign of q'
    decides. With the second derivative by the intercept, 2 W/(1 + k²) > 0, convexity makes the Hessian
    positive definite.

    Raises:
        NotProved: when not exactly one of them has q' equal to the positive spread.
    """
    steepness = sp.diff(condition(), k)
    minima = [root for root in stationary() if sp.cancel(steepness.xreplace({k: root}) - spread()) == sp.Integer(0)]
    if len(minima) != 1:
        raise NotProved(f"one of the stationary slopes should be a minimum, found {minima}")
    return minima[0]


def by_residuals() -> tuple[dict[Symbol, Expr], Tensor[Expr], Tensor[Expr]]:
    """Gradient and Hessian over sums of the residuals y - k x - d: their mean, with x, and squared."""
    offset, lever, misfit = (sp.Symbol(name, real=True) for name in ("offset", "lever", "misfit"))
    stretch = sp.Symbol("stretch", positive=True)
    definitions = {
        stretch: 1 + k**2,
        offset: mean_y - k * mean_x - d,
        lever: S_xy - k * S_xx + W * mean_x * offset,
        misfit: S_yy - 2 * k * S_xy + k**2 * S_xx + W * offset**2,
    }
    by_slope = -2 * (lever + k * misfit / stretch) / stretch
    bend = 4 * k * lever - (1 - 3 * k**2) * misfit / stretch
    twice_by_slope = 2 * (S_xx + W * mean_x**2 + bend / stretch) / stretch
    mixed = 2 * W * (mean_x + 2 * k * offset / stretch) / stretch
    return (
        definitions,
        Tensor((2,), (by_slope, -2 * W * offset / stretch)),
        Tensor((2, 2), (twice_by_slope, mixed, mixed, 2 * W / stretch)),
    )


def gradient_form() -> StableForm:
    """The gradient as it is written."""
    definitions, first, _ = by_residuals()
    return StableForm(definitions, first)


def hessian_form() -> StableForm:
    """The Hessian as it is written."""
    definitions, _, second = by_residuals()
    return StableForm(definitions, second)


def stable_slope(excess_of_x: Expr, s_xy: Expr) -> StableForm:
    """The slope as a sum of two terms of one sign, for any sign of S_xx − S_yy."""
    excess = sp.Symbol("excess", real=True)
    root = sp.sqrt(excess**2 + 4 * s_xy**2)
    slope = (sp.Abs(excess) - excess) / (2 * s_xy) + 2 * s_xy / (root + sp.Abs(excess))
    return StableForm({excess: excess_of_x}, Tensor((), (slope,)))


@cache
def inclination() -> Expr:
    """The angle of the best line with the x axis, which stays defined for vertical lines.

    Twice the angle has the direction of (S_xx − S_yy, 2 S_xy): with k the slope, its cosine (1 − k²)/(1 + k²)
    and its sine 2k/(1 + k²) are in the ratios of these to the positive root.

    Raises:
        NotProved: when they are not.
    """
    excess, best = S_xx - S_yy, slope()
    for part, of in ((1 - best**2, excess), (2 * best, 2 * S_xy)):
        if sp.cancel(part * spread() - of * (1 + best**2)) != sp.Integer(0):
            raise NotProved("twice the angle of the best line has not the direction of (S_xx - S_yy, 2 S_xy)")
    return sp.atan2(2 * S_xy, excess) / 2


SUMS = (W, mean_x, mean_y, S_xx, S_xy, S_yy)


# fmt: off - a table reads best with few lines a row
QUANTITIES = (
    scalar(
        "line.distance",
        "perpendicular distance of a point from a line, positive above it",
        METRE,
        (x, y, k, d),
        cite("gao2020", "(3)"),
        "the least distance to a point of the line",
        distance,
        is_difference=True,
    ),
    scalar(
        "line.objective",
        "weighted sum of the squared perpendicular distances",
        METRE**2,
        (*SUMS, k, d),
        cite("gao2020", "(4) with W = n, (5) with the squares of its weights"),
        "sum of w l^2",
        objective,
        is_difference=True,
    ),
    Quantity(
        "line.gradient",
        "derivatives of the sum of squared distances by slope and intercept",
        ((METRE**2, METRE),),
        (*SUMS, k, d),
        Conditioning.NONE,
        cite("gao2020", "(6)"),
        "d(sum of w l^2)/d(k, d)",
        gradient,
        gradient_form,
        is_difference=True,
    ),
    Quantity(
        "line.hessian",
        "second derivatives of the sum of squared distances by slope and intercept",
        ((METRE, ONE), (METRE, ONE)),
        (*SUMS, k, d),
        Conditioning.NONE,
        cite("gao2020", "(6)"),
        "d2(sum of w l^2)/d(k, d)2",
        hessian,
        hessian_form,
        is_difference=True,
    ),
    scalar(
        "line.intercept",
        "intercept of the line of least squared distances, given its slope",
        METRE,
        (k, mean_x, mean_y),
        cite("gao2020", "(6)"),
        "the zero of the derivative by d",
        intercept,
        is_difference=True,
    ),
    scalar(
        "line.slope",
        "slope of the line of least squared distances; S_xy must not be zero",
        ONE,
        (S_xx, S_xy, S_yy),
        cite("pearson1901", "", cite("gao2020", "(6)")),
        "the stationary slope where the Hessian is positive",
        slope,
        lambda: stable_slope(S_xx - S_yy, S_xy),
    ),
    scalar(
        "line.inclination",
        "angle of the line of least squared distances with the x axis",
        RADIAN,
        (S_xx, S_xy, S_yy),
        cite("pearson1901"),
        "arc tangent of the slope",
        inclination,
    ),
)
# fmt: on


def quantities() -> tuple[Quantity, ...]:
    """The distance, the objective, its derivatives, and the best line."""
    return QUANTITIES
