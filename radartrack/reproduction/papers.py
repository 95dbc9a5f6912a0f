"""The papers whose experiments can be repeated: what runs them, and what draws them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

from radartrack.reproduction import (
    gao,
    gao_figures,
    gorshkov,
    gorshkov_figures,
    prosov,
    prosov_figures,
)
from radartrack.reproduction.pictures import Picture
from radartrack.reproduction.results import Reproduction, Step

FAST = 10
"""By how much a fast reproduction has fewer trials."""


@dataclass(frozen=True)
class Paper:
    """One paper.

    Attributes:
        run: repeats its experiments with a share of the trials, 1 over the number given.
        pictures: draws them.

    """

    run: Callable[[int, Step], Reproduction]
    pictures: Callable[[Reproduction], Iterator[Picture]]

    def reproduce(self, step: Step, *, fast: bool = False) -> Reproduction:
        """Repeat the experiments; fast ones have a tenth of the trials."""
        return self.run(FAST if fast else 1, step)


def _prosov(divisor: int, step: Step) -> Reproduction:
    return prosov.reproduce(prosov.TRIALS // divisor, prosov.MAPPED_TRIALS // divisor, step=step)


def _gao(divisor: int, step: Step) -> Reproduction:
    return gao.reproduce(gao.RUNS // divisor, gao.TRACKS // divisor, step=step)


def _gorshkov(divisor: int, step: Step) -> Reproduction:
    return gorshkov.reproduce(gorshkov.TRIALS // divisor, step=step)


PAPERS: Mapping[str, Paper] = {
    "prosov": Paper(_prosov, prosov_figures.pictures),
    "gao": Paper(_gao, gao_figures.pictures),
    "gorshkov": Paper(_gorshkov, gorshkov_figures.pictures),
}
