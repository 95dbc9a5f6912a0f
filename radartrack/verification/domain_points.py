"""Points of a quantity's domain: spread over every scale, and close to where formulas are delicate."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from radartrack.derive.language.model import predicted
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.derive.units import METRE, ONE, RADIAN
from radartrack.verification.phase import calmed

Points = dict[str, npt.NDArray[np.float64]]
FAR = 1e4  # metres: what begins there is large beside its errors wherever it is
SMALLEST_SHARE = 1e-24  # of the largest value, for what may be zero


def sample(quantity: Quantity, count: int, seed: int = 0, *, correlated: bool = False) -> Points:
    """Random points of the domain, the same for the same seed on every machine.

    Args:
        quantity: whose symbols are drawn.
        count: number of points.
        seed: of the counter-based generator.
        correlated: whether correlations are drawn too; they are zero otherwise.

    Returns:
        Symbol name → array of shape (count,).
    """
    generator = np.random.Generator(np.random.Philox(seed))
    points: Points = {}
    for symbol in quantity.symbols:
        if symbol.at_most is None:
            drawn = _draw(symbol, count, generator, correlated=correlated)
        else:
            drawn = _up_to(points[symbol.at_most.name], symbol, generator)
        points[symbol.name] = np.floor(drawn) if symbol.whole else drawn
    return points


def _draw(symbol: Variable, count: int, generator: np.random.Generator, *, correlated: bool) -> npt.NDArray[np.float64]:
    uniform = generator.random(count)
    if symbol.is_correlation:
        spread = symbol.low + (symbol.high - symbol.low) * uniform
        return spread if correlated else np.zeros(count)
    if symbol.low == 0:
        return np.where(generator.random(count) < 0.125, 0.0, symbol.high * np.power(SMALLEST_SHARE, uniform))
    if symbol.logarithmic:
        drawn = np.exp(np.log(symbol.low) + (np.log(symbol.high) - np.log(symbol.low)) * uniform)
        return np.asarray(np.clip(drawn, symbol.low, symbol.high))
    spread = symbol.low + (symbol.high - symbol.low) * uniform
    return _near_quarter_turns(spread, generator) if symbol.unit == RADIAN else spread


def _up_to(
    highest: npt.NDArray[np.float64], symbol: Variable, generator: np.random.Generator
) -> npt.NDArray[np.float64]:
    """Evenly spread from the lower end of the domain to another symbol, which whole numbers reach too."""
    room = highest - symbol.low + symbol.whole
    return np.minimum(symbol.low + room * generator.random(highest.shape), highest)


def _near_quarter_turns(angles: npt.NDArray[np.float64], generator: np.random.Generator) -> npt.NDArray[np.float64]:
    """One angle in four is moved close to a multiple of 45 degrees, where sines or cosines vanish or agree."""
    eighth = np.pi / 4
    offset = np.exp(generator.uniform(np.log(1e-12), np.log(1e-2), angles.shape))
    moved = np.round(angles / eighth) * eighth + np.copysign(offset, angles)
    return np.where(generator.random(angles.shape) < 0.25, moved, angles)


def coarse(quantity: Quantity, count: int, seed: int = 0) -> Points:
    """Points with large, correlated errors, off the axes, where every effect that a formula holds stands out."""
    generator = np.random.Generator(np.random.Philox(seed))
    points: Points = {}
    for symbol in quantity.symbols:
        highest = points.get(symbol.at_most.name) if symbol.at_most is not None else None
        size = generator.random(count), generator.random(count)
        is_measured = quantity.model is None or symbol not in quantity.model.parameters
        deviates = is_deviation(quantity, symbol)
        drawn = _coarse(symbol, *size, highest, is_deviation=deviates, is_measured=is_measured)
        points[symbol.name] = np.floor(drawn) if symbol.whole else drawn
    return calmed(quantity.model, points) if quantity.model is not None else points


def is_deviation(quantity: Quantity, symbol: Variable) -> bool:
    """Whether a symbol is the standard deviation of an error, whatever a model of one's own calls it."""
    own = quantity.model.deviations if quantity.model is not None else ()
    return "sigma_" in symbol.name or symbol in {*own, *map(predicted, own)}


def _coarse(
    symbol: Variable,
    uniform: npt.NDArray[np.float64],
    other: npt.NDArray[np.float64],
    highest: npt.NDArray[np.float64] | None,
    *,
    is_deviation: bool,
    is_measured: bool,
) -> npt.NDArray[np.float64]:
    sign = np.where(other < 0.5, -1.0, 1.0)
    if highest is not None:
        return np.minimum(symbol.low + (highest - symbol.low + symbol.whole) * uniform, highest)
    if symbol.is_correlation:
        return sign * (0.1 + 0.8 * uniform)
    if symbol.unit == RADIAN:
        return 0.1 + 0.5 * uniform if is_deviation else symbol.low + (symbol.high - symbol.low) * uniform
    if is_deviation and symbol.unit == ONE:
        return symbol.high * (0.1 + 0.5 * uniform)
    if symbol.whole:
        return np.asarray(symbol.low + min(40.0, symbol.high - symbol.low) * uniform)
    if is_deviation:
        return math.sqrt(symbol.low * symbol.high) * (10 + 90 * uniform)
    if symbol.low > 0:
        return _coarse_size(symbol, uniform, is_measured=is_measured)
    if symbol.low == 0:
        return min(10.0, symbol.high) * uniform
    if symbol.high <= 0:
        return symbol.low + (symbol.high - symbol.low) * uniform
    return np.asarray(np.where(sign < 0, symbol.low, symbol.high) * (0.1 + 0.4 * uniform))


def _coarse_size(symbol: Variable, uniform: npt.NDArray[np.float64], *, is_measured: bool) -> npt.NDArray[np.float64]:
    if symbol.unit == METRE and symbol.low >= FAR:  # errors stand out where it is nearest
        return symbol.low * (1.0 + uniform)
    if symbol.unit == METRE and not is_measured:
        return symbol.high * (0.3 + 0.6 * uniform)
    return np.asarray(symbol.low * np.power(min(1e3, symbol.high / symbol.low), 2 / 3 + uniform / 3))
