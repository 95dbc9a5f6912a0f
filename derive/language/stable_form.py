"""The form in which a formula is computed: entries over named intermediates, proved equal to what was derived."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, Symbol


class NotProved(AssertionError):
    """A rewritten form could not be proved equal to its definition."""


@dataclass(frozen=True)
class StableForm:
    """Entries over named intermediates.

    Attributes:
        definitions: intermediate symbol → its definition in the quantity's own symbols, in order of use.
        entries: the rewritten entries.
        arbitrary: intermediates whose value makes no difference, such as a weight between equal expressions.
    """

    definitions: Mapping[Symbol, Expr]
    entries: Tensor[Expr]
    arbitrary: frozenset[Symbol] = frozenset()

    def expanded(self) -> Tensor[Expr]:
        """The entries with every intermediate replaced by its definition."""
        return self._expanded(self.definitions)

    def proposition(self) -> Tensor[Expr]:
        """The same with what is arbitrary left as symbols: what is proved of these holds for their definitions."""
        return self._expanded({s: value for s, value in self.definitions.items() if s not in self.arbitrary})

    def _expanded(self, definitions: Mapping[Symbol, Expr]) -> Tensor[Expr]:
        known: dict[Symbol, Expr] = {}
        for symbol, definition in definitions.items():
            known[symbol] = definition.xreplace(known)
        return self.entries.map(lambda entry: entry.xreplace(known))

    def renamed(self, names: Mapping[Symbol, Symbol]) -> StableForm:
        """The same with other names for intermediates."""
        definitions = {names.get(symbol, symbol): value.xreplace(names) for symbol, value in self.definitions.items()}
        arbitrary = frozenset(names.get(symbol, symbol) for symbol in self.arbitrary)
        return StableForm(definitions, self.entries.map(lambda entry: entry.xreplace(names)), arbitrary)

    def only(self, entries: Tensor[Expr]) -> StableForm:
        """These entries with the intermediates that they need and no others."""
        needed = {symbol for entry in entries for symbol in entry.free_symbols}
        kept: dict[Symbol, Expr] = {}
        for symbol, definition in reversed(list(self.definitions.items())):
            if symbol in needed:
                needed |= definition.free_symbols
                kept[symbol] = definition
        return StableForm(dict(reversed(kept.items())), entries, self.arbitrary)
