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
        (["r*cos("], 2, "( is never closed"),
    ],
)
def test_a_formula_is_found_near_or_unreadable(arguments: list[str], code: int, said: str) -> None:
    result = CliRunner().invoke(app, ["find", *arguments])
    assert result.exit_code == code
    assert said in result.output
