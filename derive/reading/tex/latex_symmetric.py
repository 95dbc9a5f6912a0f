r"""Symmetric matrices of which one half is printed, and a mark in place of the other: *, \cdot or sym."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TypeAlias

Rows: TypeAlias = list[list[str]]

_MATRIX = re.compile(
    r"(?P<begin>\\begin\s*\{(?P<name>[bpvBV]?(?:small)?matrix|array)\}(?:\s*\{[lcr|\s]*\})?)"
    r"(?P<body>(?:(?!\\(?:begin|end)\s*\{).)*)(?P<end>\\end\s*\{(?P=name)\})",
    re.DOTALL,
)
_PART = re.compile(
    r"(?P<open>(?<!\\)\{)|(?P<close>(?<!\\)\})|(?P<row>\\\\(?:\s{0,9}\[[^\]]{0,20}\])?)|(?P<column>(?<!\\)&)|\\.",
    re.DOTALL,
)
_MARK = re.compile(
    r"\{?(?:\*|\\(?:ast|star|cdot|bullet|circ)(?![A-Za-z])"
    r"|\\(?:text|mathrm|mbox|textrm|operatorname|rm)\s*\{\s*symm?(?:\.|etric|etry)?\s*\})\}?",
    re.IGNORECASE,
)


def with_mirrored(text: str) -> str:
    """The text with the printed half of a symmetric matrix in place of the marks; without a mark nothing is missing."""
    return _MATRIX.sub(lambda found: f"{found['begin']}{_mirrored(found['body'])}{found['end']}", text)


def _mirrored(body: str) -> str:
    rows = _rows(body)
    size = len(rows)
    if size < 2 or any(len(row) != size for row in rows):
        return body
    below = [(i, j) for i in range(size) for j in range(i)]
    for half in (below, [(j, i) for i, j in below]):
        if any(_MARK.fullmatch(rows[i][j].strip()) for i, j in half):
            missing = [(i, j) for i, j in half if not rows[i][j].strip() or _MARK.fullmatch(rows[i][j].strip())]
            for i, j in missing:
                rows[i][j] = rows[j][i]
            break
    else:
        return body
    return r"\\".join("&".join(row) for row in rows)


def _rows(body: str) -> Rows:
    """The cells of a matrix; rows and columns are parted outside of braces."""
    rows: Rows = [[""]]
    for kind, part in _parts(body):
        if kind == "row":
            rows.append([""])
        elif kind == "column":
            rows[-1].append("")
        else:
            rows[-1][-1] += part
    return rows[:-1] if len(rows) > 1 and not "".join(rows[-1]).strip() else rows


def _parts(body: str) -> Iterator[tuple[str, str]]:
    depth = start = 0
    for found in _PART.finditer(body):
        kind = found.lastgroup or ""
        depth += (kind == "open") - (kind == "close")
        if kind in {"row", "column"} and depth <= 0:
            yield "", body[start : found.start()]
            yield kind, found.group()
            start = found.end()
    yield "", body[start:]
