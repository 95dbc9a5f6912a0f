"""The world of a paper: quantities, letters, definitions and conditions of its own, beside those of the catalogue."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from difflib import get_close_matches

from radartrack.derive import catalogue
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.derive.tracks.gaussian_coverage import COVERAGE


@dataclass(frozen=True)
class World:
    """What a claims file says for all of its claims.

    Attributes:
        quantities: the paper's own, by name; they hide none of the catalogue's. Nothing is derived before it is asked.
        unreadable: what is wrong with a model or definition that cannot be read, by the first part of its names.
        letters: the paper's symbols, by name.
        let: what other names of the paper stand for, as formulas.
        given: conditions, as formulas; each applies where a question has its symbol.
    """

    quantities: Mapping[str, Quantity] = field(default_factory=dict)
    unreadable: Mapping[str, str] = field(default_factory=dict)
    letters: Mapping[str, Variable] = field(default_factory=dict)
    let: Mapping[str, str] = field(default_factory=dict)
    given: Mapping[str, str] = field(default_factory=dict)

    def find(self, name: str) -> Quantity:
        """The paper's quantity of this name, or that of the catalogue.

        Raises:
            UnknownQuantity: with the closest names there are.
        """
        if name in self.quantities:
            return self.quantities[name]
        if why := self.unreadable.get(name.partition(".")[0]):
            raise catalogue.UnknownQuantity(why)
        if name == COVERAGE.name:  # is only compared with
            return COVERAGE
        try:
            return catalogue.find(name)
        except catalogue.UnknownQuantity:
            if close := get_close_matches(name, self.quantities, n=3, cutoff=0.5):
                raise catalogue.UnknownQuantity(
                    f"no quantity is called {name!r}; did you mean {' or '.join(close)}?"
                ) from None
            raise

    def having(self, quantities: Iterable[Quantity]) -> World:
        """The same world with more quantities, such as those of a model."""
        return replace(self, quantities={**self.quantities, **{one.name: one for one in quantities}})


CATALOGUE = World()
