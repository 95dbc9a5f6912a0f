"""Where a right function loses its digits: at which deviations, how many, and by which subtraction."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import combinations

import mpmath
import numpy as np
import numpy.typing as npt

from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.printing import to_text
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.stable.term_sizes import term_sizes
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import METRE, ONE, SECOND, Unit
from radartrack.testing.calling.called_function import Array
from radartrack.testing.diagnosis import LostDigits
from radartrack.testing.diagnosis import place as at_place
from radartrack.testing.function_conventions import deviations_of
from radartrack.testing.wanted import Expected

MANY_ULP = 1000.0  # three digits
ALLOWANCE = 2.0**12  # units of rounding of the sizes of the terms that a textbook form may be off by
DOUBLE, SINGLE = 2.0**-52, 2.0**-23
CLEAR = 0.3  # correlation of the error with a symbol from which it is said to grow with it
LONG = 100
MORE = 2  # digits that are lost beyond those that cancel: by the terms' own rounding
MOSTLY = 0.8  # of the points on one side, at which digits are lost there
FEWEST, STEADY = 5, 2.0  # points, and decades of the numbers whose rounding an error is
# By which arguments are moved, in units of a scale; steps that are whole numbers meet a regular staircase alike.
STEPS = (-7.13, -5.39, -3.71, -2.17, 1.93, 3.37, 4.91, 6.79)
SCALES = (DOUBLE, 2.0**-40, 2.0**-28, 2.0**-16)
SLOPES = (1.0, -0.7, 1.3, -1.9)  # of one argument beside another: ratios move too
SCATTER = 0.05  # of the error, about a parabola


def is_rounding(expected: Expected, found: Array, epsilon: float) -> npt.NDArray[np.bool_]:
    """Where the difference is no more than rounding in the derived formula as it stands may make."""
    wanted = expected.wanted
    sizes = Tensor((len(wanted.entries),), tuple(map(term_sizes, wanted.entries)))
    evaluator = Evaluator(sizes, wanted.quantity.symbols)
    allowed = np.zeros(found.shape)
    for place in range(expected.count):
        try:
            allowed[place] = [float(value) for value in evaluator(list(expected.point(place).values()))]
        except (ArithmeticError, TypeError, ValueError):
            allowed[place] = np.inf
    allowed = np.maximum(allowed, expected.scales)
    with np.errstate(all="ignore"):
        return np.asarray(np.abs(found - expected.values) <= ALLOWANCE * epsilon * allowed)


def is_erratic(
    error_near: Callable[[dict[str, npt.NDArray[np.float64]]], Array],
    symbols: Sequence[Variable],
    point: dict[str, float],
    entry: int,
) -> bool:
    """Whether the error jumps when the arguments move a little, as only rounding makes it do.

    It is looked at on several scales: asin(z/r) close to the vertical stays where it is until its argument moves by
    its last digit, which takes a larger step than the last digit of z.
    """
    for scale in SCALES:
        near = {name: np.full(len(STEPS), value) for name, value in point.items()}
        for place, symbol in enumerate(symbols):
            if not symbol.whole and not symbol.is_correlation:
                steps = np.array(STEPS) * scale * SLOPES[place % len(SLOPES)]
                near[symbol.name] = point[symbol.name] * (1 + steps)
        errors = error_near(near)[:, entry]
        if len(errors) == len(STEPS) and np.isfinite(errors).all():
            size = float(np.abs(errors).max())
            smooth = np.polynomial.Polynomial.fit(STEPS, errors / size, 2) if size > 0 else None
            if smooth is not None and float(np.abs(errors / size - smooth(np.array(STEPS))).max()) > SCATTER:
                return True
    return False


def lost_digits(expected: Expected, errors: Array, epsilon: float) -> LostDigits | None:
    """How many digits are lost, and where; None where hardly any are.

    Args:
        expected: the exact values.
        errors: of the function there, in ulp of its precision, shape (points, entries).
        epsilon: the unit of its precision.
    """
    if not errors.size or errors.max() <= MANY_ULP:
        return None
    errors = np.minimum(errors, epsilon**-2)  # beside an exact zero every error is infinite
    place, entry = np.unravel_index(int(errors.argmax()), errors.shape)
    held = -math.log10(epsilon)
    digits = min(math.floor(math.log10(max(errors.max(), 1.0))), math.ceil(held))
    quantity = expected.wanted.quantity
    return LostDigits(
        digits,
        _where(expected, errors.max(axis=1), int(place)),
        _subtraction(expected.wanted.entries[int(entry)], expected, int(place), digits - MORE)
        or next(filter(None, (_what_is_subtracted(expected, errors, one) for one in _worst_first(errors))), ""),
        f"radartrack.generated.{quantity.module}.{quantity.function}" if quantity.name in catalogue() else "",
    )


def _where(expected: Expected, errors: npt.NDArray[np.float64], place: int) -> str:
    """The symbol with which the error grows or falls most clearly, and from which value on."""
    logarithms = np.log10(np.maximum(errors, 1.0))
    found = {
        name: float(np.corrcoef(np.log10(values), logarithms)[0, 1])
        for name, values in _sizes(expected).items()
        if (values > 0).all() and np.ptp(values) > 0
    }
    spread = {name: clear for name, clear in found.items() if name in deviations_of(expected.wanted.symbols)}
    chosen = spread if any(clear < -CLEAR for clear in spread.values()) else found
    name = max(chosen, key=lambda name: abs(chosen[name]), default="")
    best = chosen.get(name, 0.0)
    if abs(best) < CLEAR:
        at = ", ".join(f"{one} = {value:.3g}" for one, value in expected.point(place).items())
        return f"at {at}"
    values, is_bad = _sizes(expected)[name], errors > MANY_ULP
    if best < 0:
        end = max((v for v in values[is_bad] if is_bad[values <= v].mean() >= MOSTLY), default=values[is_bad].min())
        return f"where {name} is small ({name} <= {end:.1e})"
    end = min((v for v in values[is_bad] if is_bad[values >= v].mean() >= MOSTLY), default=values[is_bad].max())
    return f"where {name} is large ({name} >= {end:.1e})"


def _sizes(expected: Expected) -> dict[str, npt.NDArray[np.float64]]:
    """The symbols that have one sign, and products and ratios of two that have no unit: T*alpha, sigma_r/r."""
    symbols = [symbol for symbol in expected.wanted.symbols if symbol.low >= 0]
    found = {symbol.name: np.abs(expected.points[symbol.name]) for symbol in symbols}
    for one, other in combinations([symbol for symbol in symbols if symbol.unit != ONE], 2):
        first, second = found[one.name], found[other.name]
        if one.unit * other.unit == ONE:
            found[f"{one.name}*{other.name}"] = first * second
        elif one.unit == other.unit and (first > 0).all():
            found[f"{other.name}/{one.name}"] = second / first
    return found


def _subtraction(entry: Expr, expected: Expected, place: int, least: float) -> str:
    """The sum of the derived formula whose terms cancel most there, and by so many digits as are to be explained."""
    worst, found = max(3.0, least), ""
    point = list(expected.point(place).values())
    for total in _sums(entry):
        try:
            whole, *terms = Evaluator(
                Tensor((1 + len(total.args),), (total, *total.args)), expected.wanted.quantity.symbols
            )(point)
        except (ArithmeticError, TypeError, ValueError):
            continue
        size = sum(abs(term) for term in terms)
        digits = 50.0 if not whole else float(mpmath.log10(size / abs(whole)))
        if digits > worst:
            text = to_text(to_tree(total))
            text = text if len(text) <= LONG else f"{text[: LONG - 3]}..."
            worst, found = digits, f"written as it stands, {text} cancels to one part in 1e{math.floor(digits)}"
    return found


def _worst_first(errors: Array) -> list[int]:
    return [int(place) for place in np.argsort(-errors.max(axis=0))]


def _what_is_subtracted(expected: Expected, errors: Array, entry: int) -> str:
    """How large the numbers are whose rounding the error is, where the derived formula itself does not cancel."""
    wanted = expected.wanted
    unit, words = _natural_unit(wanted.quantity.unit(wanted.places[entry]), expected)
    lost = (errors[:, entry] > MANY_ULP) & (expected.scales[:, entry] > 0)
    if unit is None or lost.sum() < FEWEST:
        return ""
    powers = np.log10(errors[lost, entry] * expected.scales[lost, entry] / unit[lost])
    low, middle, high = np.percentile(powers, [15, 50, 85])
    if high - low > STEADY:
        return ""
    where = at_place(wanted.places[entry]) if wanted.shape else ""
    size = f"{10.0 ** round(middle):g}" if round(middle) else "1"
    return f"{where}its error is that of rounding numbers near {size}{words}, whose difference is small there"


def _natural_unit(unit: Unit, expected: Expected) -> tuple[Array | None, str]:
    """That of an entry, made of the one length and the one time that there is: sigma_r**2/T."""
    symbols = expected.wanted.quantity.symbols
    made, words = np.ones(expected.count), []
    for base, power in ((METRE, unit.metre), (SECOND, unit.second)):
        having = [symbol for symbol in symbols if symbol.unit == base]
        if power and len(having) != 1:
            return None, ""
        if power:
            made = made * expected.points[having[0].name] ** float(power)
            words.append(having[0].name if power == 1 else f"{having[0].name}**{power}")
    return made, f" times {' and '.join(words)}" if words else ""


def _sums(entry: Expr) -> Iterator[Expr]:
    seen: set[Expr] = set()
    waiting = [entry]
    while waiting:
        node = waiting.pop()
        if node in seen:
            continue
        seen.add(node)
        if isinstance(node, sp.Add):
            yield node
        waiting.extend(node.args)
