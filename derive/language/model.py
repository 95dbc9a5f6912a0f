"""A measurement model: what is measured, with which errors, and how it maps to Cartesian coordinates."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from radartrack.derive import symbolic as sp
from radartrack.derive.language.identifiers import MODULES, require_names, require_text
from radartrack.derive.language.model_outputs import require_smooth, require_unit
from radartrack.derive.language.source import Source
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import ONE, Unit

Covariance = tuple[tuple[Expr, ...], ...]


@dataclass(frozen=True, eq=False)
class Model:
    """A conversion of measurements z = θ + w, w ~ N(0, K), to coordinates h(θ).

    Attributes:
        name: the first part of the names of its quantities.
        title: one line in the field's words.
        measured: θ, the measured quantities.
        deviations: the standard deviations of their errors, in the same order; none where there are no errors, as in a
            motion x' = f(x).
        correlations: pairs of measured quantities with correlated errors, and the symbol of the correlation.
        outputs: name and expression of each coordinate; a float in one means the shortest decimal that stands for it.
        units: the unit of each coordinate.
        source: where the map stands in print.
        parameters: symbols of the map that are known and carry no error, such as a baseline.
        scaled_by: a length over which code takes all others, for maps with high powers of lengths.
        variances_vanish: whether a coordinate does not depend on a measured quantity, to first order, at some angle
            between the axes. The last digits of the angle then decide its variance, and errors of covariances are
            measured against the sum of all variances.

    Raises:
        TypeError: when an output is no expression.
        ValueError: when the parts do not fit each other, an output has another unit than its expression, or an
            expression has no derivatives.
    """

    name: str
    title: str
    measured: tuple[Variable, ...]
    deviations: tuple[Variable, ...]
    outputs: Mapping[str, Expr]
    units: tuple[Unit, ...]
    source: Source
    correlations: Mapping[tuple[Variable, Variable], Variable] = field(default_factory=dict)
    parameters: tuple[Variable, ...] = ()
    scaled_by: Variable | None = None
    variances_vanish: bool = False

    def __post_init__(self) -> None:
        self._require_words()
        self._require_errors()
        errors = zip(self.measured, self.deviations, strict=False)
        object.__setattr__(self, "deviations", tuple(sigma.as_deviation_of(of) for of, sigma in errors))
        exact = {name: self._exact(name, value) for name, value in self.outputs.items()}
        object.__setattr__(self, "outputs", exact)
        for (output, expression), unit in zip(exact.items(), self.units, strict=True):
            unknown = expression.free_symbols - set(self.arguments)
            if unknown:
                allowed = ", ".join(symbol.name for symbol in self.arguments)
                raise ValueError(f"output {output} may use {allowed} only, given also {sorted(map(str, unknown))}")
            require_smooth(output, expression)
            require_unit(output, expression, unit)

    def _require_words(self) -> None:
        """Names and text that can be written, and as many of each part as there must be."""
        require_names("the model's name", [self.name])
        if self.name in MODULES:
            raise ValueError(f"the model's name must not be {' nor '.join(sorted(MODULES))}; given {self.name!r}")
        require_text(f"the title of {self.name}", self.title)
        require_text(f"the source of {self.name}", str(self.source))
        for output in self.outputs:
            require_text("the name of an output", output)
        for what, given in (("measured", self.measured), ("outputs", self.outputs)):
            if not given:
                raise ValueError(f"{what} must name at least one quantity; given {given!r}")
        if len(self.deviations) not in {0, len(self.measured)}:
            raise ValueError(
                f"deviations must be one for each measured quantity, or none: given {len(self.deviations)}, "
                f"measured {len(self.measured)}"
            )
        if len(self.units) != len(self.outputs):
            raise ValueError(f"units must be one for each output: given {len(self.units)} for {len(self.outputs)}")
        for pair in self.correlations:
            if len(set(pair)) != 2 or not set(pair) <= set(self.measured):
                raise ValueError(f"correlations must join two different measured quantities, given {pair}")
            if pair[::-1] in self.correlations:
                raise ValueError(f"correlations must name each pair once; given {pair} and {pair[::-1]}")
        declared = (*self.arguments, *self.noise_symbols)
        require_names("a symbol's name", [symbol.name for symbol in declared])
        require_names("a symbol's name", [symbol.name for symbol in self.symbols])

    def _require_errors(self) -> None:
        """Deviations and correlations of the right units and signs."""
        if self.correlations and not self.deviations:
            raise ValueError("correlations are those of errors, and without deviations there are no errors")
        for of, sigma in zip(self.measured, self.deviations, strict=False):
            if sigma.unit != of.unit or sigma.low < 0:
                raise ValueError(
                    f"the deviation of {of.name} must have its unit, {of.unit}, and no negative values; "
                    f"given {sigma.name} in {sigma.unit} from {sigma.low:g}"
                )
        for rho in self.correlations.values():
            if rho.unit != ONE or rho.low < -1 or rho.high > 1:
                raise ValueError(
                    f"a correlation must be a number from -1 to 1; given {rho.name} in {rho.unit} "
                    f"from {rho.low:g} to {rho.high:g}"
                )

    @staticmethod
    def _exact(output: str, value: object) -> Expr:
        try:
            return sp.exact(value)
        except (TypeError, ValueError) as error:
            raise type(error)(f"output {output}: {error}") from None

    @property
    def map(self) -> Tensor[Expr]:
        """h(θ), shape [out]."""
        return Tensor((len(self.outputs),), tuple(self.outputs.values()))

    @property
    def arguments(self) -> tuple[Variable, ...]:
        """What the map is a function of: the measured quantities, then the parameters."""
        return (*self.measured, *self.parameters)

    @property
    def symbols(self) -> tuple[Variable, ...]:
        """Every symbol that a quantity of the model can hold."""
        return (*self.arguments, *self.noise_symbols, *self.prediction_symbols)

    @property
    def noise_symbols(self) -> tuple[Variable, ...]:
        """Standard deviations, then correlations."""
        return (*self.deviations, *self.correlations.values())

    @property
    def covariance(self) -> Covariance:
        """K, the error covariance of the measurement."""
        return self._covariance({symbol: symbol for symbol in self.noise_symbols})

    @property
    def prediction_symbols(self) -> tuple[Variable, ...]:
        """The deviations and correlations of a prediction of θ."""
        return tuple(predicted(symbol) for symbol in self.noise_symbols)

    @property
    def prediction_covariance(self) -> Covariance:
        """Kₚ, the covariance of a prediction of θ."""
        return self._covariance({symbol: predicted(symbol) for symbol in self.noise_symbols})

    def _covariance(self, names: Mapping[Variable, Variable]) -> Covariance:
        deviation = {of: names[sigma] for of, sigma in zip(self.measured, self.deviations, strict=True)}
        both_ways = dict(self.correlations) | {(b, a): rho for (a, b), rho in self.correlations.items()}

        def entry(a: Variable, b: Variable) -> Expr:
            if a is b:
                return deviation[a] ** 2
            return names[both_ways[a, b]] * deviation[a] * deviation[b] if (a, b) in both_ways else a * 0

        return tuple(tuple(entry(a, b) for b in self.measured) for a in self.measured)


def predicted(symbol: Variable) -> Variable:
    """The symbol of a prediction's own deviation or correlation."""
    meaning = symbol.meaning.replace("the error", "the prediction").replace("the errors", "the predictions")
    kind: dict[str, Any] = {"is_correlation": symbol.is_correlation, "deviation_of": symbol.deviation_of}
    return Variable(f"predicted_{symbol.name}", meaning, symbol.unit, symbol.low, symbol.high, **kind)
