"""Where two formulas differ: the smallest parts of each that the other does not have."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from radartrack.derive.formula.tree import Call, Entries, Path, Product, Sum, Tree, children

Paths = frozenset[Path]
Pair = tuple[list[Path], list[Path]]


def differing_parts(first: Tree, second: Tree) -> tuple[Paths, Paths]:
    """The paths of the parts in which two trees differ, in the first and in the second.

    Of two sums or products, terms that both have are left out, in whatever order they stand; where only one of them
    has more, the other one differs as a whole. Equal trees differ nowhere.
    """
    left, right = _differing(first, second, (), ())
    return frozenset(left), frozenset(right)


def _differing(first: Tree, second: Tree, left: Path, right: Path) -> Pair:
    if first == second:
        return [], []
    if isinstance(first, Sum | Product) and type(first) is type(second):
        return _unordered(first, second, left, right)
    below = children(first), children(second)
    if _are_alike(first, second) and len(below[0]) == len(below[1]):
        places = [place for place, (a, b) in enumerate(zip(*below, strict=True)) if a != b]
        if len(places) < len(below[0]) or len(places) == 1:
            return _together(
                _differing(below[0][place], below[1][place], (*left, place), (*right, place)) for place in places
            )
    for kind in (Sum, Product):  # one is a term or a factor of the other
        if isinstance(second, kind) and first in children(second):
            return [left], [(*right, place) for place in _left_over(children(second), [first])]
        if isinstance(first, kind) and second in children(first):
            return [(*left, place) for place in _left_over(children(first), [second])], [right]
    return [left], [right]


def _are_alike(first: Tree, second: Tree) -> bool:
    """Whether two nodes are of one kind, so that what differs is below them."""
    match first, second:
        case (Call(one), Call(other)):
            return one == other
        case (Entries(_, one_place), Entries(_, other_place)):
            return one_place == other_place
    return type(first) is type(second) and bool(children(first))


def _unordered(first: Tree, second: Tree, left: Path, right: Path) -> Pair:
    below = children(first), children(second)
    ours, theirs = _left_over(*below), _left_over(below[1], below[0])
    if len(ours) == len(theirs) == 1:
        (place,), (other,) = ours, theirs
        return _differing(below[0][place], below[1][other], (*left, place), (*right, other))
    return (
        [(*left, place) for place in ours] or [left],
        [(*right, place) for place in theirs] or [right],
    )


def _left_over(trees: Sequence[Tree], others: Sequence[Tree]) -> list[int]:
    """The places of trees that the others do not have; what occurs twice is to be there twice."""
    waiting = list(others)
    places = []
    for place, tree in enumerate(trees):
        if tree in waiting:
            waiting.remove(tree)
        else:
            places.append(place)
    return places


def _together(pairs: Iterator[Pair]) -> Pair:
    left: list[Path] = []
    right: list[Path] = []
    for ours, theirs in pairs:
        left += ours
        right += theirs
    return left, right
