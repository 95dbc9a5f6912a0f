"""A picture of rounding errors over the domain: the stable form of a formula beside the one that textbooks print."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes

from radartrack.reproduction.pictures import BLACK, BLUE, ORANGE, Picture, drawing
from radartrack.verification.errors_over_domain import Array, Axis, ErrorsOverDomain

LEAST, MOST = 2.0**-4, 2.0**54  # ulp that are shown; no digit is right at the upper end
BINS = 24
PANEL = 3.4, 2.6  # inches


def error_plot(errors: ErrorsOverDomain, proved: Mapping[str, float]) -> Picture:
    """A panel for every argument: the error at points of the domain over it, and the largest in each part of it.

    Args:
        errors: at points.
        proved: bounds in ulp; "double" is drawn.
    """
    count = len(errors.axes)
    columns = min(count, 2 if count == 4 else 3)
    rows = math.ceil(count / columns)
    with drawing(PANEL[0] * columns, PANEL[1] * rows + 0.7) as figure:
        panels = figure.subplots(rows, columns, sharey=True, squeeze=False)
        for panel, axis in zip(panels.flat, errors.axes, strict=False):
            _draw(panel, axis, errors, proved.get("double"))
        for panel in panels.flat[count:]:
            panel.set_visible(False)
        for row in panels:
            row[0].set_ylabel("error [ulp]")
        figure.suptitle(f"{errors.name}: rounding errors in double precision")
        handles, labels = panels[0, 0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside lower center", ncols=len(labels))
    largest = [float(found.max(initial=0.0)) for found in (errors.stable, errors.textbook)]
    said = f"Largest error at {len(errors.stable)} points: {largest[0]:.3g} ulp, of the textbook form {largest[1]:.3g}."
    return Picture(errors.name, figure, said, f"Rounding errors of {errors.name} over each argument. {said}")


def _draw(panel: Axes, axis: Axis, errors: ErrorsOverDomain, bound: float | None) -> None:
    even = {"linthresh": axis.even_below} if axis.scale == "symlog" else {}
    panel.set_xscale(axis.scale, **even)
    forms = ((errors.textbook, ORANGE, "as textbooks print it"), (errors.stable, BLUE, "as generated"))
    for found, colour, label in forms:
        sizes = np.clip(np.where(np.isfinite(found), found, MOST), LEAST, MOST)
        panel.plot(axis.values, sizes, ".", color=colour, markersize=3, alpha=0.5, markeredgewidth=0)
        panel.plot(*_upper(axis.values, sizes), color=colour, label=f"{label}, largest")
    if bound is not None:
        panel.axhline(max(bound, LEAST), color=BLACK, linestyle="--", linewidth=1, label="proved bound")
    panel.set_yscale("log", base=2)
    panel.set_ylim(LEAST, MOST)
    panel.set_xlabel(axis.label)


def _upper(values: Array, sizes: Array) -> tuple[list[float], list[float]]:
    """In each of some parts with as many points the median place and the largest error."""
    parts = np.array_split(np.argsort(values, kind="stable"), BINS)
    there = [part for part in parts if len(part)]
    return [float(np.median(values[part])) for part in there], [float(sizes[part].max()) for part in there]
