"""What is known of formulas by their parts, and changing all parts of one."""

from collections import Counter
from collections.abc import Sequence

from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.formula.fold import Fold, shared
from radartrack.derive.formula.tree import parts
from radartrack.derive.reading import Name, Number, Sum, Tree, names, rebuild, walk
from tests.derive.formula.random_trees import trees


def size(_: Tree, below: Sequence[int]) -> int:
    return 1 + sum(below)


@given(trees)
def test_what_follows_from_the_parts_is_found(tree: Tree):
    assert Fold(size)(tree) == len(list(walk(tree)))


@given(trees, trees)
def test_an_object_that_trees_share_is_looked_at_once(first: Tree, second: Tree):
    seen = Counter[int]()
    fold = Fold[None](lambda node, _: seen.update([id(node)]))
    fold(Sum((first, second, first)))
    fold(Sum((second, first)))
    assert all(seen[id(node)] == 1 for node in parts(first, second))


def test_it_is_found_in_the_order_of_the_children():
    spoken = Fold[str](lambda node, below: node.name if isinstance(node, Name) else "".join(below))
    assert spoken(Sum((Name("b"), Sum((Name("a"), Name("c")))))) == "bac"


@given(trees)
def test_rebuilding_with_no_change_gives_the_same_tree(tree: Tree):
    assert rebuild(tree, lambda node: node) is tree


@given(trees)
def test_rebuilding_reaches_every_leaf(tree: Tree):
    numbered = rebuild(tree, lambda node: Number("7") if isinstance(node, Name) else node)
    assert not names(numbered)


@given(trees, st.booleans())
def test_a_shared_tree_is_the_same_formula_with_one_object_for_equal_parts(tree: Tree, twice: bool):
    formula = Sum((tree, rebuild(tree, lambda node: Name(node.name) if isinstance(node, Name) else node)))
    found = shared(shared(formula, lambda node: node) if twice else formula, lambda node: node)
    assert found == formula
    assert len(list(parts(found))) == len(set(parts(found)))


def test_sharing_changes_the_nodes_as_rebuilding_does():
    tree = Sum((Name("a"), Sum((Name("b"), Name("a")))))
    renamed = shared(tree, lambda node: Name("c") if isinstance(node, Name) else node)
    assert renamed == Sum((Name("c"), Sum((Name("c"), Name("c")))))
