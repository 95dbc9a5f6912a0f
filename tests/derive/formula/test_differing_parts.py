"""Where two formulas differ: what is left when the rest is taken from both."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.formula.differing_parts import differing_parts
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Name, Tree, replace_at, subtree, walk
from radartrack.derive.reading.text import read_text
from tests.derive.formula.random_trees import trees

NAMES = ("a", "b", "c", "r", "s")


def parts(first: str, second: str) -> tuple[list[str], list[str]]:
    one, other = read_text(first, NAMES), read_text(second, NAMES)
    left, right = differing_parts(one, other)
    return sorted(to_text(subtree(one, path)) for path in left), sorted(to_text(subtree(other, path)) for path in right)


@pytest.mark.parametrize(
    ("first", "second", "left", "right"),
    [
        ("a*b*cos(r)", "b*a*sin(r)", ["cos(r)"], ["sin(r)"]),
        ("a*b + c", "c + a*s", ["b"], ["s"]),
        ("a**2*b", "a**3*b", ["2"], ["3"]),
        ("a - b", "a + b", ["-b"], ["b"]),
        ("a + b", "a + b + c", ["a + b"], ["c"]),
        ("a", "a*b", ["a"], ["b"]),
        ("a*b*c", "a*c", ["b"], ["a*c"]),
        ("sqrt(a + b)", "sqrt(a + 2*b)", ["b"], ["2"]),
        ("[[a, b], [c, a]]", "[[a, b], [s, a]]", ["c"], ["s"]),
        ("a/b", "b/a", ["a/b"], ["b/a"]),
        ("a", "b", ["a"], ["b"]),
    ],
)
def test_the_smallest_parts_are_named(first: str, second: str, left: list[str], right: list[str]) -> None:
    assert parts(first, second) == (left, right)


@given(trees)
def test_equal_formulas_differ_nowhere(tree: Tree) -> None:
    assert differing_parts(tree, tree) == (frozenset(), frozenset())


@given(trees, st.data())
def test_one_part_that_is_another_name_lies_within_what_differs(tree: Tree, data: st.DataObject) -> None:
    path = data.draw(st.sampled_from([path for path, _ in walk(tree)]))
    other = replace_at(tree, path, Name("strange"))
    left, right = differing_parts(tree, other)
    assert left
    assert any(path[: len(one)] == one for one in right)
