"""Letters that the field uses for functions of a quantity's symbols: r in a Jacobian by x and y, N on an ellipsoid."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction

from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.question.letters.letter_meanings import means
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import METRE, ONE, Unit

COVARIANCES = ("P", "P_", "p", "K", "K_", "R_", "C_", "cov_", "sigma_", "s")  # stems of their names
LIKELY, FARTHER = 0, 2  # ranks, as those of what letters may stand for


@dataclass(frozen=True)
class Dependent:
    """A letter that stands for a function of symbols.

    Attributes:
        variable: what it would be if it were a symbol: its name, which may be meant by others, and its unit.
        value: the function.
        spelled: names that say it, besides those that mean the variable.
        rank: how far-fetched it is.
    """

    variable: Variable
    value: Expr
    spelled: frozenset[str] = frozenset()
    rank: int = LIKELY

    def is_called(self, name: str) -> bool:
        """Whether a name may say it."""
        return name in self.spelled or name == self.variable.name or bool(means(name, [self.variable]))


def dependents(quantities: Iterable[Quantity]) -> list[Dependent]:
    """The letters that formulas of these quantities are printed in, besides their symbols."""
    found: dict[str, Dependent] = {}
    for quantity in quantities:
        own = {symbol.name for symbol in quantity.symbols}
        for one in _of(quantity):
            if one.variable.name not in own:
                found.setdefault(one.variable.name, one)
    return list(found.values())


def _of(quantity: Quantity) -> Iterator[Dependent]:
    symbols = {symbol.name: symbol for symbol in quantity.symbols}
    first, *rest = quantity.name.split(".")
    if first == "observe":
        yield from _measured(rest[0], symbols)
    elif f"{first}.map" in catalogue():
        yield from _coordinates(first)
    if "semi_major_axis" in symbols:
        yield from _of_ellipsoid(symbols)
    if "k" in symbols and symbols["k"].whole:
        yield from _counts(symbols)
    if first == "steady_state":
        yield from _gains(catalogue()[f"{first}.{rest[0]}.gain"])
    yield from _intensities(symbols)
    yield from _covariances(symbols)


def _measured(sensor: str, symbols: dict[str, Variable]) -> Iterator[Dependent]:
    """What the sensor measures, in terms of the state; and the distance in the plane below."""
    model = "polar" if sensor == "bearing" else sensor
    entries = catalogue()[f"observe.{model}.map"].expression.entries
    if f"{model}.map" in catalogue():
        yield from map(Dependent, catalogue()[f"{model}.map"].symbols, entries)
    if "receiver_x" not in symbols and {"x", "y"} <= symbols.keys():
        x, y = symbols["x"], symbols["y"]
        below = _variable("ground_range", "distance in the plane", METRE)
        spelled = frozenset({"rho", "d", "s", "p", "r_xy", "rxy", "r_h", "rh", "r_g", "rg", "r_2", "r2d"})
        if "z" in symbols or "baseline" in symbols:
            yield Dependent(below, sp.sqrt(x**2 + y**2), spelled, FARTHER)


def _coordinates(model: str) -> Iterator[Dependent]:
    """The coordinates that a measurement is converted to, and the third direction cosine."""
    converted = catalogue()[f"{model}.map"]
    for place, entry in enumerate(converted.expression.entries):
        unit = converted.unit((place,))
        name = "xyz"[place] if unit == METRE else "eta"
        yield Dependent(_variable(name, f"{name} of the plot", unit), entry)
    if {"u", "v"} <= {symbol.name for symbol in converted.symbols}:
        u, v = (symbol for symbol in converted.symbols if symbol.name in {"u", "v"})
        yield Dependent(_variable("w", "third direction cosine", ONE), sp.sqrt(1 - u**2 - v**2))


def _of_ellipsoid(symbols: dict[str, Variable]) -> Iterator[Dependent]:
    a, f = symbols["semi_major_axis"], symbols["flattening"]
    squared = f * (2 - f)
    lengths = {"semi_minor_axis": ({"b", "R_p"}, a * (1 - f))}
    if "latitude" in symbols:
        sine = sp.sin(symbols["latitude"])
        root = sp.sqrt(1 - squared * sine**2)
        lengths["prime_vertical"] = {"N", "nu", "R_N", "RN", "N_phi", "R_E", "N_e"}, a / root
        lengths["meridian"] = {"M", "R_M", "RM"}, a * (1 - squared) / root**3
    for name, (spelled, value) in lengths.items():
        yield Dependent(_variable(name, f"{name} radius", METRE), value, frozenset(spelled))
    numbers = {
        "eccentricity": ({"e", "ecc"}, sp.sqrt(squared)),
        "squared_eccentricity": ({"e2", "e_2", "esq", "e_sq", "ecc2", "e1sq"}, squared),
        "second_eccentricity_squared": ({"ep2", "e_p2", "epsq", "e2sq"}, squared / (1 - f) ** 2),
    }
    for name, (spelled, value) in numbers.items():
        yield Dependent(_variable(name, name.replace("_", " "), ONE), value, frozenset(spelled))


def _counts(symbols: dict[str, Variable]) -> Iterator[Dependent]:
    """Scans counted from zero: the last is n, and there are n + 1; the newest may be counted first."""
    k = symbols["k"]
    yield Dependent(_variable("last", "number of the last scan", ONE, k.low), k - 1, frozenset("nNLm"), FARTHER)
    if "j" in symbols:
        j = symbols["j"]
        for name, value in (("from_zero", j - 1), ("back", k - j)):
            yield Dependent(_variable(name, f"scans {name}", ONE, k.low), value, frozenset("ilnmr"), FARTHER)


def _gains(quantity: Quantity) -> Iterator[Dependent]:
    spelled = ("alpha", {"alfa", "g", "K1", "K_1"}), ("beta", {"h", "K2", "K_2"}), ("gamma", {"K3", "K_3"})
    for (name, others), entry in zip(spelled, quantity.expression.entries, strict=False):
        yield Dependent(_variable(name, f"gain {name}", ONE), entry, frozenset(others))


def _intensities(symbols: dict[str, Variable]) -> Iterator[Dependent]:
    """The one-sided density of white noise, and, of what it drives, its deviation or the intensity of the noise."""
    if "q" in symbols:
        unit = symbols["q"].unit
        one_sided = frozenset({"N0", "N_0", "N_w"})
        yield Dependent(_variable("one_sided", "one-sided spectral density", unit), 2 * symbols["q"], one_sided)
    if {"alpha", "sigma_m"} <= symbols.keys():
        alpha, sigma = symbols["alpha"], symbols["sigma_m"]
        unit = alpha.unit * sigma.unit**2
        yield Dependent(_variable("q", "intensity of the noise", unit), 2 * alpha * sigma**2, frozenset({"S_w", "Sw"}))
    if {"alpha", "q"} <= symbols.keys():
        alpha, q = symbols["alpha"], symbols["q"]
        spelled = frozenset({"sigma", "sigma_v", "s_v", "sigma_0", "sigma_m"})
        deviation = _variable("stationary_std", "deviation in the long run", (q.unit / alpha.unit) ** Fraction(1, 2))
        yield Dependent(deviation, sp.sqrt(q / (2 * alpha)), spelled, FARTHER)


def _covariances(symbols: dict[str, Variable]) -> Iterator[Dependent]:
    """The covariance of two errors, where there is one correlation and it is clear of what."""
    correlations = [symbol for symbol in symbols.values() if symbol.is_correlation]
    for rho in correlations:
        said = rho.name.removeprefix("rho_") if rho.name != "rho" else ""
        of = _correlated(rho, symbols) if not said else [symbols.get(f"sigma_{one}") for one in said]
        if len(of) == 2 and None not in of:
            one, other = (symbol for symbol in of if symbol is not None)
            both = one.name.removeprefix("sigma_"), other.name.removeprefix("sigma_")
            joined = {f"{a}{mark}{b}" for mark in ("", "_") for a, b in (both, both[::-1])}
            spelled = {f"{stem}{pair}" for stem in COVARIANCES for pair in joined}
            variable = _variable(f"covariance_{both[0]}_{both[1]}", "covariance of two errors", one.unit * other.unit)
            yield Dependent(variable, rho * one * other, frozenset(spelled | {"cov"}))


def _correlated(rho: Variable, symbols: dict[str, Variable]) -> list[Variable | None]:
    """The deviations of the two errors that a correlation is said to be of."""
    words = rho.meaning.replace(",", " ").split()
    return [symbols[f"sigma_{word}"] for word in words if f"sigma_{word}" in symbols]


def _variable(name: str, meaning: str, unit: Unit, low: float = -math.inf) -> Variable:
    """Only read: no formula is compared over its domain."""
    return Variable(name, meaning, unit, max(low, -1e12), 1e12)
