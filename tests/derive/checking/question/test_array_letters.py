"""Letters for whole arrays of symbols are read where nothing else is right, and said."""

import pytest

from radartrack.derive import check
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.formula.error import FormulaError

RATE = "observe.spherical_doppler.map[3]"
DIFFERENCE = "observe.range_difference.map"
RIGHT = [
    (RATE, r"\frac{\mathbf{p}^T\mathbf{v}}{\|\mathbf{p}\|}"),
    (RATE, r"\frac{\mathbf{r}\cdot\mathbf{v}}{\|\mathbf{r}\|}"),
    (RATE, r"\frac{r^T v}{\sqrt{r^T r}}"),
    ("observe.polar_doppler.map[2]", r"\frac{\mathbf{p}^{\top}\mathbf{v}}{|\mathbf{p}|}"),
    (DIFFERENCE, r"\|\mathbf{p} - \mathbf{s}\| - \|\mathbf{p}\|"),
    ("observe.polar.map[0]", r"\|\mathbf{p}\|"),
    ("fusion.matrix_weights.two", r"P_2\left(P_1 + P_2\right)^{-1}"),
    ("fusion.matrix_weights.two", r"\mathbf{R}_2(\mathbf{R}_1 + \mathbf{R}_{2})^{-1}"),
    ("fusion.covariance_intersection.covariance", r"(\omega P_1^{-1} + (1 - \omega) P_2^{-1})^{-1}"),
]
WRONG = [
    (RATE, r"\frac{\mathbf{p}^T\mathbf{v}}{\|\mathbf{p}\|^2}"),
    (DIFFERENCE, r"\|\mathbf{p} + \mathbf{s}\| - \|\mathbf{p}\|"),
    ("fusion.matrix_weights.two", r"P_1\left(P_1 + P_2\right)^{-1}"),
    ("fusion.covariance_intersection.covariance", r"(\omega P_1^{-1} - (1 - \omega) P_2^{-1})^{-1}"),
]


@pytest.mark.parametrize(("name", "latex"), RIGHT)
def test_letters_for_arrays_are_read_and_said(name: str, latex: str) -> None:
    verdict = check(name, latex, latex=True)
    assert verdict.verdict is Outcome.EQUAL
    assert [one for one in verdict.remarks if " is read as [" in one]


@pytest.mark.parametrize(("name", "latex"), WRONG)
def test_a_slip_beside_them_is_told(name: str, latex: str) -> None:
    verdict = check(name, latex, latex=True)
    assert verdict.verdict in {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}
    assert verdict.suggestions
    assert [one for one in verdict.remarks if " is read as [" in one]


@pytest.mark.parametrize("formula", ["P2*inv(P1 + P2)", "P_2*(P_1 + P_2)^-1", "R2*inv(R1 + R2)", "K2*inv(K1 + K2)"])
def test_so_they_are_where_they_are_typed(formula: str) -> None:
    assert check("fusion.matrix_weights.two", formula).verdict is Outcome.EQUAL


def test_what_a_letter_is_defined_as_it_is() -> None:
    flipped = {"p": "[y, x, z]"}
    verdict = check(RATE, r"\frac{p^T v}{\|p\|}", latex=True, let=flipped)
    assert verdict.verdict is Outcome.DIFFERS
    assert check("observe.polar.map[0]", "r").reading == ("r for sqrt(x**2 + y**2)",)
    with pytest.raises(FormulaError, match=r"is not a name here|is no name"):
        check("polar.map[0]", r"\|\mathbf{p}\|\cos\beta + q", latex=True)
