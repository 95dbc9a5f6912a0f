"""Several formulas with names for them, as one: definitions are put in, entries become a matrix, the rest a vector."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import Fold, rebuild
from radartrack.derive.formula.limits import MAX_DEPTH, MAX_NODES
from radartrack.derive.formula.shape import shape
from radartrack.derive.formula.tree import Array, Name, Tree, names, with_span

ALL = 0  # numbers wanted: as many as no other rests on
_ENTRY = re.compile(r"(?P<base>[A-Za-z]\w*?)_?(?P<row>\d)_?(?P<column>\d)")
_COVARIANCE = re.compile(r"(?P<base>[A-Za-z]\w*?)_?(?P<row>[xyz])_?(?P<column>[xyz])")  # R_xx, R_xy


@dataclass(frozen=True, slots=True)
class Definition:
    """A formula and the name that stands left of it; empty where there is none."""

    name: str
    tree: Tree


def combined(found: Sequence[Definition], wanted: int = 1) -> Tree:
    """What several equations say together: that which no other of them uses, with the others put into it.

    Several of those are the entries of a matrix where they are named so (R_11, R_12), else of a vector.

    Args:
        found: the equations.
        wanted: of how many numbers the result is to be.

    Raises:
        FormulaError: when a name is defined by itself, or an entry of the matrix is missing.
    """
    if len(found) == 1:
        return found[0].tree
    defined = {one.name: one.tree for one in found if one.name}
    used = set().union(*(names(one.tree) for one in found))
    meant = results([one.name for one in found], used, wanted)
    if not meant:
        raise FormulaError(
            "each of these equations is used by another one: none is the result", span=found[-1].tree.span
        )
    insert = Insertion(defined)
    alone = results([one.name for one in found], used, 1)
    if len(alone) == 1 and _is_array(whole := insert(found[alone[0]].tree)):
        return whole  # which is as many numbers by itself
    made = [Definition(found[place].name, insert(found[place].tree)) for place in meant]
    return made[0].tree if len(made) == 1 else _array(made)


def results(defined: Sequence[str], used: Collection[str], wanted: int) -> list[int]:
    """Which of several definitions are the result, by their places: those on which no other rests.

    Where more numbers are wanted, the last ones, if all of those are among them: a range rate may rest on the range.

    Args:
        defined: the names, in order.
        used: those on which another rests.
        wanted: how many numbers the result is to be, or `ALL`.
    """
    unused = [place for place, name in enumerate(defined) if name not in used]
    last = range(max(len(defined) - wanted, 0), len(defined))
    return list(last) if 0 < len(unused) < wanted == len(last) and set(unused) <= set(last) else unused


class Insertion:
    """Puts definitions into formulas, and those into each other.

    Args:
        defined: formulas by name.
    """

    def __init__(self, defined: Mapping[str, Tree]) -> None:
        self._defined = defined
        self._inserted: dict[str, Tree] = {}
        self._waiting: list[str] = []

    def __call__(self, tree: Tree) -> Tree:
        """The formula without the names that are defined.

        Raises:
            FormulaError: when one is defined by itself, or the result is too large.
        """
        result = rebuild(tree, self._of)
        check_expanded(result)
        return result

    def _of(self, node: Tree) -> Tree:
        if not isinstance(node, Name) or node.name not in self._defined:
            return node
        name = node.name
        if name in self._waiting:
            raise FormulaError(f"{name} is defined by itself", span=node.span)
        if name not in self._inserted:
            self._waiting.append(name)
            self._inserted[name] = self(self._defined[name])
            self._waiting.pop()
        return self._inserted[name]


def expanded_size(tree: Tree) -> tuple[int, int]:
    """The parts and the depth of a formula when what it shares is written out."""
    return Fold(_size)(tree)


def check_expanded(tree: Tree) -> None:
    """Refuse a formula that is too large when what it shares is written out; itself it may be small.

    Raises:
        FormulaError: naming the limit.
    """
    nodes, depth = expanded_size(tree)
    if nodes > MAX_NODES:
        raise FormulaError(f"the formula has more than {MAX_NODES} parts", span=tree.span)
    if depth > MAX_DEPTH:
        raise FormulaError(f"the formula is nested more than {MAX_DEPTH} deep", span=tree.span)


def _size(_node: Tree, below: Sequence[tuple[int, int]]) -> tuple[int, int]:
    return 1 + sum(nodes for nodes, _ in below), 1 + max((depth for _, depth in below), default=0)


def _is_array(tree: Tree) -> bool:
    try:
        return bool(shape(tree))
    except FormulaError:  # is told when the whole formula is looked at
        return False


def _array(found: Sequence[Definition]) -> Tree:
    """The entries of a matrix, where all are named so, else of a vector."""
    span = (found[0].tree.span or (0, 0))[0], (found[-1].tree.span or (0, 0))[1]
    for pattern in (_ENTRY, _COVARIANCE):
        base, entries = _entries(found, pattern)
        rows, columns = (_lines(entries, axis) for axis in (0, 1))
        missing = [(row, column) for row in rows for column in columns if (row, column) not in entries]
        if missing and pattern is _ENTRY:
            raise FormulaError(f"the entry {base}_{missing[0][0]}{missing[0][1]} is missing", span=span)
        if entries and not missing:
            made = (Array(tuple(entries[row, column] for column in columns), span=span) for row in rows)
            return with_span(Array(tuple(made)), span)
    return Array(tuple(one.tree for one in found), span=span)


def _lines(entries: Collection[tuple[str, str]], axis: int) -> list[str]:
    """The rows or columns: of numbered ones all between the first and the last, of coordinates those that occur."""
    used = sorted({place[axis] for place in entries})
    numbers = [number for number in "0123456789" if entries and min(map(min, entries)) <= number <= used[-1]]
    return numbers if used and used[0].isdigit() else used


def _entries(found: Sequence[Definition], pattern: re.Pattern[str]) -> tuple[str, dict[tuple[str, str], Tree]]:
    """The one name of a matrix, and the formulas by their places in it; none where they are no entries of one."""
    places = [place for one in found if (place := pattern.fullmatch(one.name))]
    bases = {place["base"] for place in places}
    if len(bases) != 1 or len(places) < len(found):
        return "", {}
    entries = {(place["row"], place["column"]): one.tree for place, one in zip(places, found, strict=True)}
    if all(row <= column for row, column in entries) or all(row >= column for row, column in entries):
        entries |= {place[::-1]: tree for place, tree in entries.items()}  # one half of a symmetric matrix is printed
    return bases.pop(), entries
