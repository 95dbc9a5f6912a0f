"""Walking over trees and changing them."""

import pickle

from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.formula.tree import parts
from radartrack.derive.reading import Name, Tree, children, names, read_text, replace_at, subtree, walk, with_children
from tests.derive.formula.random_trees import trees


@given(trees)
def test_every_path_of_a_walk_leads_to_its_subtree(tree: Tree):
    for path, node in walk(tree):
        assert subtree(tree, path) is node


@given(trees)
def test_a_node_over_its_own_children_is_the_same(tree: Tree):
    for _, node in walk(tree):
        assert with_children(node, children(node)) == node


@given(trees, st.data())
def test_replacing_changes_one_place_and_no_other(tree: Tree, data: st.DataObject):
    path, old = data.draw(st.sampled_from(list(walk(tree))))
    changed = replace_at(tree, path, Name("new"))
    assert subtree(changed, path) == Name("new")
    assert replace_at(changed, path, old) == tree


@given(trees)
def test_trees_survive_the_way_between_processes(tree: Tree):
    again = pickle.loads(pickle.dumps(tree))  # noqa: S301 - made in this line
    assert again == tree
    assert hash(again) == hash(tree)


@given(trees)
def test_the_parts_are_the_nodes_of_a_walk_each_once(tree: Tree):
    found = list(parts(tree, tree))
    assert len({id(node) for node in found}) == len(found)
    assert {id(node) for node in found} == {id(node) for _, node in walk(tree)}
    assert found[0] is tree


def test_names_are_symbols_and_no_constants():
    assert names(read_text("r*cos(beta) + pi*e", ["r", "beta"])) == {"r", "beta"}


def test_where_a_node_stood_does_not_count():
    assert read_text("r+k", ["r", "k"]) == read_text("( r  +  k )", ["r", "k"])
    assert hash(read_text("r+k", ["r", "k"])) == hash(read_text("( r  +  k )", ["r", "k"]))
