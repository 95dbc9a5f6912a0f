"""In which order the entries of a formula are right: a transpose, or a state whose parts stand otherwise."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import permutations, product

from radartrack.derive.language.tensor import Index, indices

LONGEST = 4  # rows whose orders are all tried
LONGEST_STATE = 6  # rows whose orders are tried together with those of the columns

Order = tuple[int, ...]


@dataclass(frozen=True)
class Arrangement:
    """An order of entries.

    Attributes:
        words: the order, in words: "when transposed"; nothing for ours.
        places: where the entries come from, row by row.
    """

    words: str
    places: tuple[Index, ...]

    @property
    def cost(self) -> float:
        """How unlikely it is, on the scale of edits."""
        return 0.0 if not self.words else 1.05 + 0.5 * self.words.count(" and the columns")


def arrangements_that_fit(shape: Index, same: Callable[[int, Index], bool]) -> list[tuple[Arrangement, list[int]]]:
    """The arrangements in which the fewest entries are wrong, with those, the plainest first.

    Args:
        shape: that of the formula.
        same: whether the entry at a place of the print, counted row by row, has the value of an entry of ours.
    """
    known = {(place, index): same(place, index) for place in range(_size(shape)) for index in indices(shape)}
    found = [(one, [n for n, index in enumerate(one.places) if not known[n, index]]) for one in _arrangements(shape)]
    return sorted(found, key=lambda pair: len(pair[1]) + pair[0].cost)


@lru_cache(maxsize=64)
def _arrangements(shape: Index) -> tuple[Arrangement, ...]:
    """All of a shape, ours first."""
    ours = Arrangement("", tuple(indices(shape)))
    if len(shape) not in {1, 2} or max(shape) > LONGEST_STATE:
        return (ours,)
    return tuple({one.places: one for one in reversed((ours, *_others(shape)))}.values())[::-1]


def _others(shape: Index) -> Iterator[Arrangement]:
    if len(shape) == 1:
        for order in permutations(range(*shape)):
            yield Arrangement(f"with the entries in the order {_spoken(order)}", tuple((place,) for place in order))
        return
    rows, columns = shape
    if rows == columns:
        yield Arrangement("when transposed", tuple(place[::-1] for place in indices(shape)))
        for order in permutations(range(rows)):
            yield Arrangement(f"with rows and columns in the order {_spoken(order)}", tuple(product(order, order)))
    if max(shape) <= LONGEST:
        for pair in product(permutations(range(rows)), permutations(range(columns))):
            yield Arrangement(f"with {_of_rows_and_columns(*pair)}", tuple(product(*pair)))


def _of_rows_and_columns(rows: Order, columns: Order) -> str:
    orders = {"the rows": rows, "the columns": columns}
    changed = [
        f"{name} in the order {_spoken(order)}" for name, order in orders.items() if list(order) != sorted(order)
    ]
    return " and ".join(changed)


def _spoken(order: Sequence[int]) -> str:
    return ", ".join(map(str, order))


def _size(shape: Index) -> int:
    return len(list(indices(shape)))
