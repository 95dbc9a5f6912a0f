"""Definitions as they are read before it is known what the letters in them mean."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from radartrack.derive.checking.question.definitions.known_constants import with_symbols
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.shape import Shape
from radartrack.derive.formula.tree import Tree
from radartrack.derive.formula.tree import names as names_of
from radartrack.derive.formula.written_out import written_out
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.reading.any_letters import read_loosely
from radartrack.derive.reading.tex.latex_pieces import FUNCTIONS
from radartrack.derive.reading.unit_text import measured

WORD = re.compile(r"(?<![\w.])[A-Za-z_]\w*")

_APPLIED = re.compile(
    r"(?<![\w.\\])(?:\\[a-z]+\{)?\\?(?P<name>[A-Za-z_]\w*)\}?(?P<applied>\s*\(\s*\\?(?P<argument>[A-Za-z_]\w*)\s*\))"
)
_FUNCTION = re.compile(
    r"(?<![\w.\\])\\?(?!left|right|[bB]ig)(?P<name>[A-Za-z]\w*)\}?"
    r"(?P<applied>\s*(?:\\left\s*)?\(\s*\{?\s*\\?(?P<argument>[A-Za-z]\w*)\s*\}?\s*(?:\\right\s*)?\))"
)


def without_arguments(text: str, let: Mapping[str, str]) -> str:
    """A formula where F(tau) is F, if F is defined by tau; each place stays as it was."""

    def replaced(found: re.Match[str]) -> str:
        if found["argument"] not in WORD.findall(let.get(found["name"], "")):
            return found.group()
        return found.group().removesuffix(found["applied"]) + " " * len(found["applied"])

    return _APPLIED.sub(replaced, text) if let else text


def without_function_arguments(text: str) -> str:
    r"""LaTeX where N(\phi) is N, if N stands nowhere else; each place stays as it was."""
    applied = [found for found in _FUNCTION.finditer(text) if found["name"] not in FUNCTIONS]
    for name in {found["name"] for found in applied}:
        own = [found for found in applied if found["name"] == name]
        is_alone = len(re.findall(rf"(?<![A-Za-z]){name}(?![A-Za-z])", text)) == len(own)
        if is_alone and len({found["argument"] for found in own}) == 1:
            for found in own:
                start, end = found.span("applied")
                text = text[:start] + " " * (end - start) + text[end:]
    return text


class LooseDefinitions:
    """Definitions read before it is known what the names in them mean.

    Args:
        let: the definitions, in any order.
        own: names that are known.

    Raises:
        FormulaError: where one is defined by itself, or an array in one has no meaning.
    """

    def __init__(self, let: Mapping[str, str], own: Sequence[str]) -> None:
        self._let, self._own = let, own
        self._trees: dict[str, Tree | None] = {}  # None for one that is worked out, or cannot be read
        self.arrays: dict[str, Tensor[Tree]] = {}
        for name in let:
            self._read(name, ())

    @property
    def shapes(self) -> dict[str, Shape]:
        """Of those that stand for arrays."""
        return {name: entries.shape for name, entries in self.arrays.items()}

    @property
    def has_unread(self) -> bool:
        """Whether one is worked out, or cannot be read, so that nobody knows whether it is an array."""
        return None in self._trees.values()

    def needed_by(self, tree: Tree) -> dict[str, Tree] | None:
        """Those of numbers on which a formula rests, each after those that it rests on; None where one has no tree."""
        waiting = set(names_of(tree))
        for name in reversed(self._trees):
            if name in waiting and (own := self._trees[name]) is not None:
                waiting |= names_of(own)
        if any(self._trees[name] is None for name in self._trees.keys() & waiting):
            return None
        found = {name: one for name, one in self._trees.items() if name in waiting and name not in self.arrays}
        return {name: one for name, one in found.items() if one is not None}

    def _read(self, name: str, path: tuple[str, ...]) -> None:
        if name in path:
            raise FormulaError(f"let {name}: it is defined by itself")
        if name in self._trees:
            return
        if name in self._own:
            self._trees[name] = None  # the paper's meaning hides ours, which may stand in it
            return
        for other in sorted(set(WORD.findall(self._let[name])) & self._let.keys()):
            self._read(other, (*path, name))
        try:
            text = number.formula if (number := measured(self._let[name])) else self._let[name]
            tree, _ = with_symbols(read_loosely(text, [*self._own, *self._let], shapes=self.shapes), self._own)
            entries = written_out(tree, self.arrays)
        except (FormulaError, ValueError):
            self._trees[name] = None
            return
        self._trees[name] = None if entries is None else tree if entries.shape else entries.entries[0]
        if entries is not None and entries.shape:
            self.arrays[name] = entries
