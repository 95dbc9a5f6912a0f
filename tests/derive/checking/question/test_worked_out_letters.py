"""Letters are matched in what is worked out too, and definitions may be functions of an index or a variable."""

from __future__ import annotations

import pytest

from radartrack.derive import check
from radartrack.derive.checking.question.definitions.loose_definitions import without_arguments
from radartrack.derive.reading.any_letters import plain_formulas

POLAR = {"x": "R*cos(theta)", "y": "R*sin(theta)"}
TURN = "[cos(theta), -sin(theta); sin(theta), cos(theta)]"
WHITE = "[0, 0; 0, q]"
NOISE = "motion.constant_velocity.process_noise.continuous"


@pytest.mark.parametrize(
    ("name", "formula", "let", "given"),
    [
        ("polar.jacobian", "jacobian([x, y], [R, theta])", POLAR, {}),
        ("polar.jacobian[0,1]", "diff(x, theta)", POLAR, {}),
        ("polar.hessian[1,:,:]", "hessian(y, [R, theta])", POLAR, {}),
        ("polar.bias.second_order[0]", "diff(x, theta, theta)*s^2/2", POLAR, {"rho": "0"}),
        (
            "polar.covariance.linear",
            "J*diag(s1^2, s2^2)*J.T",
            {"J": "jacobian([R*cos(theta), R*sin(theta)], [R, theta])"},
            {"rho": "0"},
        ),
        (
            "polar.bias.truth[0]",
            "expectation(R*cos(theta), {R: s_R, theta: s_th}) - R*cos(theta)",
            {},
            {"rho": "0"},
        ),
        ("motion.constant_velocity.transition", "expm(A*dt)", {"A": "[0, 1; 0, 0]"}, {}),
        ("motion.singer.transition", "expm(A*dt)", {"A": "[0, 1, 0; 0, 0, 1; 0, 0, -1/tau]"}, {}),
        (f"{NOISE}[0,0]", "S*integral((dt - s)^2, s, 0, dt)", {}, {}),
        ("finite_sample.degree1.range.information[0,0]", "sum(1/s_r^2, j, 1, n)", {}, {}),
    ],
)
def test_letters_are_matched_by_what_comes_out(
    name: str, formula: str, let: dict[str, str], given: dict[str, str]
) -> None:
    verdict = check(name, formula, let=let, given=given)
    assert verdict.is_equal, verdict.reason
    assert verdict.reading
    assert check(name, f"2*({formula})", let=let, given=given).verdict == "differs"


@pytest.mark.parametrize("index", ["s", "tau", "u"])
@pytest.mark.parametrize("elsewhere", ["", "T/2", "2", "T"])
@pytest.mark.parametrize("product", ["F*G*F.T", "F*G*F^T", "F({0})*G*F({0}).T", "outer(F*B, F*B)*q", "Q"])
def test_a_definition_may_be_a_function_of_the_variable_of_an_integral(
    index: str, elsewhere: str, product: str
) -> None:
    formula = f"integral({product.format(index)}, {index}, 0, T)"
    let = {"F": f"[1, {index}; 0, 1]", "G": WHITE, "B": "[0, 1]", "Q": "F*G*F.T"}
    let |= {index: elsewhere} if elsewhere else {}
    assert check(NOISE, formula, let=let).is_equal
    assert check(NOISE, formula, let={**let, "F": f"[1, 2*{index}; 0, 1]"}).verdict == "differs"


@pytest.mark.parametrize("formula", [r"\int_0^T F G F^T ds", r"\int_0^{T} \mathbf{F}(s) G \mathbf{F}(s)^{\top}\,ds"])
def test_so_it_may_in_latex(formula: str) -> None:
    assert check(NOISE, formula, latex=True, let={"F": "[1, s; 0, 1]", "G": WHITE}).is_equal


def test_so_it_may_of_an_index_in_another_definition() -> None:
    let = {"h": "[1, (j - n)*dt]", "A": "sum(outer(h, h), j, 1, n)"}
    assert check("finite_sample.degree1.range.covariance", "inv(A)*s_r^2", let=let).is_equal


def test_a_definition_behind_which_its_letter_stands_in_brackets_is_that_definition() -> None:
    let = {"F": "[1, tau]", "G": "[1, T]"}
    assert without_arguments("F(tau)*G(tau) + F(T)", let) == "F     *G(tau) + F(T)"
    assert plain_formulas({"F(tau)": "1 + tau", "G(x)": "2*x2"}) == {"F": "1 + tau", "G(x)": "2*x2"}
    for name in ("rot", "rot(theta)"):
        assert check("polar.map", "rot(theta)*[R, 0]", let={name: TURN}).is_equal
