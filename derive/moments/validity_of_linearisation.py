"""Where an approximation is good enough: the leading term that it neglects, against the linear standard deviation.

The linear formulas keep the first term of h(θ + w) = h + Jw + ½ wᵀGw + …, the second-order ones the first two. What
comes next, brought back to the measured quantities by J⁻¹ and averaged over the error w ~ N(0, K), is compared with
the deviation of the measured quantity itself, component by component. The ratio does not depend on how the
coordinate axes lie: along range it is √3/2 · r σ_β²/σ_r for the linear polar conversion.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache, reduce
from itertools import combinations_with_replacement
from math import factorial, pi, prod
from operator import mul

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.common_denominator import Denominator, collect, denominators, without_squares
from radartrack.derive.algebra.differential_ring import DifferentialRing
from radartrack.derive.language.model import Model
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.moments.mean_square import MeanSquare, Powers
from radartrack.derive.stable.rewriting import general_form
from radartrack.derive.symbolic import Expr, PolyElement, Symbol

NEGLECTED = {"linear": 2, "second_order": 3}
Column = list[PolyElement]


def validity(model: Model, formulas: str = "linear") -> Tensor[Expr]:
    """Root mean square of the leading neglected term over the linear standard deviation, one a measured quantity.

    Args:
        model: with as many coordinates as measured quantities.
        formulas: "linear" or "second_order".

    Raises:
        ValueError: for other formulas, or a model whose errors cannot be brought back to its measured quantities.
    """
    return validity_form(model, formulas).expanded()


@lru_cache(maxsize=16)
def validity_form(model: Model, formulas: str) -> StableForm:
    """The same over named intermediates, as it is written; it raises the same."""
    if formulas not in NEGLECTED:
        raise ValueError(f"formulas must be one of {', '.join(NEGLECTED)}; given {formulas!r}")
    if not is_square(model):
        raise ValueError(
            f"{model.name} has {len(model.outputs)} coordinates for {len(model.measured)} measured quantities; "
            "a term can only be brought back where the numbers agree"
        )
    rows = _Comparison(model).rows(NEGLECTED[formulas])
    named = {(i, powers): _name(model, i, powers) for i, row in enumerate(rows) for powers in row.terms}
    terms = Tensor((len(named),), tuple(rows[i].terms[powers] for i, powers in named))
    form = general_form(terms)
    mean_square = MeanSquare(model, list(named.values()))
    ratios = [
        sp.sqrt(mean_square.of({powers: named[i, powers] for powers in row.terms})) / (_size(row.divisor) * deviation)
        for i, (row, deviation) in enumerate(zip(rows, model.deviations, strict=True))
    ]
    parts = dict(zip(named.values(), form.entries, strict=True))
    short = {name: part for name, part in parts.items() if not isinstance(part, sp.Add)}
    long = {name: part for name, part in parts.items() if name not in short}
    definitions = {**form.definitions, **long, **mean_square.definitions}
    entries = tuple(ratio.xreplace(short) for ratio in ratios)
    return StableForm(definitions, form.entries).only(Tensor((len(rows),), entries))


def _size(divisor: Expr) -> Expr:
    """The divisor without its sign, which lengths and cosines of elevations do not have."""
    return sp.Mul(*(part if _is_positive(part) else sp.Abs(part) for part in sp.Mul.make_args(divisor)))


def _is_positive(factor: Expr) -> bool:
    base, _ = factor.as_base_exp()
    if isinstance(base, sp.cos) and isinstance(angle := base.args[0], Variable):
        return -pi / 2 <= angle.low and angle.high <= pi / 2
    return bool(base.is_nonnegative)


def _name(model: Model, i: int, powers: Powers) -> Symbol:
    errors = "_".join(v.name for v, power in zip(model.measured, powers, strict=True) for _ in range(power))
    return sp.Symbol(f"{model.measured[i].name}_by_{errors}", real=True)


def is_square(model: Model) -> bool:
    """Whether there are as many coordinates as measured quantities."""
    return len(model.outputs) == len(model.measured)


@dataclass(frozen=True)
class _Row:
    """A polynomial in the errors over a divisor: the powers of the errors → coefficient."""

    terms: dict[Powers, Expr]
    divisor: Expr


class _Comparison:
    """The neglected terms of one model in the smallest differential ring that holds its map."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.ring = DifferentialRing(model.map, model.symbols)
        self.map: Column = [self.ring.read(h) for h in model.map]

    def rows(self, order: int) -> list[_Row]:
        """J⁻¹ (w·∂)ⁿ h / n!, for each measured quantity, by Cramer's rule."""
        columns = [[self.ring.differentiate(h, v) for h in self.map] for v in self.model.measured]
        taylor = self._taylor_terms(order)
        determinant = self._determinant(columns)
        return [
            self._without_common_factors(
                {powers: self._determinant([*columns[:i], term, *columns[i + 1 :]]) for powers, term in taylor.items()},
                determinant,
            )
            for i in range(len(columns))
        ]

    def _taylor_terms(self, order: int) -> dict[Powers, Column]:
        """The coefficient of each product of errors in (w·∂)ⁿ h / n!, one element an output."""
        found = {}
        for chosen in combinations_with_replacement(range(len(self.model.measured)), order):
            powers = tuple(chosen.count(k) for k in range(len(self.model.measured)))
            slopes = self.map
            for k in chosen:
                slopes = [self.ring.differentiate(slope, self.model.measured[k]) for slope in slopes]
            found[powers] = [slope * sp.QQ(1, prod(map(factorial, powers))) for slope in slopes]
        return found

    def _determinant(self, columns: list[Column]) -> PolyElement:
        if not columns:
            return self.ring.ring.one
        first, rest = columns[0], columns[1:]
        minors = (
            entry * self._determinant([[*column[:i], *column[i + 1 :]] for column in rest]) * (-1) ** i
            for i, entry in enumerate(first)
            if entry
        )
        return sum(minors, self.ring.ring.zero)

    def _without_common_factors(self, terms: dict[Powers, PolyElement], determinant: PolyElement) -> _Row:
        """Terms over the determinant, divided by the factors that it shares with all of them."""
        found = denominators(self.ring)
        parts = collect(determinant, self.ring, found)
        if len(parts) != 1:  # no product of roots and a polynomial
            plain = {n: self.ring.expression(term) for n, term in terms.items() if term}
            return _Row(plain, self.ring.expression(determinant))
        ((exponents, numerator),) = parts.items()
        root = reduce(mul, map(self._power, found, exponents), self.ring.ring.one)
        reduced = {n: without_squares(term * root, self.ring, sp.sin) for n, term in terms.items()}
        content, factors = numerator.factor_list()
        above = {n: term * (1 / content) for n, term in reduced.items() if term}
        divisor = self.ring.ring.one
        for factor in (factor for factor, power in factors for _ in range(power)):
            divided = {n: term.div(factor) for n, term in above.items()}
            if any(remainder for _, remainder in divided.values()):
                divisor = divisor * factor
            else:
                above = {n: quotient for n, (quotient, _) in divided.items()}
        return _Row({n: self.ring.expression(term) for n, term in above.items()}, self.ring.expression(divisor))

    def _power(self, denominator: Denominator, exponent: int) -> PolyElement:
        """What stands in the denominator to a power, with a generator for each inverse."""
        whole = max(0, -(-exponent // denominator.step))
        inverse = self.ring.ring(denominator.generator)
        return denominator.radicand**whole * inverse ** (whole * denominator.step - exponent)
