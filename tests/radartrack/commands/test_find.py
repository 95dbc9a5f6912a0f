"""`radartrack find`: exit codes and what is said."""

import pytest
from typer.testing import CliRunner

from radartrack.cli import app


@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        (["R*cos(theta)"], 0, "polar.map[0]: proved, with R for r, theta for beta"),
        (["--latex", r"\rho\sin\theta"], 0, "polar.map[1]: proved, with rho for r, theta for beta"),
        (["(d*s_az*cos(az))^2 + (s_d*sin(az))^2"], 0, "polar.covariance.linear[1,1] when rho = 0: proved"),
        (["-R*cos(theta)*s_theta^2/1.9"], 1, "near: at most"),
        (["a*b + c*d + f*g"], 1, "No quantity"),
        (["|c|"], 1, "No quantity"),
        (["[1, t2 - t1; 0, 1]"], 0, "motion.constant_velocity.transition with T for t2 - t1: proved"),
        (["--latex", r"e^{-\alpha(t_k-t_{k-1})}"], 0, "motion.singer.transition[2,2] with T for t_k - t_km1: proved"),
        (["--code", "matlab", "x = rho*cos(theta);\ny = rho*sin(theta);"], 0, "polar.map: proved"),
        (["--code", "c", "p = (4 + L - sqrt(8*L + L*L))/4; a = 1 - p*p; b = 4 - 2*a - 4*p;"], 0, "alpha_beta.gain: "),
        (
            ["[[a*T^3/3, a*T^2/2, 0, 0], [a*T^2/2, a*T, 0, 0], [0, 0, b*T^3/3, b*T^2/2], [0, 0, b*T^2/2, b*T]]"],
            0,
            "motion.constant_velocity.process_noise.continuous for each of 2 axes, others with b for a: proved",
        ),
        (
            ["[1, 0, T, 0, 0; 0, 1, 0, T, 0; 0, 0, 1, 0, 0; 0, 0, 0, 1, 0; 0, 0, 0, 0, 1]"],
            0,
            "without what never changes, 4",
        ),
        (["r*cos("], 2, "( is never closed"),
    ],
)
def test_a_formula_is_found_near_or_unreadable(arguments: list[str], code: int, said: str) -> None:
    result = CliRunner().invoke(app, ["find", *arguments])
    assert result.exit_code == code
    assert said in result.output


@pytest.mark.parametrize(
    ("formula", "quantity", "meant"),
    [
        ("[[x/r, y/r], [-y/r^2, -x/r^2]]", "observe.polar.jacobian", "[1, 1]: x/"),
        ("r*cos(b), -r*sin(b)", "polar.map", "[1]: r*sin(beta)"),
        ("[[T^3/3, T^2/2], [T^2/2, T^2]]", "motion.constant_velocity.process_noise.continuous", "[1, 1]: q*T"),
        ("[1, T, T^2; 0, 1, T; 0, 0, 1]", "motion.constant_acceleration.transition", "[0, 2]: T**2/2"),
    ],
)
def test_an_array_with_a_slip_in_an_entry_is_near_what_it_is_else(formula: str, quantity: str, meant: str) -> None:
    result = CliRunner().invoke(app, ["find", formula])
    assert result.exit_code == 1
    first = result.output.splitlines()[0]
    assert first.startswith(quantity)
    assert "near: " in first
    assert meant in first
