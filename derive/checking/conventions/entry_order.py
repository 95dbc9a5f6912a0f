"""Whether the entries of a formula are right in another order: a transpose, or a state whose parts stand otherwise."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import permutations, product

from radartrack.derive.checking.conventions.altered_question import Trial, evaluated
from radartrack.derive.language.tensor import Index, Tensor, indices
from radartrack.derive.symbolic import Expr

LONGEST = 4  # rows whose orders are all tried

Order = tuple[int, ...]


def arrangement(one: Trial, entries: Tensor[Expr]) -> str | None:
    """In which order of its entries the formula is proved equal, in words: "when transposed"."""
    values = evaluated(entries, one.symbols, one.point)
    if values is None or len(entries.shape) not in {1, 2} or max(entries.shape) > LONGEST:
        return None
    known = Tensor(entries.shape, values)
    for words, places in _arrangements(entries.shape):
        moved = [known[place] for place in places]
        if one.is_worth(moved) and one.proves(Tensor(entries.shape, tuple(entries[place] for place in places))):
            return words
    return None


def _arrangements(shape: Index) -> Iterator[tuple[str, list[Index]]]:
    """Where the entries come from, row by row, and that in words."""
    if len(shape) == 1:
        for order in permutations(range(*shape)):
            yield f"with the entries in the order {_spoken(order)}", [(place,) for place in order]
        return
    rows, columns = shape
    if rows == columns:
        yield "when transposed", [place[::-1] for place in indices(shape)]
        for order in permutations(range(rows)):
            yield f"with rows and columns in the order {_spoken(order)}", list(product(order, order))
    for pair in product(permutations(range(rows)), permutations(range(columns))):
        yield f"with {_of_rows_and_columns(*pair)}", list(product(*pair))


def _of_rows_and_columns(rows: Order, columns: Order) -> str:
    orders = {"the rows": rows, "the columns": columns}
    changed = [
        f"{name} in the order {_spoken(order)}" for name, order in orders.items() if list(order) != sorted(order)
    ]
    return " and ".join(changed)


def _spoken(order: Sequence[int]) -> str:
    return ", ".join(map(str, order))
