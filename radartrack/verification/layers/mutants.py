"""Layer: faults put into a derived formula on purpose, which the other layers must notice."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

from radartrack.derive.language.quantity import Quantity
from radartrack.verification.layers.dimensions import Dimensions
from radartrack.verification.layers.formula_mutants import Mutant, mutants
from radartrack.verification.layers.identity import Identity
from radartrack.verification.layers.monte_carlo import MonteCarlo
from radartrack.verification.layers.quadrature import Quadrature
from radartrack.verification.layers.ulp_search import Accuracy
from radartrack.verification.outcome import Function, Layer, Outcome, Verdict, examined
from radartrack.verification.program_compilation import compiled
from radartrack.verification.simulation.experiments import simulated

NAME = "mutants"
DRAWS = 1 << 16
SIMULATED = 12  # mutants of a function that are simulated too
POINTS = 200


@dataclass(frozen=True)
class Caught:
    """What noticed one mutant.

    Attributes:
        mutant: which.
        derivation: layers that notice it as a slip in the derivation, which the code repeats.
        code: layers that notice it as a slip in the code alone.
    """

    mutant: Mutant
    derivation: frozenset[str]
    code: frozenset[str]


@dataclass(frozen=True)
class Mutants:
    """How many mutants of a quantity the layers notice.

    Attributes:
        count: of mutants that are tried.
        seed: of their choice.
    """

    count: int = 20
    seed: int = 0
    name: str = NAME

    def __call__(self, quantity: Quantity, function: Function) -> Outcome:  # noqa: ARG002 - one interface for all
        """The share that nothing but Monte Carlo could notice, or nothing at all; none may be left."""
        found = caught(quantity, self.count, self.seed)
        if not found:
            return Outcome.not_applicable(NAME, "the formula has no part that could be mistaken")
        survivors = [each for each in found if not each.code or not each.derivation]
        shares = _shares(found), _shares(found, in_code=True)
        detail = f"{len(found)} mutants; slips of the derivation: {shares[0]}; slips of the code: {shares[1]}"
        if simulated(quantity):
            noticed = _noticed_by_simulation(quantity, found[:SIMULATED], self.seed)
            detail += f"; Monte Carlo alone {sum(noticed)} of {len(noticed)}"
        if survivors:
            detail += "; survivors: " + ", ".join(sorted({each.mutant.kind for each in survivors}))
        return Outcome.measured(NAME, len(survivors) / len(found), 0.0, detail)


def caught(quantity: Quantity, count: int, seed: int) -> list[Caught]:
    """Every mutant with the layers that notice it, Monte Carlo apart."""
    layers: list[Layer] = [Dimensions(seed), Identity(seed), Quadrature(1, seed)]
    code: list[Layer] = [Accuracy(POINTS, seed), Quadrature(1, seed)]
    return [
        Caught(
            mutant,
            frozenset(layer.name for layer in layers if fails(layer, _mistaken(quantity, mutant), mutant)),
            frozenset(layer.name for layer in code if fails(layer, quantity, mutant)),
        )
        for mutant in mutants(quantity, count, seed)
    ]


def fails(layer: Layer, quantity: Quantity, mutant: Mutant) -> bool:
    """Whether a layer notices code that computes the mutant."""
    return examined(layer, quantity, compiled(mutant.entries, quantity.symbols)).verdict is Verdict.FAILED


def _mistaken(quantity: Quantity, mutant: Mutant) -> Quantity:
    """The quantity as if the mutant had been derived."""
    return replace(quantity, derivation=lambda: mutant.entries, rewriting=None)


def _shares(found: Sequence[Caught], *, in_code: bool = False) -> str:
    counts = Counter(layer for each in found for layer in (each.code if in_code else each.derivation))
    return ", ".join(f"{layer} {number}/{len(found)}" for layer, number in sorted(counts.items())) or "none noticed"


def _noticed_by_simulation(quantity: Quantity, found: list[Caught], seed: int) -> list[bool]:
    return [fails(MonteCarlo(DRAWS, seed), quantity, each.mutant) for each in found]
