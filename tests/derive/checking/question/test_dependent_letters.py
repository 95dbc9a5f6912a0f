"""Letters that the field uses for functions of a quantity's symbols are read, and said; a slip is told in them."""

from __future__ import annotations

import pytest

from radartrack.derive import check
from radartrack.derive.checking.reporting.verdict import Outcome

GEODETIC = "frames.ecef_from_geodetic.map"
RIGHT = [
    ("observe.polar.jacobian", "[[x/r, y/r], [-y/r^2, x/r^2]]"),
    ("observe.polar.jacobian", "[[cos(theta), sin(theta)], [-sin(theta)/r, cos(theta)/r]]"),
    ("observe.polar_doppler.jacobian[2,0]", "(vx - rdot*x/R)/R"),
    (
        "observe.spherical.jacobian",
        "[[x/r, y/r, z/r], [y/d^2, -x/d^2, 0], [-x*z/(r^2*d), -y*z/(r^2*d), d/r^2]]",
    ),
    ("polar.jacobian", "[[x/r, -y], [y/r, x]]"),
    ("ruv.jacobian[2,1]", "-r*u/w"),
    (f"{GEODETIC}[2]", "(N*(1 - e^2) + h)*sin(phi)"),
    (f"{GEODETIC}[2]", "(b^2/a^2*N + h)*sin(phi)"),
    ("frames.ecef_from_geodetic.jacobian[2,0]", "(M + h)*cos(lat)"),
    ("finite_sample.degree1.range.covariance[0,0]", "2*(2*n + 1)/((n + 1)*(n + 2))*sigma_r^2"),
    ("finite_sample.degree1.range.covariance[0,0]", "2*(2*n - 1)/(n*(n + 1))*sigma_r^2"),
    ("motion.singer.process_noise[2,2]", "S_w*(1 - exp(-2*alpha*T))/(2*alpha)"),
    ("motion.ornstein_uhlenbeck.process_noise[1,1]", "sigma_v^2*(1 - exp(-2*T/tau))"),
    ("motion.ornstein_uhlenbeck.process_noise[1,1]", "sigma^2*(1 - exp(-2*alpha*T))"),
    ("motion.ornstein_uhlenbeck.process_noise[1,1]", "sigma^2/(2*theta)*(1 - exp(-2*theta*T))"),
    ("fusion.correlated.variance", "(P1*P2 - P12^2)/(P1 + P2 - 2*P12)"),
]


@pytest.mark.parametrize(("name", "formula"), RIGHT)
def test_a_usual_letter_is_read_as_the_function_that_it_is(name: str, formula: str) -> None:
    verdict = check(name, formula)
    assert verdict.is_equal, verdict.reason
    assert verdict.reading


@pytest.mark.parametrize(
    ("name", "formula", "right"),
    [
        ("observe.polar.jacobian[1,0]", "-y/r", "-y/r**2"),
        ("polar.jacobian[0,1]", "y", "-y"),
        (f"{GEODETIC}[2]", "(N*(1 + e^2) + h)*sin(phi)", "(N*(1 - e**2) + h)*sin(phi)"),
    ],
)
def test_a_slip_is_told_in_the_letters_that_are_printed(name: str, formula: str, right: str) -> None:
    verdict = check(name, formula)
    assert not verdict.is_equal
    assert right in {one.formula for one in verdict.suggestions}


def test_a_letter_of_the_quantity_or_a_definition_comes_first() -> None:
    assert check("polar.map[0]", "r*cos(beta)").reading == ()
    assert check("observe.polar.jacobian[0,0]", "x/r", let={"r": "sqrt(x^2 + y^2)"}).reading == ()
    assert check("observe.polar.jacobian[0,0]", "x/r", let={"r": "x^2 + y^2"}).verdict is not Outcome.EQUAL


@pytest.mark.parametrize(
    ("formula", "right"),
    [
        (
            "[1, T, tau^2*(-1+T/tau+exp(-T/tau)); 0, 1, tau^2*(1-exp(-T/tau)); 0, 0, exp(-T/tau)]",
            "tau*(1 - exp(-T/tau))",
        ),
        (
            "[1, T, tau*(-1+T/tau+exp(-T/tau)); 0, 1, tau*(1-exp(-T/tau)); 0, 0, exp(-T/tau)]",
            "tau**2*(-1 + T/tau + exp(-T/tau))",
        ),
    ],
)
def test_a_slip_in_units_leaves_a_time_constant_what_it_is(formula: str, right: str) -> None:
    verdict = check("motion.singer.transition", formula)
    assert verdict.reading == ("tau for 1/alpha",)
    assert right in {one.formula for one in verdict.suggestions}


@pytest.mark.parametrize("argument", [r"\phi", r"\varphi", r"{\phi}"])
@pytest.mark.parametrize("opening", ["(", r"\left("])
def test_a_letter_of_a_letter_in_brackets_is_a_function_where_no_product_is_right(argument: str, opening: str) -> None:
    closing = opening.replace("(", ")").replace("left", "right")
    radius = f"N{opening}{argument}{closing}"
    latex = rf"\left({radius} + h\right)\cos\phi\cos\lambda"
    assert check(f"{GEODETIC}[0]", latex, latex=True).is_equal
    wrong = check(f"{GEODETIC}[0]", latex.replace(r"\cos\lambda", r"\sin\lambda"), latex=True)
    assert not wrong.is_equal
    assert "phi" not in wrong.suggestions[0].formula.split("cos")[0]


@pytest.mark.parametrize(
    ("name", "latex"), [("motion.singer.transition[2,2]", r"e^{-\alpha(T)}"), ("ruv.map[0]", "r(u)")]
)
def test_a_product_that_is_right_stays_one(name: str, latex: str) -> None:
    assert check(name, latex, latex=True).is_equal
