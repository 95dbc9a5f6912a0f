"""A picture of rounding errors over the domain: the stable form of a formula beside the one that textbooks print."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes

from radartrack.derive.evaluation.balls import exact_arithmetic
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.reproduction.pictures import BLACK, BLUE, ORANGE, Picture, drawing
from radartrack.verification.domain_points import Points, sample
from radartrack.verification.error_in_ulp import Yardstick
from radartrack.verification.program_compilation import compiled
from radartrack.verification.subject import evaluated, generated

Array = npt.NDArray[np.float64]
LEAST, MOST = 2.0**-4, 2.0**54  # ulp that are shown; no digit is right at the upper end
BINS = 24
PANEL = 3.4, 2.6  # inches


@dataclass(frozen=True)
class Errors:
    """What two ways to compute a quantity are off by at points of its domain, in ulp."""

    points: Points
    stable: Array
    textbook: Array


def errors_over_domain(quantity: Quantity, count: int = 600, seed: int = 0) -> Errors:
    """The errors of the generated function and of the formula as it is derived, in double precision."""
    points = sample(quantity, count, seed)
    yardstick = Yardstick(quantity, points, exact_arithmetic()[1])
    entries = math.prod(quantity.shape)
    found = []
    for function in (generated(quantity), compiled(quantity.expression, quantity.symbols)):
        values = evaluated(function, quantity, points).reshape(-1, entries)
        found.append(yardstick.errors(values).max(axis=-1))
    return Errors(points, *found)


def error_plot(quantity: Quantity, errors: Errors, proved: Mapping[str, float]) -> Picture:
    """A panel for every argument: the error at points of the domain over it, and the largest in each part of it.

    Args:
        quantity: what is computed.
        errors: at points.
        proved: bounds in ulp; "double" is drawn.
    """
    shown = [symbol for symbol in quantity.symbols if np.ptp(errors.points[symbol.name])]
    columns = min(len(shown), 2 if len(shown) == 4 else 3)
    rows = math.ceil(len(shown) / columns)
    with drawing(PANEL[0] * columns, PANEL[1] * rows + 0.7) as figure:
        panels = figure.subplots(rows, columns, sharey=True, squeeze=False)
        for panel, symbol in zip(panels.flat, shown, strict=False):
            _draw(panel, symbol, errors, proved.get("double"))
        for panel in panels.flat[len(shown) :]:
            panel.set_visible(False)
        for row in panels:
            row[0].set_ylabel("error [ulp]")
        figure.suptitle(f"{quantity.name}: rounding errors in double precision")
        handles, labels = panels[0, 0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside lower center", ncols=len(labels))
    largest = [float(found.max(initial=0.0)) for found in (errors.stable, errors.textbook)]
    said = f"Largest error at {len(errors.stable)} points: {largest[0]:.3g} ulp, of the textbook form {largest[1]:.3g}."
    return Picture(quantity.name, figure, said, f"Rounding errors of {quantity.name} over each argument. {said}")


def _draw(panel: Axes, symbol: Variable, errors: Errors, bound: float | None) -> None:
    values = errors.points[symbol.name]
    _scale(panel, symbol)
    for found, colour, label in (
        (errors.textbook, ORANGE, "as textbooks print it"),
        (errors.stable, BLUE, "as generated"),
    ):
        sizes = np.clip(np.where(np.isfinite(found), found, MOST), LEAST, MOST)
        panel.plot(values, sizes, ".", color=colour, markersize=3, alpha=0.5, markeredgewidth=0)
        panel.plot(*_upper(values, sizes), color=colour, label=f"{label}, largest")
    if bound is not None:
        panel.axhline(max(bound, LEAST), color=BLACK, linestyle="--", linewidth=1, label="proved bound")
    panel.set_yscale("log", base=2)
    panel.set_ylim(LEAST, MOST)
    panel.set_xlabel(f"{symbol.name} [{symbol.unit}]")


def _scale(panel: Axes, symbol: Variable) -> None:
    if symbol.logarithmic:
        panel.set_xscale("log")
    elif not symbol.is_angle:
        panel.set_xscale("symlog", linthresh=max(abs(symbol.low), abs(symbol.high)) * 1e-6)


def _upper(values: Array, sizes: Array) -> tuple[list[float], list[float]]:
    """In each of some parts with as many points the median place and the largest error."""
    parts = np.array_split(np.argsort(values, kind="stable"), BINS)
    there = [part for part in parts if len(part)]
    return [float(np.median(values[part])) for part in there], [float(sizes[part].max()) for part in there]
