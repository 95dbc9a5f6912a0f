r"""Letters as LaTeX decorates them, and the names that they stand for.

A hat, a bar, a prime or an index of time tells two letters apart or says nothing: it is kept in the name where one
letter occurs in two ways, or where a symbol has such a name, and dropped elsewhere.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from types import MappingProxyType

from radartrack.derive.formula.error import Span
from radartrack.derive.formula.latex_names import candidates

# What stands over or beside a letter, and the word for it in a name; a dot is part of the letter: \dot{r} is rdot.
DECORATIONS = MappingProxyType(
    {
        "\\bar": "bar",
        "\\breve": "breve",
        "\\check": "check",
        "\\hat": "hat",
        "\\overline": "bar",
        "\\tilde": "tilde",
        "\\widehat": "hat",
        "\\widetilde": "tilde",
    }
)
SAYS_NOTHING = frozenset({"\\vec", "\\underline", "\\overrightarrow", "\\mathring"})  # arrows and lines of vectors
OF_TIME = frozenset({"k", "n", "i", "j", "t"})
_SIGNS = MappingProxyType({"|": "_", "-": "m", "+": "p", "/": "_", "(": "", ")": "", ",": "_"})

_SHIFTED = re.compile(r"[kntij][mp]\d+")  # as the index k-1 or k+1 is spelled in a name


@dataclass(frozen=True, slots=True)
class Letter:
    """A letter as printed.

    Attributes:
        base: its name, dots included.
        below: its subscript, words joined by `_`.
        decorations: words for what stands over or beside it.
        span: where.
        is_upright: whether it is set as a word.
        is_applied: whether a bracket follows.
        is_bold: whether it is set bold, as vectors and matrices are.
    """

    base: str
    below: str
    decorations: tuple[str, ...]
    span: Span
    is_upright: bool = False
    is_applied: bool = False
    is_bold: bool = False


class Names:
    """The names that the letters of a formula stand for.

    Args:
        letters: all of them.
        known: the symbols that are known.
        strangers: whether other names are let through.
    """

    def __init__(self, letters: Iterable[Letter], known: Collection[str], *, strangers: bool) -> None:
        self._known = known
        self._strangers = strangers
        self._ways: dict[tuple[str, str], set[tuple[str, ...]]] = {}
        self._indices: dict[str, set[str]] = {}
        for letter in letters:
            self._ways.setdefault((letter.base, letter.below), set()).add(letter.decorations)
            self._indices.setdefault(letter.base, set()).add(letter.below)

    def of(self, letter: Letter) -> str:
        """The symbol that is meant; where there is none, the name that was to be expected."""
        possible = list(self._possible(letter))
        return next((name for name in possible if name in self._known), possible[0])

    def _possible(self, letter: Letter) -> Iterator[str]:
        """Names from the likeliest on, for a symbol that is not known the first."""
        plain = _plain(letter.base, letter.below)
        if not letter.decorations:
            yield from plain
        else:
            full = list(_decorated(letter))
            is_alone = len(self._ways.get((letter.base, letter.below), ())) <= 1 and not self._is_of_another_time(
                letter
            )
            if is_alone and not any(name in self._known for name in full):
                yield from plain
            else:
                yield from full
                yield from plain
        if not self._strangers and letter.below in OF_TIME and len(self._indices.get(letter.base, ())) <= 1:
            yield letter.base

    def _is_of_another_time(self, letter: Letter) -> bool:
        """Whether a letter is one of k + 1 or k - 1, and the same letter of k stands beside it."""
        beside = {f"{letter.below}_{index}".strip("_") for index in OF_TIME}
        is_shifted = any(_SHIFTED.fullmatch(word) for word in letter.decorations)
        return is_shifted and not beside.isdisjoint(self._indices.get(letter.base, ()))


def full_name(letter: Letter) -> str:
    """The name of a letter with all that decorates it."""
    return next(iter(_decorated(letter) if letter.decorations else _plain(letter.base, letter.below)))


def possible_names(letter: Letter) -> Iterator[str]:
    """The names that a letter may have, with what decorates it and without."""
    yield from _plain(letter.base, letter.below)
    yield from _decorated(letter) if letter.decorations else ()


def spelled(sign: str) -> str:
    """A sign of a subscript as part of a name: k|k-1 is k_km1."""
    return _SIGNS.get(sign, sign)


def _plain(base: str, below: str) -> tuple[str, ...]:
    if base.startswith("Delta_") and not below:
        return base, f"d{base.removeprefix('Delta_')}"
    return candidates(base, below) if below else (base,)


def _decorated(letter: Letter) -> Iterator[str]:
    words = "_".join(letter.decorations)
    joined = "".join(letter.decorations)
    if letter.below:
        yield f"{letter.base}_{words}_{letter.below}"
        yield f"{letter.base}_{letter.below}_{words}"
        yield f"{letter.base}{joined}_{letter.below}"
    else:
        yield f"{letter.base}_{words}"
        yield f"{letter.base}{joined}"
