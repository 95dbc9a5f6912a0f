"""Classes of matrices of Eigen and OpenCV, and the sizes of what is filled through a stream."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Sequence

_NAMED = re.compile(
    r"(?:\w+::)*(?P<kind>Matrix|Vector|RowVector|Array|Matx|Vec|Mat_)(?:"
    r"(?:X|(?P<rows>\d)(?:x?(?P<columns>\d))?)?[dfi]?"  # Matrix2d, Matx44f, VectorXd
    r"|\s*<\s*\w+\s*(?:,\s*(?P<first>\w+(?:::\w+)*|-1)\s*)?(?:,\s*(?P<second>\w+(?:::\w+)*|-1)\s*)?(?:,[^<>]*)?>)"
)
_LEAST_SQUARE = 9  # entries: of 4, those of a vector are as likely


def is_matrix_class(kind: str) -> bool:
    """Whether a type is a class of matrices or vectors."""
    return _NAMED.fullmatch(kind) is not None


def class_sizes(kind: str) -> tuple[int, ...]:
    """The sizes that a type says: Matrix2d, Vector3f, Matrix<double, 3, 4>; none where it says none."""
    found = _NAMED.fullmatch(kind)
    if found is None:
        return ()
    rows, columns = found["rows"] or found["first"] or "", found["columns"] or found["second"] or ""
    if not rows.isdigit() or (columns and not columns.isdigit()):
        return ()
    if found["kind"] in {"Vector", "RowVector", "Vec"} or columns == "1":
        return (int(rows),)
    return int(rows), int(columns or rows)


def laid_out(lines: Sequence[int]) -> tuple[int, ...]:
    """The sizes of an array of which only the entries are seen, by the lines that these stand in.

    As many on each line are rows; 9, 16, ... on one line are a square matrix, as no vector is so long.
    """
    counts = set(Counter(lines).values())
    width = counts.pop() if len(counts) == 1 else 1
    if width == len(lines) >= _LEAST_SQUARE and (root := math.isqrt(width)) ** 2 == width:
        width = root
    return (len(lines),) if width in {1, len(lines)} else (len(lines) // width, width)
