"""What is too much in a printed matrix or vector: states that do not enter, with zeros, and some that never change."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations

from radartrack.derive.formula.tree import Array, Number, Tree
from radartrack.derive.language.tensor import Index


def trimmed(tree: Tree, expected: Index) -> tuple[Tree, str]:
    """The formula without what is too much in it, where something is, and what was left out.

    So are rows and columns of zeros, zeros of a vector, and states that stay as they are in a transition. Where more
    is zero than is too much, the last are left out.
    """
    if not isinstance(tree, Array):
        return tree, ""
    rows = [row.entries for row in tree.entries if isinstance(row, Array)]
    if not rows and len(expected) == 1:
        return _short(tree, expected[0]) or (tree, "")
    if len(expected) != 2 or len(rows) < len(tree.entries) or len(set(map(len, rows))) != 1:
        return tree, ""
    surplus = len(rows) - expected[0], len(rows[0]) - expected[1]
    if min(surplus) < 0 or not any(surplus):
        return tree, ""
    for out_rows, out_columns in _choices(rows, surplus):
        return _without(tree, out_rows, out_columns), _left_out(out_rows, out_columns)
    still = still_states(rows)[::-1][: surplus[0]] if len(rows) == len(rows[0]) else []
    if surplus[0] != surplus[1] or len(still) < surplus[0]:
        return tree, ""
    return _without(tree, still, still), f"without {_named('state', sorted(still))}, which never changes"


def still_states(rows: Sequence[Sequence[Tree]]) -> list[int]:
    """Those of a square matrix whose rows and columns are those of an identity matrix: they stay as they are."""
    size = range(len(rows))

    def is_one(place: int) -> bool:
        around = (rows[at][place] for at in size if at != place), (rows[place][at] for at in size if at != place)
        return rows[place][place] == Number("1") and all(_is_zero(entry) for line in around for entry in line)

    return [place for place in size if is_one(place)]


def _short(vector: Array, size: int) -> tuple[Tree, str] | None:
    """A vector without zeros that are too many, the last first."""
    zeros = [place for place, entry in enumerate(vector.entries) if _is_zero(entry)]
    surplus = len(vector.entries) - size
    out = zeros[len(zeros) - surplus :] if 0 < surplus <= len(zeros) else []
    kept = tuple(entry for place, entry in enumerate(vector.entries) if place not in out)
    words = f"without {_named('entry', out)}, which {'are' if len(out) > 1 else 'is'} zero"
    return (replace(vector, entries=kept), words) if out else None


def _choices(
    entries: Sequence[Sequence[Tree]], surplus: tuple[int, int]
) -> Iterator[tuple[tuple[int, ...], tuple[int, ...]]]:
    """Which rows and columns may be left out, the last first."""
    rows = [place for place, row in enumerate(entries) if all(map(_is_zero, row))]
    columns = [place for place in range(len(entries[0])) if all(_is_zero(row[place]) for row in entries)]
    for out_rows in combinations(reversed(rows), surplus[0]):
        for out_columns in combinations(reversed(columns), surplus[1]):
            yield tuple(sorted(out_rows)), tuple(sorted(out_columns))


def _without(tree: Array, rows: Sequence[int], columns: Sequence[int]) -> Array:
    kept = [row for place, row in enumerate(tree.entries) if place not in rows and isinstance(row, Array)]
    return replace(
        tree,
        entries=tuple(
            replace(row, entries=tuple(one for place, one in enumerate(row.entries) if place not in columns))
            for row in kept
        ),
    )


def _is_zero(tree: Tree) -> bool:
    return isinstance(tree, Number) and not tree.value


def _left_out(rows: Sequence[int], columns: Sequence[int]) -> str:
    named = ((rows, "row"), (columns, "column"))
    parts = [_named(kind, out) for out, kind in named if out]
    return f"without {' and '.join(parts)}, which {'are' if len(rows) + len(columns) > 1 else 'is'} zero"


def _named(kind: str, places: Sequence[int]) -> str:
    plural = f"{kind.removesuffix('y')}ies" if kind.endswith("y") else f"{kind}s"
    return f"{plural if len(places) > 1 else kind} {', '.join(map(str, places))}"
