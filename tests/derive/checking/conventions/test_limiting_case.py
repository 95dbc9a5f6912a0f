"""Of a print that neglects something it is told where that goes to zero, and of nothing else."""

from __future__ import annotations

import pytest
import sympy

from radartrack.derive import check
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.language.tensor import Tensor

# What a slow manoeuvre, a short baseline and the like leave of a quantity, by the symbol that vanishes.
NEGLECTED = {
    "motion.singer.transition": "alpha",
    "motion.ornstein_uhlenbeck.transition": "alpha",
    "motion.ornstein_uhlenbeck.process_noise": "alpha",
    "motion.turn.known_rate.transition": "omega",
    "motion.turn.known_rate.process_noise.continuous": "omega",
    "bistatic.map": "baseline",
}
WRONG = {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}


def _leading(name: str, factor: int = 1) -> str:
    """What SymPy finds to be left of a quantity where a symbol vanishes; of the entries that vanish, zero."""
    quantity = catalogue()[name]
    (symbol,) = (one for one in quantity.symbols if one.name == NEGLECTED[name])
    free = sympy.Symbol("free", positive=True)
    left = [sympy.limit(entry.xreplace({symbol: free}), free, 0) for entry in quantity.expression]
    last = max(place for place, entry in enumerate(left) if entry.free_symbols)
    left[last] *= factor
    return shown(Tensor(quantity.shape, tuple(left)))


@pytest.mark.parametrize("name", NEGLECTED)
def test_the_limit_of_a_quantity_is_told_to_be_that(name: str) -> None:
    verdict = check(name, _leading(name))
    assert verdict.verdict in WRONG
    assert f"equal where {NEGLECTED[name]} goes to 0" in verdict.remarks, (verdict.reason, verdict.remarks)


@pytest.mark.parametrize("name", NEGLECTED)
def test_a_limit_with_a_wrong_coefficient_is_none(name: str) -> None:
    verdict = check(name, _leading(name, 3))
    assert verdict.verdict in WRONG
    assert not any("goes to" in remark for remark in verdict.remarks), verdict.remarks


@pytest.mark.parametrize("name", NEGLECTED)
def test_a_condition_under_which_there_is_only_a_limit_is_that_limit(name: str) -> None:
    given = {NEGLECTED[name]: "0"}
    assert check(name, _leading(name), given=given).verdict is Outcome.EQUAL
    assert check(name, _leading(name, 3), given=given).verdict in WRONG


@pytest.mark.parametrize(
    ("name", "formula", "where"),
    [
        (
            "motion.singer.process_noise",
            "2*alpha*sigma_m^2*[[T^5/20, T^4/8, T^3/6], [T^4/8, T^3/3, T^2/2], [T^3/6, T^2/2, T]]",
            "equal where alpha goes to 0",
        ),
        ("finite_sample.degree1.range.covariance[0,0]", "4*sigma_r^2/k", "equal where k goes to infinity"),
    ],
)
def test_what_vanishes_too_is_right_in_the_limit_of_the_quotient(name: str, formula: str, where: str) -> None:
    assert where in check(name, formula).remarks


@pytest.mark.parametrize(
    ("name", "formula"),
    [
        ("polar_doppler.covariance.averaged[2,2]", "r^2*sigma_rdot^2 + rdot^2*sigma_r^2 + (1 + rho^2)*sigma_r^2"),
        ("polar.bias.truth[0]", "-r*cos(beta)*sigma_beta^2/2"),
        ("finite_sample.degree1.range.covariance[0,0]", "2*(2*k + 1)*sigma_r^2/(k*(k + 1))"),
    ],
)
def test_where_a_slip_or_the_order_explains_it_no_limit_is_told(name: str, formula: str) -> None:
    assert not any("goes to" in remark for remark in check(name, formula).remarks)


def test_where_there_is_no_limit_either_the_formula_is_shown_without_the_condition() -> None:
    verdict = check("line.slope", "0", given={"S_xy": "0"})
    assert verdict.verdict is Outcome.UNDECIDED
    assert verdict.derived == shown(catalogue()["line.slope"].expression)
