"""Where an approximation is good enough: the leading term that it neglects, against the linear standard deviation.

The linear formulas keep the first term of h(θ + w) = h + Jw + ½ wᵀGw + …, the second-order ones the first two. What
comes next, brought back to the measured quantities by J⁻¹ and averaged over the error w ~ N(0, K), is compared with
the deviation of the measured quantity itself, component by component. The ratio does not depend on how the
coordinate axes lie: along range it is √3/2 · r σ_β²/σ_r for the linear polar conversion.
"""

from __future__ import annotations

from functools import reduce
from math import factorial
from operator import add

from radartrack.derive import symbolic as sp
from radartrack.derive.collected import collect, denominators, without_squares
from radartrack.derive.differential_ring import DifferentialRing
from radartrack.derive.general_form import general_form
from radartrack.derive.model import Model
from radartrack.derive.stable import StableForm
from radartrack.derive.symbolic import Expr, PolyElement
from radartrack.derive.tensor import Tensor

NEGLECTED = {"linear": 2, "second_order": 3}
Row = list[PolyElement]


def validity(model: Model, formulas: str = "linear") -> Tensor[Expr]:
    """Root mean square of the leading neglected term over the linear standard deviation, one a measured quantity.

    Args:
        model: with as many coordinates as measured quantities.
        formulas: "linear" or "second_order".

    Raises:
        ValueError: for other formulas, or a model whose errors cannot be brought back to its measured quantities.
    """
    return validity_form(model, formulas).expanded()


def validity_form(model: Model, formulas: str) -> StableForm:
    """The same over named intermediates, as it is written; it raises the same."""
    if formulas not in NEGLECTED:
        raise ValueError(f"formulas must be one of {', '.join(NEGLECTED)}; given {formulas!r}")
    if not is_square(model):
        raise ValueError(
            f"{model.name} has {len(model.outputs)} coordinates for {len(model.measured)} measured quantities; "
            "a term can only be brought back where the numbers agree"
        )
    fractions = _Comparison(model).fractions(NEGLECTED[formulas])
    squares = Tensor((len(fractions),), tuple(above for above, _ in fractions))
    form = general_form(squares)
    below = (divisor.xreplace({d: name for name, d in form.definitions.items()}) for _, divisor in fractions)
    ratios = (_root(square) / divisor for square, divisor in zip(form.entries, below, strict=True))
    return form.only(Tensor(squares.shape, tuple(ratios)))


def _root(square: Expr) -> Expr:
    """The root of a mean square, which rounding may bring just below zero where terms of both signs meet."""
    return sp.sqrt(square if square.is_nonnegative else sp.Abs(square))


def is_square(model: Model) -> bool:
    """Whether there are as many coordinates as measured quantities."""
    return len(model.outputs) == len(model.measured)


class _Comparison:
    """The neglected terms of one model in the smallest differential ring that holds its map."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.errors = [sp.Symbol(f"error_of_{variable.name}", real=True) for variable in model.measured]
        self.ring = DifferentialRing(model.map, [*model.symbols, *self.errors])
        self.map: Row = [self.ring.read(h) for h in model.map]

    def fractions(self, order: int) -> list[tuple[Expr, Expr]]:
        """For each measured quantity, a and b such that its ratio is √a / b."""
        columns = [[self.ring.differentiate(h, v) for h in self.map] for v in self.model.measured]
        term = self._taylor_term(order)
        determinant = self._determinant(columns)
        fractions = []
        for i, deviation in enumerate(self.model.deviations):
            replaced = self._determinant([*columns[:i], term, *columns[i + 1 :]])  # Cramer's rule
            above, below = self._without_common_factors(self._mean(replaced**2), determinant)
            fractions.append((above, below * deviation))
        return fractions

    def _taylor_term(self, order: int) -> Row:
        """(w·∂)ⁿ h / n!, one element an output."""
        terms = self.map
        for _ in range(order):
            terms = [self._along_error(term) for term in terms]
        return [term * sp.QQ(1, factorial(order)) for term in terms]

    def _along_error(self, term: PolyElement) -> PolyElement:
        pairs = zip(self.errors, self.model.measured, strict=True)
        return reduce(add, (self.ring.differentiate(term, v) * self.ring.ring(error) for error, v in pairs))

    def _determinant(self, columns: list[Row]) -> PolyElement:
        if not columns:
            return self.ring.ring.one
        first, rest = columns[0], columns[1:]
        minors = (
            entry * self._determinant([[*column[:i], *column[i + 1 :]] for column in rest]) * (-1) ** i
            for i, entry in enumerate(first)
            if entry
        )
        return sum(minors, self.ring.ring.zero)

    def _mean(self, value: PolyElement) -> PolyElement:
        """The expectation over the errors of a polynomial in them: e^L at zero error."""
        total, term, order = value, value, 0
        while term:
            order += 1
            term = self._generator(term) * sp.QQ(1, order)
            total = total + term
        generators = [self.ring.ring(error) for error in self.errors]
        return total.compose([(generator, self.ring.ring.zero) for generator in generators])

    def _generator(self, value: PolyElement) -> PolyElement:
        total = self.ring.ring.zero
        for row, first in zip(self.model.covariance, self.errors, strict=True):
            slope = self.ring.differentiate(value, first)
            for weight, second in zip(row, self.errors, strict=True):
                total = total + self.ring.differentiate(slope, second) * self.ring.read(weight) * sp.QQ(1, 2)
        return total

    def _without_common_factors(self, square: PolyElement, determinant: PolyElement) -> tuple[Expr, Expr]:
        """A square and a divisor, divided by the factors of the determinant that the square holds twice."""
        found = denominators(self.ring)
        parts = collect(determinant, self.ring, found)
        if len(parts) != 1:
            raise ValueError(f"the Jacobian determinant of {self.model.name} is no product of roots and a polynomial")
        ((powers, numerator),) = parts.items()
        above, divisor = without_squares(square, self.ring, sp.sin), self.ring.ring.one
        for denominator, power in zip(found, powers, strict=True):
            inverse = self.ring.ring(denominator.generator)
            above = above * (denominator.radicand**power if power > 0 else inverse ** (-2 * power))
        for factor, power in numerator.factor_list()[1]:
            for _ in range(power):
                quotient, remainder = above.div(factor**2)
                above, divisor = (above, divisor * factor) if remainder else (quotient, divisor)
        return self.ring.expression(above), self.ring.expression(divisor)
