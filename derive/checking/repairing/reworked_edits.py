"""Edits of a formula that is worked out, or that stands in a definition: each is put in and everything done again.

What a part would have to be worth cannot be told there, so every likely slip is undone in turn, the likeliest first,
for as long as there is time.
"""

from __future__ import annotations

import time
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress

from radartrack.derive.checking.repairing.edit_search import Candidate
from radartrack.derive.checking.repairing.matrix_slips import matrix_slips
from radartrack.derive.checking.repairing.print_slips import slips
from radartrack.derive.checking.reporting.barrier import attempted
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.functions import BINDING
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.shape import NO_SHAPES, Shape, shapes
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Name,
    Negation,
    Number,
    Path,
    Power,
    Product,
    Sum,
    Tree,
    replace_at,
    subtree,
    walk,
)

SECONDS = 3.0  # of one core
ENOUGH = 2
MOST = 2_000  # edits
LIKELY = 1.4  # the cost of the least likely slip
processor_time: Callable[[], float] = getattr(time, "thread_time", time.perf_counter)  # browsers do not count it


def edits_that(
    is_right: Callable[[Tree], bool], tree: Tree, kinds: Mapping[str, object], seconds: float = SECONDS
) -> list[Candidate]:
    """The single edits of a formula that make something right, the likeliest first.

    Args:
        is_right: works everything out again with the edited formula; what fails there is not right.
        tree: the formula.
        kinds: the symbols that may stand for others, and what makes them alike.
        seconds: how long this may take.
    """
    until = processor_time() + seconds
    found: list[Candidate] = []
    for candidate in sorted(single_edits(tree, kinds), key=lambda one: one.cost)[:MOST]:
        if processor_time() > until or len(found) >= ENOUGH:
            break
        if found and candidate.cost > found[0].cost:
            break
        if attempted(lambda edited=candidate.tree: is_right(edited), lambda _: False):  # type: ignore[misc]
            found.append(candidate)
    return found


def single_edits(
    tree: Tree, kinds: Mapping[str, object], arrays: Mapping[str, Shape] = NO_SHAPES
) -> Iterator[Candidate]:
    """The formula after each likely slip is undone.

    Args:
        tree: the formula.
        kinds: the symbols that may stand for others, and what makes them alike.
        arrays: the names that stand for arrays, and their shapes.
    """
    shape = shapes(defaultdict(tuple, arrays))
    for path, node in walk(tree):
        with suppress(FormulaError):  # of what is wrong around a slip: arrays that do not fit each other
            for edit in matrix_slips(node, arrays, shape):
                yield Candidate(replace_at(tree, path, edit.tree), edit.words, edit.cost)
    yield from _edits_of_numbers(tree, kinds)


def _edits_of_numbers(tree: Tree, kinds: Mapping[str, object]) -> Iterator[Candidate]:
    for path, node in walk(tree):
        if _is_bound(tree, path) or isinstance(node, Array):
            continue
        for edit in slips(node, kinds):
            if edit.cost <= LIKELY and edit.tree != node:
                yield Candidate(replace_at(tree, path, edit.tree), edit.words, edit.cost)
        if path and _has_entries(subtree(tree, path[:-1])) and not isinstance(node, Number):
            yield from _with_factors(tree, path, node, kinds)
        if not isinstance(node, Negation | Sum) and (not path or _is_entry(tree, path)):
            yield Candidate(replace_at(tree, path, Negation(node)), f"the sign of {to_text(node)}", 1.0)


def _with_factors(tree: Tree, path: Path, node: Tree, kinds: Mapping[str, object]) -> Iterator[Candidate]:
    """An entry with a factor that it lacks: a variance of angle is one of distance times the square of the range."""
    for name in sorted(kinds):
        for factor in (Name(name), Power(Name(name), Number("2"))):
            yield Candidate(
                replace_at(tree, path, Product((factor, node))), f"a missing factor {to_text(factor)}", LIKELY
            )


def _has_entries(tree: Tree) -> bool:
    return isinstance(tree, Array) or (isinstance(tree, Call) and tree.function == "diag")


def _is_bound(tree: Tree, path: Path) -> bool:
    """Whether the name of an index or the like stands there."""
    above = subtree(tree, path[:-1]) if path else tree
    return bool(path) and isinstance(above, Call) and above.function in BINDING and path[-1] == 1


def _is_entry(tree: Tree, path: Path) -> bool:
    return isinstance(subtree(tree, path[:-1]), Array | Product)
