"""What the printed deviations (8) to (10) of Gao et al. estimate when the errors are Gaussian.

The printed formula fits x against t by perpendicular distance, so it adds metres and seconds. Its sums make
sense after times are multiplied by a speed c; the print takes c as 1 in the units at hand. In the plane of
c t and x the slope is v/c, and all that the method gives depends on c.
"""

from __future__ import annotations

from dataclasses import replace

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.language.quantity import Conditioning, Quantity, scalar
from radartrack.derive.language.stable_form import NotProved, StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.derive.tracks import least_squares_line
from radartrack.derive.tracks.least_squares_line import stable_slope
from radartrack.derive.tracks.line_over_time import t, v, x
from radartrack.derive.units import METRE, METRE_PER_SECOND, ONE, SECOND

d = Variable("d", "coordinate at time zero", METRE, -1e6, 1e6)
c = Variable("c", "speed that turns times into lengths, 1 m/s in the print", METRE_PER_SECOND, 1e-2, 1e4)
v_x = Variable("v_x", "speed along x", METRE_PER_SECOND, -1e4, 1e4)
v_y = Variable("v_y", "speed along y", METRE_PER_SECOND, -1e4, 1e4)
speed = Variable("v", "speed of the target along the coordinate, not zero", METRE_PER_SECOND, 1e-2, 1e4)
std_t = Variable("std_t", "root mean square of the times about their mean", SECOND, 1.0, 1e4)
sigma_l = Variable("sigma_l", "standard deviation of a perpendicular distance", METRE, 1e-2, 1e5)
sigma_x = Variable("sigma_x", "standard deviation of the error of x", METRE, 1e-2, 1e5)
sigma_y = Variable("sigma_y", "standard deviation of the error of y", METRE, 1e-2, 1e5)
sigma_z = Variable("sigma_z", "standard deviation of the error of z", METRE, 1e-2, 1e5)


def folded_mean_factor() -> Expr:
    """The mean of |l| over σ for l ~ N(0, σ²): twice the integral of l times the density φ, from 0 on.

    Raises:
        NotProved: when −φ is not the antiderivative of l φ, for σ = 1.
    """
    l = sp.Symbol("l", real=True)  # noqa: E741 - the letter of the formula
    density = sp.exp(-(l**2) / 2) / sp.sqrt(2 * sp.pi)
    if sp.expand(sp.diff(-density, l) - l * density) != sp.Integer(0):
        raise NotProved("the antiderivative of l times the normal density should be minus the density")
    return 2 * density.xreplace({l: sp.Integer(0)})


def folded_std_factor() -> Expr:
    """The standard deviation of |l| over σ; the mean of |l|² is σ²."""
    return sp.sqrt(1 - folded_mean_factor() ** 2)


def residual() -> Expr:
    """A plot's distance from the line along the coordinate."""
    return x - v * t - d


def distance() -> Expr:
    """The perpendicular distance (3) in the plane of c t and x."""
    return least_squares_line.distance().xreplace(
        {least_squares_line.y: x, least_squares_line.x: c * t, least_squares_line.k: v / c, least_squares_line.d: d}
    )


def printed_std() -> Expr:
    """What (9) tends to about the true line, where the distance is proportional to the error of x."""
    per_error = sp.diff(distance(), x)
    return per_error * folded_std_factor() * sigma_x


def printed_position_std() -> Expr:
    """What (10) tends to, both lines being true."""
    along_x = printed_std().xreplace({v: v_x})
    along_y = printed_std().xreplace({v: v_y, sigma_x: sigma_y})
    return position_std().xreplace({sigma_x: along_x, sigma_y: along_y})


def population() -> dict[Expr, Expr]:
    """What the sums of squares and products tend to, per plot, in the plane of c t and x."""
    return {
        least_squares_line.S_xx: c**2 * std_t**2,
        least_squares_line.S_xy: c * speed * std_t**2,
        least_squares_line.S_yy: speed**2 * std_t**2 + sigma_x**2,
    }


def slope_limit() -> Expr:
    """The speed to which the perpendicular fit tends."""
    return c * least_squares_line.slope().xreplace(population())


def slope_limit_form() -> StableForm:
    """The same with the stable root."""
    excess = (c - speed) * (c + speed) * std_t**2 - sigma_x**2
    form = stable_slope(excess, population()[least_squares_line.S_xy])
    return StableForm(form.definitions, form.entries.map(lambda entry: c * entry))


def slope_limit_scale() -> Expr:
    """The slope times what rounding of the population's sums can do to it: it is ill-conditioned where they cancel."""
    a, b, s = (
        population()[symbol] for symbol in (least_squares_line.S_xx, least_squares_line.S_yy, least_squares_line.S_xy)
    )
    return slope_limit() * (1 + (a + b) / sp.sqrt((a - b) ** 2 + 4 * s**2))


def variance_limit() -> Expr:
    """The mean squared perpendicular distance from the line to which the fit tends."""
    return ((least_squares_line.S_xx + least_squares_line.S_yy - least_squares_line.spread()) / 2).xreplace(
        population()
    )


def variance_limit_form() -> StableForm:
    """The same without a difference: the product of both eigenvalues, (c s σ)², over the larger one."""
    a, b, s = (
        population()[symbol] for symbol in (least_squares_line.S_xx, least_squares_line.S_yy, least_squares_line.S_xy)
    )
    larger = (a + b + sp.sqrt((a - b) ** 2 + 4 * s**2)) / 2
    return StableForm({}, Tensor((), ((c * std_t * sigma_x) ** 2 / larger,)))


def position_std() -> Expr:
    """The root mean square of two coordinate deviations."""
    return sp.sqrt((sigma_x**2 + sigma_y**2) / 2)


def position_std_in_space() -> Expr:
    """The root mean square of three coordinate deviations."""
    return sp.sqrt((sigma_x**2 + sigma_y**2 + sigma_z**2) / 3)


# fmt: off - a table reads best with few lines a row
QUANTITIES = (
    scalar(
        "line.folded_mean_factor",
        "mean of the absolute value of a centred Gaussian over its standard deviation",
        ONE,
        (),
        cite("leone1961"),
        "E|l| for l ~ N(0, 1)",
        folded_mean_factor,
        conditioning=Conditioning.TRUTH,
    ),
    scalar(
        "line.folded_std_factor",
        "standard deviation of the absolute value of a centred Gaussian over its own",
        ONE,
        (),
        cite("leone1961"),
        "sqrt(1 - (E|l|)^2) for l ~ N(0, 1)",
        folded_std_factor,
        conditioning=Conditioning.TRUTH,
    ),
    scalar(
        "line.folded_std",
        "what (9) estimates for Gaussian distances",
        METRE,
        (sigma_l,),
        cite("gao2020", "(9)"),
        "standard deviation of |l|",
        lambda: folded_std_factor() * sigma_l,
        conditioning=Conditioning.TRUTH,
    ),
    scalar(
        "line.motion.residual",
        "distance of a plot from a motion at constant speed, along the coordinate",
        METRE,
        (t, x, v, d),
        cite("gao2020", "2.3"),
        "x - v t - d",
        residual,
        is_difference=True,
    ),
    scalar(
        "line.motion.distance",
        "perpendicular distance of a plot from a motion, in the plane of c t and x",
        METRE,
        (t, x, v, d, c),
        cite("gao2020", "(3) as used in (8)"),
        "(x - v t - d)/sqrt(1 + (v/c)^2)",
        distance,
        is_difference=True,
    ),
    scalar(
        "line.motion.printed_std",
        "what (9) estimates from many plots about the true line",
        METRE,
        (v, sigma_x, c),
        cite("gao2020", "(9)"),
        "standard deviation of |l| for Gaussian errors of x",
        printed_std,
        conditioning=Conditioning.TRUTH,
    ),
    scalar(
        "line.motion.printed_position_std",
        "what (10) estimates from many plots about the true lines",
        METRE,
        (v_x, v_y, sigma_x, sigma_y, c),
        cite("gao2020", "(10)"),
        "root mean square of both",
        printed_position_std,
        conditioning=Conditioning.TRUTH,
    ),
    replace(
        scalar(
            "line.motion.slope_limit",
            "speed to which the perpendicular fit of a coordinate on time tends",
            METRE_PER_SECOND,
            (speed, sigma_x, std_t, c),
            cite("gao2020", "(4) as used in 2.2"),
            "c times the slope of the population",
            slope_limit,
            slope_limit_form,
            conditioning=Conditioning.TRUTH,
        ),
        scale=lambda: Tensor((), (slope_limit_scale(),)),
        measured_against="itself times the condition of the sums of squares that it is made of",
    ),
    scalar(
        "line.motion.variance_limit",
        "mean squared distance to which the perpendicular fit of a coordinate tends",
        METRE**2,
        (speed, sigma_x, std_t, c),
        cite("gao2020", "(4) as used in 2.2"),
        "the objective per plot at its minimum",
        variance_limit,
        variance_limit_form,
        conditioning=Conditioning.TRUTH,
    ),
    scalar(
        "line.position_std",
        "root mean square of the deviations of x and y",
        METRE,
        (sigma_x, sigma_y),
        cite("gao2020", "(10)"),
        "sqrt((sigma_x^2 + sigma_y^2)/2)",
        position_std,
    ),
    scalar(
        "line.position_std_in_space",
        "root mean square of the deviations of x, y and z",
        METRE,
        (sigma_x, sigma_y, sigma_z),
        cite("gao2020", "(2)"),
        "sqrt((sigma_x^2 + sigma_y^2 + sigma_z^2)/3)",
        position_std_in_space,
    ),
)
# fmt: on


def quantities() -> tuple[Quantity, ...]:
    """The fold factors, the printed deviations, and what they tend to."""
    return QUANTITIES
