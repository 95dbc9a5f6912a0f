"""Formulas side by side are a vector, with or without brackets, and equations among them define each other."""

from __future__ import annotations

from itertools import permutations

import pytest

from radartrack.derive.catalogue import catalogue
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.printing import to_latex, to_text
from radartrack.derive.reading.joined_equations import results
from radartrack.derive.reading.notation import LATEX, read_formula
from radartrack.derive.reading.text import read_text

VECTORS = {
    name: [to_text(to_tree(entry)) for entry in quantity.expression]
    for name, quantity in catalogue().items()
    if len(quantity.shape) == 1 and name.endswith((".map", ".estimate", ".second_order", "weights", "gain"))
}
SHORT = sorted(name for name, entries in VECTORS.items() if len(entries) > 1 and sum(map(len, entries)) < 400)


@pytest.mark.parametrize("name", SHORT)
def test_a_vector_is_the_same_with_and_without_brackets_and_as_equations(name: str) -> None:
    entries = VECTORS[name]
    bracketed = read_text(f"[{', '.join(entries)}]", None)
    for text in (
        ", ".join(entries),
        f"({', '.join(entries)})",
        ", ".join(f"out{place} = {entry}" for place, entry in enumerate(entries)),
        "\n".join(f"out({place}) = {entry};" for place, entry in enumerate(entries)),
        " and ".join(f"out{place} = {entry}" for place, entry in enumerate(entries)),
    ):
        assert read_text(text, None) == bracketed, text


@pytest.mark.parametrize("name", SHORT)
def test_so_it_is_in_latex(name: str) -> None:
    entries = [to_latex(read_text(entry, None)) for entry in VECTORS[name]]
    symbols = [symbol.name for symbol in catalogue()[name].symbols]
    bracketed = read_formula(rf"\left[{', '.join(entries)}\right]", LATEX, symbols).tree
    for text in (
        ", ".join(entries),
        "\\left(" + r",\; ".join(entries) + r"\right)",
        f"$$ {', '.join(entries)}. $$",
    ):
        assert read_formula(text, LATEX, symbols).tree == bracketed, text


def test_definitions_beside_a_formula_are_put_in_wherever_they_stand() -> None:
    parts = ["x = r*c", "c = cos(a)", "a = pi/2 - beta"]
    for order in permutations(parts):
        for between in (", ", "; ", "\n", " where "):
            assert read_text(between.join(order), None) == read_text("r*cos(pi/2 - beta)", None)
    rows = read_text("P[0,0] = a, P[0,1] = b, P[1,1] = c", None)
    assert rows == read_text("[[a, b], [b, c]]", None)
    assert read_text("1, T; 0, 1", None) == read_text("[1, T; 0, 1]", None)


@pytest.mark.parametrize(
    ("notation", "formula"),
    [
        ("text", "R = sqrt(x^2 + y^2), d = (x*u + y*v)/R"),
        ("latex", r"R = \sqrt{x^2 + y^2}, \quad d = (x u + y v)/R"),
        ("printed", "R = √(x² + y²), d = (x u + y v)/R"),
        ("python", "R = sqrt(x**2 + y**2)\nd = (x*u + y*v)/R"),
        ("cpp", "double R = sqrt(x*x + y*y); double d = (x*u + y*v)/R;"),
        ("matlab", "R = sqrt(x^2 + y^2); d = (x*u + y*v)/R;"),
    ],
)
def test_a_result_on_which_another_rests_is_one_where_so_many_are_wanted(notation: str, formula: str) -> None:
    if notation in {"cpp", "matlab"}:
        pytest.importorskip("tree_sitter", reason=f"{notation} is read with it")
    pair = read_formula(formula, notation, None, wanted=2).tree
    assert to_text(pair).startswith("[sqrt(")
    assert not to_text(read_formula(formula, notation, None).tree).startswith("[")


def test_the_results_are_what_nothing_rests_on_or_the_last_that_are_wanted() -> None:
    assert results(["a", "b"], {"a"}, 1) == [1]
    assert results(["a", "b", "c"], {"a", "b"}, 2) == [1, 2]
    assert results(["a", "b", "c"], {"c"}, 3) == [0, 1, 2]
    assert results(["a", "b", "c"], {"b"}, 2) == [0, 2]
    assert results(["a"], {"a"}, 2) == []


@pytest.mark.parametrize("formula", ["1,5*r", "(0,5)", "r*2,5", "r*cos(beta), 2,5*r"])
def test_a_decimal_comma_is_no_vector(formula: str) -> None:
    with pytest.raises(FormulaError, match="decimals follow a point"):
        read_text(formula, None)


@pytest.mark.parametrize("formula", ["atan2(1,2)", "[0,5]", "[1,2; 3,4]"])
def test_arguments_and_entries_in_brackets_need_no_space(formula: str) -> None:
    assert to_text(read_text(formula, None))


@pytest.mark.parametrize("formula", ["a = b, b = a", "x = a, x = ", ", a", "a,, b", "P[0,0] = a, P[1,2] = b"])
def test_what_is_no_set_of_equations_is_refused(formula: str) -> None:
    with pytest.raises(FormulaError):
        read_text(formula, None)


@pytest.mark.parametrize(
    "between", [", ", r",\quad ", r"\quad ", "; ", r",\ \text{where } ", r"\quad\text{with}\quad "]
)
@pytest.mark.parametrize(
    ("formula", "definition", "text"),
    [
        (r"\frac{r\cos\theta}{\lambda}", r"\lambda = e^{-s^2/2}", "r*cos(theta)/e**(-s**2/2)"),
        (r"\lambda r", r"\lambda \triangleq 3", "3*r"),
        (r"\begin{bmatrix}1&\rho\\0&1\end{bmatrix}", r"\rho = e^{-a}", "[[1, e**(-a)], [0, 1]]"),
        (r"r\cos b, r\sin b", "r = 2", "[2*cos(b), 2*sin(b)]"),
        (r"\begin{cases}X=N c\\Y=N s\end{cases}", "N = a", "[a*c, a*s]"),
        (r"\left\{\begin{array}{l}X=N c\\Y=N s\end{array}\right.", "N = a", "[a*c, a*s]"),
        (r"G G^T q", r"G = \begin{bmatrix}T^2/2\\T\end{bmatrix}", "[T**2/2, T]*[T**2/2, T].T*q"),
        (r"X = N(\phi)c, Y = N(\phi)s", r"N(\phi) = a\sin\phi", "[(a*sin(phi))*c, (a*sin(phi))*s]"),
        ("x, y", "z = r, s", "[r, s]"),
    ],
)
def test_a_formula_before_a_definition_is_no_left_side_of_it(
    formula: str, between: str, definition: str, text: str
) -> None:
    names = {"a", "c", "s", "b", "r", "q", "T", "theta", "phi", "rho"}
    read = read_formula(formula + between + definition, LATEX, names, strangers=True)
    assert to_text(read.tree) == text


@pytest.mark.parametrize("wanted", [1, 2, 3])
def test_one_vector_that_rests_on_definitions_is_as_many_numbers_by_itself(wanted: int) -> None:
    """The last equations are the result where that many numbers are wanted, unless one of them is an array."""
    vector = r"\lambda\begin{bmatrix}r\\s\end{bmatrix},\quad \lambda = a, \quad a = 2"
    assert to_text(read_formula(vector, LATEX, None, wanted=wanted).tree) == "2*[r, s]"
    assert to_text(read_text("c*[r, s], c = a, a = 2", None, wanted=wanted)) == "2*[r, s]"
    assert to_text(read_text("q = x, p = q/x", None, wanted=2)) == "[x, x/x]"
