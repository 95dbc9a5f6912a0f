"""One way to see a function as a quantity: how it is called, in which convention, and what is wrong then."""

from __future__ import annotations

from dataclasses import dataclass, field

from radartrack.derive.language.variable import Variable
from radartrack.testing.calling.called_function import Array, Binding
from radartrack.testing.function_conventions import ArgumentChange, Arrangement
from radartrack.testing.wanted import Wanted


class CannotDiagnose(ValueError):
    """A function cannot be called, or what it returns cannot be compared."""


@dataclass(frozen=True)
class Reading:
    """One way to see a function as the quantity.

    Attributes:
        wanted: what it is compared with, another quantity too.
        binding: how it is called.
        plain: the same without what the user stated and without the change.
        change: in which convention of arguments, beyond what was asked for.
        arrangement: in which order and units of results.
        wrong: how many different entries are wrong then.
        other: whether it is compared with another quantity.
        single: whether it returns single precision, or computes in it.
        form: what of the quantity it returns, where that is not the quantity itself.
        first: what came back when it was read.
    """

    wanted: Wanted
    binding: Binding
    change: ArgumentChange
    arrangement: Arrangement
    wrong: int
    plain: Binding
    other: bool = False
    single: bool = False
    form: str = ""
    first: Array | None = field(default=None, compare=False)

    @property
    def taken(self) -> list[Variable]:
        """The symbols that the function takes."""
        return [symbol for symbol in self.wanted.symbols if symbol.name in self.binding.symbols]

    @property
    def cost(self) -> float:
        """What is left to explain."""
        conventions = self.change.cost + self.arrangement.cost + self.other
        return self.wrong + conventions if self.wrong else 0.5 * conventions

    @property
    def words(self) -> str:
        """The convention; empty as asked for."""
        said = " and ".join(filter(None, (self.form, self.change.words, self.arrangement.words)))
        if not self.other:
            return said
        return f"this is {self.wanted.name}" + (f" with {said}" if said else "")
