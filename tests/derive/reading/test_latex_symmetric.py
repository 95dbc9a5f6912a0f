"""Symmetric matrices of which print shows one half."""

import pytest

from radartrack.derive.reading import FormulaError, read_latex, to_text

MARKS = ["*", r"\ast", r"{\star}", r"\cdot", r"\bullet", r"\text{sym.}", r"\mathrm{symmetric}", r"\operatorname{Symm}"]
FULL = "[[a + b, c**2, d/e], [c**2, f, cos(g)], [d/e, cos(g), h]]"


def read(body: str, environment: str = "bmatrix", columns: str = "") -> str:
    return to_text(read_latex(rf"\begin{{{environment}}}{columns} {body} \end{{{environment}}}", [*"abcdefgh"]))


@pytest.mark.parametrize("mark", MARKS)
def test_a_mark_stands_for_the_entry_across_the_diagonal(mark: str) -> None:
    assert read(rf"a + b & c^2 & \frac{{d}}{{e}} \\ {mark} & f & \cos g \\ {mark} & {mark} & h") == FULL
    assert read(rf"a + b & c^2 & \frac{{d}}{{e}} \\[2pt] & f & \cos g \\ {mark} & & h \\", "array", "{ccc}") == FULL
    assert read(rf"a + b & {mark} & \\ c^2 & f & \\ \frac{{d}}{{e}} & \cos g & h", "pmatrix") == FULL


@pytest.mark.parametrize(
    "body",
    [
        r"a & b \\ & c",  # where nothing stands there may be a zero
        r"a & * \\ * & c",
        r"* & b \\ * & c",
        r"a & b & c \\ * & d & e",
        r"a & b \\ * * & c",
    ],
)
def test_what_is_no_half_of_a_symmetric_matrix_is_refused(body: str) -> None:
    with pytest.raises(FormulaError):
        read(body)


def test_a_product_in_an_entry_is_no_mark() -> None:
    assert read(r"a \cdot b & c \\ d & e * f") == "[[a*b, c], [d, e*f]]"
