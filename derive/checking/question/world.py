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
class ImplicitDefinition:
    """Quantities that are defined together, by equations that they satisfy.

    Attributes:
        name: of the definition; `name[0]` is the first of the unknown.
        symbols: the letters that it depends on, by name.
        unknown: the names of what is defined.
        equations: formulas that vanish, or with a sign of equality.
        where: conditions, such as `0 < alpha`, that tell the solution that is meant from others.
    """

    name: str
    symbols: Mapping[str, Variable]
    unknown: tuple[str, ...]
    equations: tuple[str, ...]
    where: tuple[str, ...]


@dataclass(frozen=True)
class World:
    """What a claims file says for all of its claims.

    Attributes:
        quantities: the paper's own, by name; they hide none of the catalogue's. Nothing is derived before it is asked.
        definitions: those that it defines by formulas, read when they are asked for.
        unreadable: what is wrong with a model or definition that cannot be read, by the first part of its names.
        letters: the paper's symbols, by name.
        let: what other names of the paper stand for, as formulas.
        given: conditions, as formulas; each applies where a question has its symbol.
        spoiled: what is wrong with letters and definitions that cannot be read, by name.
        implicit: the paper's quantities that are defined by equations, by name.
    """

    quantities: Mapping[str, Quantity] = field(default_factory=dict)
    definitions: Mapping[str, Quantity] = field(default_factory=dict)
    unreadable: Mapping[str, str] = field(default_factory=dict)
    letters: Mapping[str, Variable] = field(default_factory=dict)
    let: Mapping[str, str] = field(default_factory=dict)
    given: Mapping[str, str] = field(default_factory=dict)
    spoiled: Mapping[str, str] = field(default_factory=dict)
    implicit: Mapping[str, ImplicitDefinition] = field(default_factory=dict)

    def find(self, name: str) -> Quantity:
        """The paper's quantity of this name, or that of the catalogue.

        Raises:
            UnknownQuantity: with the closest names there are.
        """
        if name in self.quantities:
            return self.quantities[name]
        if name in self.definitions:
            return self.definitions[name]
        if why := self.unreadable.get(name) or self.unreadable.get(name.partition(".")[0]):
            raise catalogue.UnknownQuantity(why)
        if name == COVERAGE.name:  # is only compared with
            return COVERAGE
        try:
            return catalogue.find(name)
        except catalogue.UnknownQuantity:
            if close := get_close_matches(
                name, {**self.quantities, **dict.fromkeys(self.definitions)}, n=3, cutoff=0.5
            ):
                raise catalogue.UnknownQuantity(
                    f"no quantity is called {name!r}; did you mean {' or '.join(close)}?"
                ) from None
            raise

    def declares(self, quantity: Quantity) -> bool:
        """Whether the quantity is the paper's own, in its own letters."""
        return quantity.name in self.quantities or quantity.name in self.definitions

    def having(self, quantities: Iterable[Quantity]) -> World:
        """The same world with more quantities, such as those of a model."""
        return replace(self, quantities={**self.quantities, **{one.name: one for one in quantities}})


CATALOGUE = World()
