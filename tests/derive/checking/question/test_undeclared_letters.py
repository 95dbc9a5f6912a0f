"""Identities in letters of which a paper says nothing."""

import pytest

from radartrack.derive.checking.asking import ask_identity
from radartrack.derive.checking.reporting.verdict import Outcome, Verdict
from radartrack.derive.formula.error import FormulaError


def verdict(left: str, right: str, **let: str) -> Verdict:
    *_, found = ask_identity(left, right, let=let).answers()
    return found


RIGHT = [
    ("(S + L)^2 - (S - L)^2", "4*S*L"),
    ("diff(sqrt(xt^2 + h^2), xt)", "xt/sqrt(xt^2 + h^2)"),
    ("sin(theta)^2 + cos(theta)^2", "1"),
    ("sum(j*z^j, j, 0, N)", "z*(1 - (N + 1)*z^N + N*z^(N + 1))/(1 - z)^2"),
    ("[[p11, p12], [p12, p22]] @ [1, 0]", "[p11, p12]"),
    ("expectation(A*cos(phi), {phi: s})", "A*cos(phi)*exp(-s^2/2)"),
    ("L*theta + L*sin(theta)", "L*(theta + sin(theta))"),
]


@pytest.mark.parametrize(("left", "right"), RIGHT, ids=[left for left, _ in RIGHT])
def test_an_identity_needs_no_declarations_and_its_slip_is_seen(left: str, right: str):
    assert verdict(left, right).verdict is Outcome.EQUAL
    assert verdict(left, "[p11, 2*p12]" if right.startswith("[") else f"2*({right})").verdict is Outcome.DIFFERS


def test_the_verdict_says_in_which_units_they_were_read():
    remarks = verdict("r*L + S*g", "2*r*L + g*(L + 4*r)").remarks
    assert "read with L, S and g in m: [symbols] says nothing of them" in remarks


def test_what_adds_up_in_no_units_is_wrong_in_its_dimensions():
    assert verdict("r*L + T*L", "r*L").verdict is Outcome.WRONG_DIMENSIONS


def test_a_definition_may_have_such_letters_too():
    assert (
        verdict("R + 0", "(S^2 - L^2)/(2*D)", R="(S - L)*(S + L)/(2*D)", D="S - L*cos(theta)").verdict is Outcome.EQUAL
    )


@pytest.mark.parametrize("name", ["sigma_bta", "sigma_epsilom", "sigma_epsilo"])
def test_a_name_that_is_another_misspelt_is_refused(name: str):
    with pytest.raises(FormulaError, match=name):
        verdict(f"{name}^2 + sigma_beta*epsilon*sigma_epsilon", f"{name}^2")


def test_an_example_is_not_taken_where_the_derived_value_happens_to_vanish():
    """All letters alike have the same round values, at which the determinant is zero."""
    found = verdict("A*D - B^2", "A*D + B^2").counterexample
    assert found is not None
    assert found.relative_difference is not None
    assert found.largest_relative_difference is not None
    assert found.relative_difference < 1e4
    assert found.relative_difference <= found.largest_relative_difference < 1e4


def test_a_definition_on_which_both_sides_rest_is_not_mended_for_one_of_them():
    """With another gain the left side would be another too."""
    gain = {"P": "[[p11, p12], [p12, p22]]", "H": "[[1, 0]]", "R": "[[s2]]", "K": "P @ H.T @ inv(H @ P @ H.T + R)"}
    left = "(eye(2) - K@H) @ P @ (eye(2) - K@H).T + K @ R @ K.T"
    assert verdict(left, "P - K@H@P", **gain).verdict is Outcome.EQUAL
    wrong = verdict(left, "P + K@H@P", **gain)
    assert wrong.verdict is Outcome.DIFFERS
    assert wrong.suggestions
    assert not any(suggestion.definition for suggestion in wrong.suggestions)
