"""What a name stands for: a formula, or nested rows of formulas, and how large and of what dimension it is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from radartrack.derive.checking.question.formula_units import Dimension
from radartrack.derive.formula.magnitude import Measure
from radartrack.derive.formula.shape import Shape
from radartrack.derive.formula.to_expression import Expression
from radartrack.derive.formula.tree import Tree
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index, Tensor, indices
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr

SYMBOL = Measure(degree=1, digits=0, value=None, has_logarithm=False)


@dataclass(frozen=True)
class Meaning:
    """What a name stands for.

    Attributes:
        value: a formula, or nested rows of formulas.
        dimension: that of an entry; raises `WrongDimensions` where it has none.
        measure: how large it may become.
        size: how many parts it has.
        tree: of a definition, as it is read.
    """

    value: Expression
    dimension: Callable[[Index], Dimension]
    measure: Measure = SYMBOL
    size: int = 1
    tree: Tree | None = None

    @classmethod
    def of_symbol(cls, symbol: Variable) -> Meaning:
        """That of a symbol."""
        return cls(symbol, lambda _: Dimension.of(symbol.unit))

    @classmethod
    def of_quantity(cls, quantity: Quantity) -> Meaning:
        """That of a quantity, which is derived for it."""
        return cls(nested(quantity.expression), lambda index: Dimension.of(quantity.unit(index)))


def shape_of(value: Expression) -> Shape:
    """The shape of nested rows."""
    return (len(value), *shape_of(value[0])) if isinstance(value, tuple) else ()


def nested(entries: Tensor[Expr]) -> Expression:
    """A tensor as nested rows."""
    return tuple(map(nested, entries.parts())) if entries.shape else entries.entries[0]


def tensor(value: Expression) -> Tensor[Expr]:
    """Nested rows as a tensor."""
    shape = shape_of(value)
    return Tensor(shape, tuple(_entry(value, index) for index in indices(shape)))


def number_of_parts(value: Expression) -> int:
    """How many parts expressions have, those that they share counted each time."""
    known: dict[Expr, int] = {}
    for entry in tensor(value):
        waiting = [entry]
        while waiting:
            one = waiting[-1]
            missing = [part for part in one.args if part not in known]
            waiting.extend(missing)
            if not missing:
                known[one] = 1 + sum(known[part] for part in one.args)
                waiting.pop()
    return sum(known[entry] for entry in tensor(value))


def _entry(value: Expression, index: Index) -> Expr:
    for place in index:
        value = value[place] if isinstance(value, tuple) else value
    if isinstance(value, tuple):
        raise TypeError("the rows of an array differ in depth")
    return value
