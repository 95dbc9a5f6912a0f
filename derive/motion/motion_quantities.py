"""The catalogue's rows of a motion: its transition and its process noise, each by its definition."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.source import Source
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import Unit

TRANSITION = "F = e^(AT)"
CONTINUOUS = "Q = q int_0^T e^(As) G G' e^(As)' ds"
PIECEWISE = "Q = sigma_w^2 g g', g = int_0^T e^(As) G ds"
WIENER_SEQUENCE = "Q = sigma_w^2 F G (F G)'"


@dataclass(frozen=True)
class State:
    """What moves.

    Attributes:
        motion: the name of the motion.
        text: its state, in words.
        units: of the state.
        source: where it stands in print.
    """

    motion: str
    text: str
    units: tuple[Unit, ...]
    source: Source

    def transition(
        self, symbols: tuple[Variable, ...], derive: Callable[[], Tensor[Expr]], form: Callable[[], StableForm]
    ) -> Quantity:
        """The row of F."""
        inverse = tuple(unit ** Fraction(-1) for unit in self.units)
        meaning = f"transition of {self.text} from scan to scan"
        return self._row("transition", meaning, TRANSITION, (self.units, inverse), symbols, derive, form)

    def noise(
        self,
        kind: str,
        driven: str,
        word: str,
        symbols: tuple[Variable, ...],
        derive: Callable[[], Tensor[Expr]],
        form: Callable[[], StableForm],
    ) -> Quantity:
        """The row of a Q, with what drives the motion."""
        meaning = f"covariance of the process noise of {self.text} from scan to scan, with {driven}"
        return self._row(f"process_noise{kind}", meaning, word, (self.units, self.units), symbols, derive, form)

    def _row(
        self,
        name: str,
        meaning: str,
        word: str,
        axes: tuple[tuple[Unit, ...], ...],
        symbols: tuple[Variable, ...],
        derivation: Callable[[], Tensor[Expr]],
        form: Callable[[], StableForm],
    ) -> Quantity:
        return Quantity(
            name=f"motion.{self.motion}.{name}",
            meaning=meaning,
            axes=axes,
            symbols=symbols,
            conditioning=Conditioning.NONE,
            source=self.source,
            word=word,
            derivation=derivation,
            rewriting=form,
        )


def as_derived(derivation: Callable[[], Tensor[Expr]]) -> Callable[[], StableForm]:
    """Where nothing cancels in the derivation."""
    return lambda: StableForm({}, derivation())


def symmetric(upper: Callable[[int, int], Expr], size: int) -> Tensor[Expr]:
    """A symmetric matrix by its entries on and above the diagonal."""
    return Tensor.build((size, size), lambda m, n: upper(min(m, n), max(m, n)))
