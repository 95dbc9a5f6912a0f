"""In a product of matrices the slip is told that was made: a transpose, an inverse, an order, a factor, a sign."""

from __future__ import annotations

import pytest

from radartrack.derive import check
from radartrack.derive.checking.repairing.matrix_slips import matrix_slips
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.formula.shape import shapes
from radartrack.derive.formula.tree import walk
from radartrack.derive.reading.text import read_text

WRONG = {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}
CONVERSION = {
    "J": "[cos(beta), -r*sin(beta); sin(beta), r*cos(beta)]",
    "K": "[sigma_r^2, rho*sigma_r*sigma_beta; rho*sigma_r*sigma_beta, sigma_beta^2]",
}
TRACKS = {
    "A": "[sigma_x1^2, rho_1*sigma_x1*sigma_y1; rho_1*sigma_x1*sigma_y1, sigma_y1^2]",
    "B": "[sigma_x2^2, rho_2*sigma_x2*sigma_y2; rho_2*sigma_x2*sigma_y2, sigma_y2^2]",
}
SANDWICH = "polar.covariance.linear", CONVERSION, "J*K*J.T"
INTERSECTION = "fusion.covariance_intersection.covariance", TRACKS, "inv(weight*inv(A) + (1 - weight)*inv(B))"


@pytest.mark.parametrize(
    ("quantity", "printed"),
    [
        *((SANDWICH, printed) for printed in ("J.T*K*J", "J*K*J", "J*K*inv(J)", "J*K", "K*J*J.T", "K*K*J.T")),
        *(
            (INTERSECTION, printed)
            for printed in (
                "inv(weight*A + (1 - weight)*inv(B))",
                "inv(weight*inv(A) - (1 - weight)*inv(B))",
                "weight*inv(A) + (1 - weight)*inv(B)",
            )
        ),
    ],
)
def test_a_slip_in_a_product_of_matrices_is_told_first(quantity: tuple[str, dict[str, str], str], printed: str) -> None:
    name, let, right = quantity
    verdict = check(name, printed, let=let)
    assert verdict.verdict in WRONG
    assert verdict.suggestions[0].formula == right
    assert all(one.formula != printed for one in verdict.suggestions)


def test_a_transpose_that_is_missing_is_told_where_the_matrices_are_written_out() -> None:
    name, let, _ = SANDWICH
    verdict = check(name, f"{let['J']}*{let['K']}*{let['J']}")
    assert verdict.suggestions[0].formula.endswith(".T")
    assert "a missing transpose" in verdict.suggestions[0].edit


def test_a_slip_in_a_matrix_of_a_product_is_told_there() -> None:
    name, let, right = SANDWICH
    verdict = check(name, right, let=let | {"J": let["J"].replace("-r", "r")})
    assert {one.definition for one in verdict.suggestions} == {"J"}


def test_letters_are_read_in_a_product_with_an_inverse() -> None:
    let = {"P": "[s1^2, 0; 0, s2^2]", "u": "[1, 1]"}
    verdict = check("fusion.variance.two", "1/((u.T*inv(P)*u)[0])", let=let)
    assert verdict.verdict is Outcome.EQUAL, verdict


def test_no_slip_of_a_formula_of_numbers_alone_is_one_of_matrices() -> None:
    tree = read_text("a*b/c + sin(a)**2", {"a", "b", "c"})
    shape = shapes(dict.fromkeys("abc", ()))
    assert not [slip for _, node in walk(tree) for slip in matrix_slips(node, {}, shape)]


@pytest.mark.parametrize(
    ("formula", "let", "mended"),
    [
        ("A*diag(sigma_r^2, sigma_beta^2)*A.T", {}, "A*diag(sigma_r**2, r**2*sigma_beta**2)*A.T"),
        ("A*[sigma_r^2, 0; 0, sigma_beta^2]*A.T", {}, "A*[[sigma_r**2, 0], [0, r**2*sigma_beta**2]]*A.T"),
        ("A*S*A.T", {"S": "[sigma_r^2, 0; 0, sigma_beta^2]"}, "S = [[sigma_r**2, 0], [0, r**2*sigma_beta**2]]"),
    ],
)
def test_a_factor_that_an_entry_lacks_is_told_there(formula: str, let: dict[str, str], mended: str) -> None:
    turn = {"A": "[cos(beta), -sin(beta); sin(beta), cos(beta)]", **let}
    verdict = check("polar.covariance.linear", formula, let=turn, given={"rho": "0"})
    assert mended in {one.formula for one in verdict.suggestions}
    assert not verdict.terms
