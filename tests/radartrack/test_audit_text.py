from typing import Any

from radartrack import audit_text

RECORD: dict[str, Any] = {"order": None, "remarks": [], "suggestions": []}
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
