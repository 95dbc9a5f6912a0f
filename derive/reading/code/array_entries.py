"""Arrays of code by their entries: picked, set, and what a language computes entry by entry."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.shape import Shape
from radartrack.derive.formula.tree import Array, Entries, Place, Tree
from radartrack.derive.formula.written_out import written_out
from radartrack.derive.language.tensor import Tensor


def entry_of(tree: Tree, places: Sequence[Place], span: Span) -> Tree:
    """One entry of an array, picked from what is written out of it."""
    left = list(places)
    while left and isinstance(tree, Array) and isinstance(first := left[0], int):
        tree, left = tree.entries[first], left[1:]
    return Entries(tree, tuple(left), span=span) if left else tree


def entries_of(tree: Tree, shape: Shape, span: Span) -> Tensor[Tree]:
    """The entries of an array of this shape: written out where nothing has to be worked out, else picked."""
    try:
        opened = written_out(tree)
    except FormulaError:  # a name in it stands for an array
        opened = None
    if opened is not None and opened.shape == shape:
        return opened
    return Tensor.build(shape, lambda *places: entry_of(tree, places, span))


def joined(blocks: Sequence[Sequence[Tensor[Tree]]]) -> Tensor[Tree] | None:
    """The matrix that rows of blocks make; None where they do not fit. A vector is a column, a number one entry."""
    if not all(blocks):
        return None
    rows: list[tuple[Tree, ...]] = []
    for row in blocks:
        matrices = [Tensor((*block.shape, 1, 1)[:2], block.entries) for block in row]
        if len({matrix.shape[0] for matrix in matrices}) > 1:
            return None
        rows += [
            tuple(entry for matrix in matrices for entry in matrix.parts()[at].entries)
            for at in range(matrices[0].shape[0])
        ]
    if len({len(row) for row in rows}) > 1:
        return None
    return Tensor((len(rows), len(rows[0])), tuple(entry for row in rows for entry in row))


def changed(entries: Tensor[Tree], places: Sequence[Place], new: Tensor[Tree] | Tree) -> Tensor[Tree]:
    """The entries with others at some places: those of an array of the shape of these places, or one for all."""
    known = dict(entries.items())
    axes = [
        [place] if isinstance(place, int) else list(range(size))[slice(*place)]
        for place, size in zip(
            [*places, *[(None, None)] * (len(entries.shape) - len(places))], entries.shape, strict=True
        )
    ]
    where = list(product(*axes))
    values = new.entries if isinstance(new, Tensor) else (new,) * len(where)
    known.update(zip(where, values, strict=True))
    return Tensor(entries.shape, tuple(known.values()))
