from typing import Any

from radartrack._reports import audit_text

RECORD: dict[str, Any] = {"reason": "", "order": None, "remarks": [], "suggestions": []}
EXAMPLE = {
    "point": {"k": 8.0},
    "entry": (),
    "derived": 1250.0,
    "units": {"k": "1"},
    "largest_relative_difference": None,
}


def test_an_example_tells_both_values_and_how_they_differ() -> None:
    example = EXAMPLE | {"printed": 2500.0, "relative_difference": 1.0}
    said = [("for example", "at k = 8: printed 2500, derived 1250, relative difference 100 %")]
    assert list(audit_text.explanation(RECORD | {"counterexample": example})) == said


def test_an_example_where_what_is_printed_is_not_real_says_so() -> None:
    example = EXAMPLE | {"printed": None, "relative_difference": None}
    said = [("for example", "at k = 8: what is printed is not real, derived 1250")]
    assert list(audit_text.explanation(RECORD | {"counterexample": example})) == said


def test_claims_are_counted_by_verdict() -> None:
    records = [{"verdict": verdict} for verdict in ("equal", "differs", "equal")]
    assert audit_text.summary(records) == "3 claims: 2 equal, 1 differs"
    assert audit_text.summary(records[:1]) == "1 claim: 1 equal"


def test_what_the_reason_says_already_is_not_said_twice() -> None:
    record = RECORD | {"counterexample": None, "reason": "not equal, but equal when rho = 0"}
    assert list(audit_text.explanation(record | {"remarks": ["equal when rho = 0"]})) == []
    said = [("but", "equal when transposed")]
    assert list(audit_text.explanation(record | {"remarks": ["equal when transposed"]})) == said
