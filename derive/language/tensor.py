"""Arrays of any rank with entries of any kind: expressions, exponential polynomials, series, units."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import product
from typing import Generic, TypeVar

Entry = TypeVar("Entry")
Other = TypeVar("Other")
Index = tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Tensor(Generic[Entry]):
    """Entries in row-major order; shape () is a scalar."""

    shape: Index
    entries: tuple[Entry, ...]

    @classmethod
    def build(cls, shape: Index, entry: Callable[..., Entry]) -> Tensor[Entry]:
        """Fill a tensor by calling `entry(i, j, ...)`."""
        return cls(shape, tuple(entry(*index) for index in indices(shape)))

    def __getitem__(self, index: Index) -> Entry:
        return dict(self.items())[index]

    def __iter__(self) -> Iterator[Entry]:
        return iter(self.entries)

    def items(self) -> Iterator[tuple[Index, Entry]]:
        """Pairs of index and entry."""
        return zip(indices(self.shape), self.entries, strict=True)

    @property
    def indices(self) -> list[Index]:
        """All indices, in the order of the entries."""
        return list(indices(self.shape))

    def parts(self) -> list[Tensor[Entry]]:
        """The tensors of one rank less along the first axis."""
        size, *inner = self.shape
        step = len(self.entries) // size
        return [Tensor(tuple(inner), self.entries[i * step : (i + 1) * step]) for i in range(size)]

    def map(self, function: Callable[[Entry], Other]) -> Tensor[Other]:
        """Apply a function to each entry."""
        return Tensor(self.shape, tuple(function(entry) for entry in self.entries))

    def map_distinct(self, function: Callable[[Entry], Other]) -> Tensor[Other]:
        """The same, calling the function once for entries that are equal, as in symmetric tensors."""
        known = {entry: function(entry) for entry in dict.fromkeys(self.entries)}
        return self.map(known.__getitem__)


def indices(shape: Index) -> Iterator[Index]:
    """All indices of a shape, the last one running fastest."""
    return product(*(range(size) for size in shape))


def nested(entries: Tensor[Entry], level: int = 0, gap: str = ",\n") -> str:
    """As nested lists; without another gap, one row a line, indented by level."""
    if not entries.shape:
        return str(entries.entries[0])
    between = gap + " " * (level + 1) if gap.endswith("\n") else gap
    return f"[{between.join(nested(part, level + 1, gap) for part in entries.parts())}]"
