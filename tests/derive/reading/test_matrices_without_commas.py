"""Matrices that lost their commas on the way from a page, or never had any."""

import pytest

from radartrack.derive.reading import FormulaError, read_formula, to_text


def echo(text: str) -> str:
    return to_text(read_formula(text, "text", None).tree)


@pytest.mark.parametrize("row", ["; ", ";", " ;\n", "\n", "\n   "])
@pytest.mark.parametrize("gap", [" ", "  ", "\t"])
@pytest.mark.parametrize("ends", ["{}", " {} "])
def test_spaces_and_lines_part_entries(row: str, gap: str, ends: str):
    text = "[" + ends.format(f"T^3/3{gap}T^2/2{row}T^2/2{gap}T") + "]*q"
    assert echo(text) == "[[T**3/3, T**2/2], [T**2/2, T]]*q"


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("[1 T; 0 1]", "[[1, T], [0, 1]]"),
        ("[1 -T; 0 1]", "[[1, -T], [0, 1]]"),
        ("[1 - T 2; 0 1]", "[[1 - T, 2], [0, 1]]"),
        ("[1 -T 2; 0 +1 3]", "[[1, -T, 2], [0, 1, 3]]"),
        ("[a * b 2; 0 1]", "[[a*b, 2], [0, 1]]"),
        ("[(1 - exp(-a*T)) / a 2; 0 1]", "[[(1 - exp(-a*T))/a, 2], [0, 1]]"),
        ("[x/r y/r]", "[x/r, y/r]"),
        ("[1 T; 0 1]*[q 0; 0 q]", "[[1, T], [0, 1]]*[[q, 0], [0, q]]"),
        ("[x/r y/r; −y/r² x/r²]", "[[x/r, y/r], [-y/r**2, x/r**2]]"),
        ("[1 sin ω/ω; 0 cos ω 1/2]", None),
    ],
)
def test_a_sign_between_spaces_joins_and_one_that_touches_what_follows_parts(text: str, read: str | None):
    if read is None:
        with pytest.raises(FormulaError):
            echo(text)
    else:
        assert echo(text) == read


def test_what_can_be_read_as_it_stands_is():
    assert echo("[r cos β; r sin β]") == "[r*cos(beta), r*sin(beta)]"
    assert echo("[x -y, y -x]") == "[x - y, y - x]"


@pytest.mark.parametrize("text", ["r cos(beta)", "[1 T; 0]", "[a b, c d]", "[1 T; 0 1", "q [1 T; 0 1]"])
def test_what_is_refused_is_refused_with_the_word_for_what_was_typed(text: str):
    with pytest.raises(FormulaError) as caught:
        echo(text)
    assert caught.value.source in {None, text}
