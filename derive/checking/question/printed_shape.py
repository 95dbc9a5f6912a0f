"""What is printed in another shape than the quantity has and means the same.

A matrix may have the same block for each of several axes, and rows for columns where that can be seen; a vector may be
a matrix of one row or column.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import prod
from typing import Generic, TypeVar

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Negation, Number, Product, Quotient, Tree
from radartrack.derive.language.tensor import Index, Tensor, indices

Entry = TypeVar("Entry")


def reshaped(entries: Tensor[Entry], expected: Index, *, row_by_row: bool = False) -> Tensor[Entry]:
    """The entries in the expected shape, where theirs is one of the same thing; as they are where it is not.

    Args:
        entries: those that are printed.
        expected: the shape of the quantity.
        row_by_row: whether a list may be a matrix row by row, as code fills one.
    """
    if is_transposed(entries.shape, expected):
        return Tensor(expected, tuple(entries[index[::-1]] for index in indices(expected)))
    if blocks := blocks_of(entries, expected):
        return blocks[0] if all(block == blocks[0] for block in blocks) else entries
    ours, theirs = ([size for size in one if size > 1] for one in (expected, entries.shape))
    filled = row_by_row and len(entries.shape) == 1 and prod(expected) == len(entries.entries)
    return Tensor(expected, entries.entries) if ours == theirs or filled else entries


def spoken(shape: Index) -> str:
    """A shape in words."""
    return f"an array of shape {list(shape)}" if shape else "a scalar"


def wrong_shape(entries: Tensor[Tree], expected: Index) -> FormulaError:
    """What to say of a formula that is not of the expected shape, or not the same for all axes."""
    for block in (blocks := blocks_of(entries, expected)):
        for index, entry in block.items():
            if entry != blocks[0][index]:
                first, other = to_text(blocks[0][index]), to_text(entry)
                words = f"the quantity is of one axis, and in entry {list(index)} the axes differ: {first} and {other}"
                return FormulaError(words, span=entry.span)
    return FormulaError(f"the formula is {spoken(entries.shape)}, the quantity is {spoken(expected)}")


def is_transposed(shape: Index, expected: Index) -> bool:
    """Whether a matrix has as many rows as the other has columns, and other numbers of both."""
    return len(expected) == 2 and 1 not in expected and shape == expected[::-1] != expected


@dataclass(frozen=True)
class Grid(Generic[Entry]):
    """A matrix for several axes: the block of each, and those between two axes that are not zero."""

    diagonal: tuple[Tensor[Entry], ...]
    others: tuple[Tensor[Entry], ...]


def grids_of(entries: Tensor[Entry], expected: Index) -> Iterator[Grid[Entry]]:
    """How a matrix may be one for several axes, with blocks of the expected shape.

    A state may be (x, vx, y, vy) or (x, y, vx, vy): blocks lie side by side, or their entries lie scattered.
    """
    if len(entries.shape) != 2 or len(expected) not in {1, 2}:
        return
    rows, columns = (*expected, 1)[:2]
    count = entries.shape[0] // rows
    if count < 2 or entries.shape != (count * rows, count * columns):
        return
    for step, stride in (((rows, columns), 1), ((1, 1), count)):

        def block(above: int, left: int, step: Index = step, stride: int = stride) -> Tensor[Entry]:
            corner = step[0] * above, step[1] * left
            places = ((corner[0] + stride * i, corner[1] + stride * j) for i, j in indices((rows, columns)))
            return Tensor(expected, tuple(entries[place] for place in places))

        between = (block(one, other) for one in range(count) for other in range(count) if one != other)
        diagonal = tuple(block(axis, axis) for axis in range(count))
        yield Grid(diagonal, tuple(one for one in between if not all(map(vanishes, one))))


def blocks_of(entries: Tensor[Entry], expected: Index) -> list[Tensor[Entry]]:
    """The blocks of a matrix with one of the expected shape for each axis and zeros else; none where it is no such."""
    return next((list(grid.diagonal) for grid in grids_of(entries, expected) if not grid.others), [])


def vanishes(entry: object) -> bool:
    """Whether an entry is written as zero."""
    match entry:
        case Number(value=value):
            return not value
        case Product(factors=factors):
            return any(map(vanishes, factors))
        case Quotient(numerator=above) | Negation(operand=above):
            return vanishes(above)
    return entry == 0
