"""What is too much in a printed matrix or vector."""

import pytest

from radartrack.derive import check
from radartrack.derive.checking.question.padding import still_states, trimmed
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import children
from radartrack.derive.reading import read_text

TURN = (
    "[1, sin(w*T)/w, 0, -(1-cos(w*T))/w, 0; 0, cos(w*T), 0, -sin(w*T), 0; 0, (1-cos(w*T))/w, 1, sin(w*T)/w, 0;"
    "0, sin(w*T), 0, cos(w*T), 0; 0, 0, 0, 0, 1]"
)


@pytest.mark.parametrize(
    ("formula", "expected", "kept", "words"),
    [
        ("[a, b, 0, 0]", (2,), "[a, b]", "without entries 2, 3, which are zero"),
        ("[a, 0, b]", (2,), "[a, b]", "without entry 1, which is zero"),
        ("[a, 0, b]", (3,), "[a, 0, b]", ""),
        ("[a, b, c]", (2,), "[a, b, c]", ""),
        ("[[1, a, 0], [0, 1, 0], [0, 0, 1]]", (2, 2), "[[1, a], [0, 1]]", "without state 2, which never changes"),
        ("[[1, 0, 0], [0, 1, a], [0, 0, 1]]", (2, 2), "[[1, a], [0, 1]]", "without state 0, which never changes"),
        ("[[1, a, b], [0, 1, 0], [0, 0, 1]]", (2, 2), "[[1, a, b], [0, 1, 0], [0, 0, 1]]", ""),
        ("[[a, b, 0], [c, a, 0]]", (2, 2), "[[a, b], [c, a]]", "without column 2, which is zero"),
    ],
)
def test_what_is_too_much_is_left_out_and_told(formula: str, expected: tuple[int, ...], kept: str, words: str) -> None:
    found, said = trimmed(read_text(formula, None), expected)
    assert (to_text(found), said) == (kept, words)


def test_a_state_that_another_one_rests_on_is_not_still() -> None:
    rows = [children(row) for row in children(read_text("[[1, a, 0], [0, 1, 0], [0, 0, 1]]", None))]
    assert still_states(rows) == [2]


def test_a_turn_may_have_its_rate_in_the_state() -> None:
    right = check("motion.turn.known_rate.transition", TURN)
    assert right.verdict is Outcome.EQUAL
    assert "without state 4, which never changes" in right.remarks
    wrong = check("motion.turn.known_rate.transition", TURN.replace("-sin(w*T), 0", "sin(w*T), 0", 1))
    assert (wrong.verdict, wrong.suggestions[0].entry) == (Outcome.DIFFERS, (1, 3))
