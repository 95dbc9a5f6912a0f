"""Bounds of the error of a generated function over its whole domain: boxes are split until the bound is good enough."""

from __future__ import annotations

import ast
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from radartrack.verification.rounding.domain_boxes import (
    Argument,
    Case,
    Coordinates,
    cases,
    coordinates,
    given,
    tree_of,
)
from radartrack.verification.rounding.enclosures import Array, total
from radartrack.verification.rounding.error_rules import Atom, Parts, Value
from radartrack.verification.rounding.statements import Index, evaluated

BATCH = 2048
SAMPLES = 64
MARGIN = 1.0 + 1e-6  # of a bound, over what floating point gave; the checker rounds outward
SHARP = 1.25  # a box is good enough when its bound is within this of the worst point's
WORST_FIRST = 16
SHARED = 0.4  # terms are shared among products whose logarithms are this close to the best


class NotProved(ValueError):
    """No finite bound was found."""


@dataclass(frozen=True)
class Theorem:
    """What is to be shown of a function.

    Attributes:
        function: its definition.
        arguments: with their domains.
        shape: of an entry's index.
        scale: "covariance", "terms", or "norm": what errors are measured against.
        groups: for "norm", of each entry in row-major order the positions whose norm it is measured against.
    """

    function: ast.FunctionDef
    arguments: Sequence[Argument]
    shape: Index
    scale: str
    groups: Sequence[Sequence[int]]


@dataclass
class Proof:
    """A bound and the boxes that it holds on.

    Attributes:
        bound: in ulp of the scale.
        trees: case → its splits, in the order in which they are met; "." is a box that is not split, a letter the
            coordinate that is halved.
        boxes: how many there are.
        at_points: the worst bound that the rules give at single points: what splitting cannot go below.
    """

    bound: float
    trees: dict[str, str]
    boxes: int
    at_points: float


def figures(theorem: Theorem, case: Case, place: Coordinates, low: Array, high: Array) -> Array:
    """The bound on each box, in ulp of the scale."""
    found = [_figures(theorem, case, place, low[i : i + BATCH], high[i : i + BATCH]) for i in range(0, len(low), BATCH)]
    return np.concatenate(found)


def _figures(theorem: Theorem, case: Case, place: Coordinates, low: Array, high: Array) -> Array:
    with np.errstate(all="ignore"):
        start = given(theorem.arguments, case, place, low, high)
        entries = evaluated(theorem.function, start)
        values = [entries[index] for index in np.ndindex(theorem.shape)]
        worst = np.zeros(len(low))
        for position, value in enumerate(values):
            if value is not None and not value.is_exact:
                worst = np.fmax(worst, _figure(theorem, values, position, value))
    return np.where(np.isnan(worst), np.inf, worst)


def _figure(theorem: Theorem, values: Sequence[Value | None], position: int, value: Value) -> Array:
    paired = np.full_like(value.relative, np.inf)
    if theorem.scale == "covariance":
        n = theorem.shape[-1]
        row, column = divmod(position, n)
        if row == column:
            return _nan_is_infinite(value.relative)
        first, second = values[row * n + row], values[column * n + column]
        if first is None or second is None:
            return np.full_like(value.relative, np.inf)
        scale = (first.size * second.size).power(0.5)
        paired = _paired(value, first, second)
    elif theorem.scale == "terms":
        scale = value.terms
    else:
        peers = [values[i] for i in theorem.groups[position]]
        if len(peers) == 1:
            return _nan_is_infinite(value.relative)
        sizes = [peer.size.power(2.0) for peer in peers if peer is not None]
        scale = total(sizes).power(0.5)
    if value.error is None:
        return np.zeros_like(value.relative)
    whole = np.fmin(_nan_is_infinite(np.exp((value.error / scale).high)), paired)
    return np.fmin(whole, _nan_is_infinite(value.relative))


def _paired(value: Value, first: Value, second: Value) -> Array:
    """The error of a covariance by √(c_ii c_jj), term by term.

    With c_ii = Σ aₘ and c_jj = Σ bₙ, an error that is at most Σ Mₘₙ √(aₘ bₙ) is at most √(c_ii c_jj) times the norm of
    the matrix M, and that is at most the root of its largest sum along rows by that along columns (Schur). So every
    term of the error is shared out among products aₘ bₙ that it is small against: one of cos β sin β a goes with
    cos² β a and sin² β a, wherever β is.
    """
    if first.makeup is None or second.makeup is None:
        return np.full_like(value.relative, np.inf)
    rows, columns, terms = first.makeup, second.makeup, value.error_parts
    atoms = sorted({one for parts in (rows, columns, terms) for key in parts for one, _ in key}, key=_serial)
    of_rows, of_columns, of_terms = (_exponents(parts, atoms) for parts in (rows, columns, terms))
    log_rows, log_columns = np.stack(list(rows.values())), np.stack(list(columns.values()))
    middles = np.stack([one.size.middle for one in atoms])
    slopes = np.stack([one.size.slopes for one in atoms])
    above, below = (np.stack([getattr(one.size, end) for one in atoms]) for end in ("above", "below"))
    matrix = np.zeros((len(rows), len(columns), len(value.relative)))
    for exponents, coefficient in zip(of_terms, terms.values(), strict=True):
        net = exponents - (of_rows[:, np.newaxis] + of_columns[np.newaxis]) / 2
        highs = coefficient - (log_rows[:, np.newaxis] + log_columns[np.newaxis]) / 2 + net @ middles
        highs += np.abs(np.tensordot(net, slopes, 1)).sum(axis=-1)
        highs += _slack(np.maximum(net, 0), above) + _slack(np.maximum(-net, 0), below)
        lowest = highs.min(axis=(0, 1))
        shared = highs <= lowest + SHARED
        matrix += np.exp(highs) * shared / shared.sum(axis=(0, 1))
    norm: Array = np.sqrt(matrix.sum(axis=1).max(axis=0) * matrix.sum(axis=0).max(axis=0))
    return norm


def _serial(one: Atom) -> int:
    return one.serial


def _exponents(parts: Parts, atoms: Sequence[Atom]) -> Array:
    """Shape (parts, atoms)."""
    return np.array([[dict(key).get(one, 0.0) for one in atoms] for key in parts])


def _slack(exponents: Array, ends: Array) -> Array:
    """Where an exponent is zero, an end that is infinite does not count."""
    endless = (exponents > 0) @ np.isinf(ends).astype(float)
    return np.where(endless > 0, np.inf, exponents @ np.where(np.isinf(ends), 0.0, ends))


def _nan_is_infinite(values: Array) -> Array:
    return np.where(np.isnan(values), np.inf, values)


def proved(theorem: Theorem, *, correlated: bool = False, most: int = 2000, enough: float = 0.0) -> Proof:
    """A bound over the whole domain.

    Args:
        theorem: what is to be shown.
        correlated: whether correlations go up to 0.99 in size; they are zero otherwise.
        most: how many boxes a case may have.
        enough: a bound that need not be made smaller.

    Raises:
        NotAnalysed: a statement holds what there is no rule for.
        NotProved: no finite bound was found.
    """
    chosen = [(case, coordinates(theorem.arguments, case)) for case in cases(theorem.arguments, correlated=correlated)]
    at_points = max(_at_points(theorem, case, place) for case, place in chosen)
    target = max(SHARP * at_points, enough)
    trees, bound, boxes = {}, 0.0, 0
    for case, place in chosen:
        forest = _Forest(theorem, case, place)
        forest.split(target, most)
        bound = max(bound, forest.bound)
        boxes += len(forest.figures)
        trees[case.text] = forest.text
        if not math.isfinite(bound):
            raise NotProved(f"no bound in {boxes} boxes; {case.text}")
    return Proof(bound * MARGIN, trees, boxes, at_points)


def _at_points(theorem: Theorem, case: Case, place: Coordinates) -> float:
    generator = np.random.Generator(np.random.Philox(11))
    points = place.low + (place.high - place.low) * generator.random((SAMPLES, len(place.low)))
    found = figures(theorem, case, place, points, points)
    return float(found[np.isfinite(found)].max(initial=0.0))


class _Forest:
    """Boxes of one case, the tree of their splits, and the bound on each."""

    def __init__(self, theorem: Theorem, case: Case, place: Coordinates) -> None:
        self.theorem, self.case, self.place = theorem, case, place
        self.low, self.high = place.low[np.newaxis].copy(), place.high[np.newaxis].copy()
        self.paths = [""]
        curved = _of_exponentials(theorem.function)
        self.curved = {axis for name, axis in place.places.items() if name in curved}
        self.splits: dict[str, int] = {}
        self.figures = figures(theorem, case, place, self.low, self.high)

    @property
    def bound(self) -> float:
        return float(self.figures.max())

    @property
    def text(self) -> str:
        """The tree in preorder."""
        return tree_of(self.splits)

    def split(self, target: float, most: int) -> None:
        """Halve the boxes above the target, worst first, until none is left or there are too many."""
        while len(self.figures) < most:
            over = np.flatnonzero(self.figures > target)
            if not len(over):
                return
            worst = over[np.argsort(-self.figures[over], kind="stable")][: min(WORST_FIRST, most - len(self.figures))]
            if not len(worst) or not self.place.low.size:
                return
            self._halve(worst)

    def _halve(self, which: np.ndarray) -> None:
        low, high = self.low[which], self.high[which]
        axes = low.shape[1]
        middle = (low + high) / 2
        best = np.full(len(which), np.inf)
        axis_of = np.argmax(high - low, axis=1)
        both = np.full((len(which), 2), np.inf)
        for axis in range(axes):
            first_high, second_low = high.copy(), low.copy()
            first_high[:, axis] = second_low[:, axis] = middle[:, axis]
            first = figures(self.theorem, self.case, self.place, low, first_high)
            second = figures(self.theorem, self.case, self.place, second_low, high)
            cost = _badness(np.maximum(first, second)) + 0.5 * _badness(np.minimum(first, second))
            cost = cost - 1e-6 * (high - low)[:, axis] * (100.0 if axis in self.curved else 1.0)
            better = cost < best
            axis_of = np.where(better, axis, axis_of)
            best = np.where(better, cost, best)
            both = np.where(better[:, np.newaxis], np.stack([first, second], axis=1), both)
        rows = np.arange(len(which))
        first_high, second_low = high.copy(), low.copy()
        first_high[rows, axis_of] = second_low[rows, axis_of] = middle[rows, axis_of]
        paths = [self.paths[i] for i in which]
        for path, axis in zip(paths, axis_of, strict=True):
            self.splits[path] = int(axis)
        keep = np.ones(len(self.figures), dtype=bool)
        keep[which] = False
        kept = [path for path, stays in zip(self.paths, keep, strict=True) if stays]
        self.paths = kept + [path + "0" for path in paths] + [path + "1" for path in paths]
        self.low = np.concatenate([self.low[keep], low, second_low])
        self.high = np.concatenate([self.high[keep], first_high, high])
        self.figures = np.concatenate([self.figures[keep], both[:, 0], both[:, 1]])


def _of_exponentials(function: ast.FunctionDef) -> set[str]:
    """The names that exponentials depend on: where no axis is better than another, these are worth splitting."""
    made_of: dict[str, set[str]] = {}
    found: set[str] = set()
    for statement in function.body:
        if isinstance(statement, ast.Assign) and isinstance(statement.targets[0], ast.Name):
            made_of[statement.targets[0].id] = _names(statement.value, made_of)
            for call in ast.walk(statement.value):
                if isinstance(call, ast.Call) and ast.unparse(call.func) in {"np.exp", "np.expm1"}:
                    found |= _names(call, made_of)
    return found


def _names(node: ast.expr, made_of: dict[str, set[str]]) -> set[str]:
    names = {one.id for one in ast.walk(node) if isinstance(one, ast.Name)}
    return names.union(*(made_of.get(name, set()) for name in names)) if names else names


def _badness(bounds: Array) -> Array:
    """On a scale on which a box outside of the domain counts nothing and no bound at all counts much."""
    return np.log(np.clip(bounds, 1.0, 1e300)) + np.where(np.isposinf(bounds), 100.0, 0.0)
