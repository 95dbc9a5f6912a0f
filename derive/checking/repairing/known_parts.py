"""Parts of formulas, found by their values: a factor or term that print has lost is a part of the derived one."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from radartrack.derive.evaluation.tree_values import Screen, Values, close
from radartrack.derive.formula.tree import Array, Name, Negation, Number, Tree, parts

SCALE = (
    1e7  # digits of a size that are looked at: coarser, and each look-up finds many; finer, and rounding hides a part
)
MOST = 2000  # different parts; the longest entry has a thousand, a stranger may have thirty thousand


class Pieces:
    """Parts of some trees by their values, up to sign."""

    def __init__(self, trees: Iterable[Tree], screen: Screen) -> None:
        self._known: dict[int, list[tuple[Tree, Values]]] = {}
        for node in _first_different(parts(*trees)):
            if not isinstance(node, Number | Name | Negation | Array):
                self._add(node, screen(node))

    def find(self, values: Values | None) -> Iterator[tuple[Tree, int]]:
        """Parts with these values, and the sign with which they have them."""
        if values is None or not values or not values[0]:
            return
        for tree, known in self._known.get(_key(values), ()):
            if close(known, values):
                yield tree, 1
            elif close(known, tuple(-value for value in values)):
                yield tree, -1

    def _add(self, tree: Tree, values: Values | None) -> None:
        if values and values[0]:
            self._known.setdefault(_key(values), []).append((tree, values))


def _first_different(nodes: Iterable[Tree]) -> dict[Tree, None]:
    found: dict[Tree, None] = {}
    for node in nodes:
        if len(found) == MOST:
            break
        found[node] = None
    return found


def _key(values: Values) -> int:
    """The size at the first point to a few digits."""
    return round(math.log(abs(values[0])) * SCALE)
