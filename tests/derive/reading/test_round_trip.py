"""Printing a tree and reading it again."""

from hypothesis import given, reject
from hypothesis import strategies as st

from radartrack.derive.reading import (
    Array,
    FormulaError,
    Number,
    Tree,
    read_latex,
    read_text,
    to_latex,
    to_text,
    walk,
)
from radartrack.derive.reading.grammar import check_tree
from tests.derive.formula.random_trees import NAMES, trees


def sound(tree: Tree) -> Tree:
    """The tree, when the readers' limits let it through."""
    try:
        return check_tree(tree)
    except FormulaError:
        reject()


@given(trees)
def test_text_that_is_printed_is_read_as_the_same_tree(tree: Tree):
    assert read_text(to_text(sound(tree)), NAMES) == tree


@given(trees)
def test_latex_that_is_printed_is_read_as_the_same_tree(tree: Tree):
    assert read_latex(to_latex(sound(tree)), NAMES) == tree


@given(trees)
def test_the_echo_of_latex_is_read_as_the_same_tree(tree: Tree):
    assert read_text(to_text(read_latex(to_latex(sound(tree)), NAMES)), NAMES) == tree


@given(st.sampled_from(["1e-3", "2.5E+4", ".5", "3.", "1e0"]))
def test_latex_prints_the_value_of_any_decimal(text: str):
    (number,) = [node for _, node in walk(read_latex(to_latex(Number(text)), [])) if isinstance(node, Number)]
    assert number.value == Number(text).value


def test_a_matrix_of_one_column_reads_back_as_a_vector():
    column = read_text("[[r], [k]]", NAMES)
    assert read_latex(to_latex(column), NAMES) == Array(tuple(read_text(name, NAMES) for name in "rk"))


@given(trees, st.sampled_from(["\n", "\t", "  ", "\r\n"]))
def test_white_space_between_the_parts_of_a_formula_changes_nothing(tree: Tree, space: str):
    text = to_text(sound(tree)).replace(" ", space).replace("*", f"{space}*").replace("* *", "**")
    text = text.replace(f"*{space}*", "**")
    assert read_text(text, NAMES) == tree
