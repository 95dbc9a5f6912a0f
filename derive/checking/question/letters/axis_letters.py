"""A matrix for several axes with a block for each, which are the same but for letters that say the axis."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass

from radartrack.derive.checking.question.printed_shape import grids_of
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.tree import Name, Tree, parts
from radartrack.derive.language.tensor import Index, Tensor


@dataclass(frozen=True)
class Axis:
    """A block of a matrix, and what is to be said of the others.

    Attributes:
        block: its entries.
        words: which axis it is of, or that all are the same.
        others: which letters the others have for its own.
    """

    block: Tensor[Tree]
    words: str
    others: str = ""


def axes_of(entries: Tensor[Tree], expected: Index, known: Collection[str]) -> list[Axis]:
    """The blocks of a matrix that are not the same in other letters, the first one first; none where it has no blocks.

    Args:
        entries: of the matrix.
        expected: the shape of a block.
        known: letters of which it is known what they are: they stand for no others.
    """
    for grid in grids_of(entries, expected):
        blocks = list(grid.diagonal)
        alike = _alike(blocks[0], [*blocks[1:], *grid.others], known)
        if alike is not None:
            others = f", others with {same}" if (same := _said(alike)) else ""
            return [Axis(blocks[0], f"read for one axis of {len(blocks)}: all have the same block{others}", others)]
        if not grid.others:
            return [Axis(block, f"read for axis {at + 1} of {len(blocks)}") for at, block in enumerate(blocks)]
    return []


def one_axis(entries: Tensor[Tree], axes: int) -> tuple[Tensor[Tree], str] | None:
    """The block of a matrix that has the same one for so many axes, and letters of others; one column is a vector."""
    if len(entries.shape) != 2 or any(size % axes for size in entries.shape):
        return None
    rows, columns = (size // axes for size in entries.shape)
    found = axes_of(entries, (rows, columns) if columns > 1 else (rows,), ())
    return (found[0].block, found[0].others) if len(found) == 1 else None


def _alike(first: Tensor[Tree], others: Sequence[Tensor[Tree]], known: Collection[str]) -> dict[str, str] | None:
    """Which letters other blocks have for those of the first; None where they are not the same in other letters."""
    letters: dict[str, str] = {}
    for block in others:
        own = _renaming(first, block)
        if own is None or not own.keys().isdisjoint(known) or any(letters.get(a, b) != b for a, b in own.items()):
            return None
        letters |= own
    return letters


def _renaming(first: Tensor[Tree], other: Tensor[Tree]) -> dict[str, str] | None:
    """The letters of another block by those that stand there in the first; None where the blocks differ otherwise."""
    pairs = list(zip(_letters(other), _letters(first), strict=False))
    renaming = {theirs: ours for theirs, ours in pairs if theirs != ours}
    is_new = renaming.keys().isdisjoint(_letters(first)) and len(set(renaming.values())) == len(renaming)
    renamed = other.map(lambda entry: rebuild(entry, lambda node: _as_first(node, renaming)))
    return renaming if is_new and renamed == first else None


def _as_first(node: Tree, renaming: Mapping[str, str]) -> Tree:
    return Name(renaming[node.name], span=node.span) if isinstance(node, Name) and node.name in renaming else node


def _letters(block: Tensor[Tree]) -> Iterator[str]:
    return (node.name for entry in block for node in parts(entry) if isinstance(node, Name))


def _said(letters: Mapping[str, str]) -> str:
    return ", ".join(f"{theirs} for {ours}" for theirs, ours in letters.items())
