"""A derived quantity: its name, formula, symbols, units, source, and what it is conditioned on."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum
from functools import cached_property, reduce
from operator import mul

from radartrack.derive.language.model import Model
from radartrack.derive.language.source import Source
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import ONE, Unit


class Conditioning(Enum):
    """What an expectation holds fixed; formulas that differ only in this are the commonest mix-up in the field."""

    NONE = "no expectation is taken"
    TRUTH = "truth-conditioned: the measured symbols stand for the true values"
    MEASUREMENT = "measurement-conditioned: the measured symbols stand for the measurement"
    PREDICTION = "averaged over a prediction: the measured symbols stand for the predicted mean"


@dataclass(frozen=True)
class Quantity:
    """One entry of the catalogue.

    Attributes:
        name: dotted name, `polar.bias.second_order`.
        meaning: one line in the field's words.
        axes: one tuple of units for each axis of the tensor; an entry's unit is the product over its axes.
        symbols: the symbols it is a function of.
        conditioning: what its expectations hold fixed.
        source: where it stands in print.
        derivation: derives the formula; called at most once.
        word: the definition as a word in the operator, or in plain terms.
        rewriting: how it is written for floating point where the general rewriting does not serve.
        scale: what the error of each entry is measured against, where its kind does not say that.
        measured_against: the scale in words.
        common_unit: a factor of the unit of every entry; the unit of a scalar.
        scaled_by: a length over which code takes all others.
        is_difference: whether it vanishes where it is of use, as a residual does; its errors are then
            measured against the sizes of its terms.
        model: the measurement model that it belongs to, if any.
        unit_of_entry: the unit of each entry, where these are no products over axes.
    """

    name: str
    meaning: str
    axes: tuple[tuple[Unit, ...], ...]
    symbols: tuple[Variable, ...]
    conditioning: Conditioning
    source: Source
    word: str
    derivation: Callable[[], Tensor[Expr]] = field(repr=False, compare=False)
    rewriting: Callable[[], StableForm] | None = field(default=None, repr=False, compare=False)
    scale: Callable[[], Tensor[Expr]] | None = field(default=None, repr=False, compare=False)
    measured_against: str = ""
    common_unit: Unit = ONE
    scaled_by: Variable | None = None
    is_difference: bool = False
    model: Model | None = field(default=None, repr=False)
    unit_of_entry: Callable[[Index], Unit] | None = field(default=None, repr=False, compare=False)

    @property
    def shape(self) -> Index:
        """Tensor shape; () for a scalar."""
        return tuple(len(axis) for axis in self.axes)

    @property
    def is_covariance(self) -> bool:
        """Whether it is a covariance matrix, whose entries are measured against its diagonal."""
        return not {"covariance", "process_noise"}.isdisjoint(self.name.split("."))

    @property
    def module(self) -> str:
        """The module of the generated function."""
        return self.name.partition(".")[0]

    @property
    def function(self) -> str:
        """The name of the generated function."""
        return self.name.partition(".")[2].replace(".", "_")

    @cached_property
    def expression(self) -> Tensor[Expr]:
        """The formula, exact, as derived."""
        return self.derivation()

    @property
    def unit_text(self) -> str:
        """The unit of all entries, or the units along each axis where they differ."""
        if all(len(set(axis)) == 1 for axis in self.axes):
            return str(self.unit((0,) * len(self.axes)))
        return " × ".join("[" + ", ".join(map(str, axis)) + "]" for axis in self.axes)

    def unit(self, index: Index) -> Unit:
        """The unit of one entry."""
        if self.unit_of_entry is not None:
            return self.unit_of_entry(index)
        return reduce(mul, (axis[i] for axis, i in zip(self.axes, index, strict=True)), self.common_unit)


def scalar(
    name: str,
    meaning: str,
    unit: Unit,
    symbols: tuple[Variable, ...],
    source: Source,
    word: str,
    derive: Callable[[], Expr],
    rewriting: Callable[[], StableForm] | None = None,
    *,
    conditioning: Conditioning = Conditioning.NONE,
    is_difference: bool = False,
) -> Quantity:
    """A quantity that is one number, written as it is derived unless there is a rewriting."""

    def derivation() -> Tensor[Expr]:
        return Tensor((), (derive(),))

    return Quantity(
        name,
        meaning,
        (),
        symbols,
        conditioning,
        source,
        word,
        derivation,
        rewriting or (lambda: StableForm({}, derivation())),
        common_unit=unit,
        is_difference=is_difference,
    )
