"""The figures of the reproduction of Prosov, drawn from its tables."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from radartrack.reproduction.pictures import BLACK, BLUE, GREEN, ORANGE, PURPLE, RED, SKY, Picture, drawing, mark
from radartrack.reproduction.prosov import (
    CYCLES,
    DEGREES,
    DIRECTIONS,
    PERIOD,
    PERIODS,
    PRINTED,
    SEPARATED,
    VERSIONS,
    WEIGHTINGS,
)
from radartrack.reproduction.results import Reproduction, Table

METHODS = {
    "linear": ("linear: (8), (9)", BLACK, "-", ""),
    "printed": ("(10) as printed, (11)", RED, "-", "o"),
    "posterior": ("posterior", ORANGE, "--", "v"),
    "decorrelated": ("decorrelated", BLUE, "-.", "s"),
    "handed over": ("5 posterior, then decorrelated", BLACK, ":", "D"),
    "reversed": ("(10), sign reversed, (11)", GREEN, "-", "^"),
    "averaged": ("averaged", SKY, "--", "x"),
    "unbiased": ("unbiased", PURPLE, ":", "+"),
}
PERIOD_COLOURS = dict(zip(PERIODS, (BLUE, GREEN, RED, PURPLE), strict=True))
PLACES = {
    "one_plot": ("one converted plot, no filter", BLACK, "_"),
    "weighed_at_truth": ("filter, covariance at the truth", GREEN, "^"),
    "weighed_at_prediction": ("filter, covariance at the prediction", BLUE, "s"),
    "weighed_at_measurement": ("filter, covariance at the plot itself", RED, "o"),
}
LABELS = {"printed": "(10) as\nprinted", "reversed": "(10), sign\nreversed"}


def pictures(found: Reproduction) -> Iterator[Picture]:
    """All figures, in the order in which they are read."""
    figures = found.tables["figures_1_2"]
    for degrees in DEGREES:
        yield _difference(figures.where(azimuth_std_deg=degrees), degrees)
    yield _two_biases(found.tables["two_biases"])
    yield _map(found.tables["map"])
    yield _errors(figures)


def _difference(rows: Table, degrees: int) -> Picture:
    with drawing(7.2, 4.4) as figure:
        axes = figure.subplots()
        axes.axhline(0, color=BLACK, linewidth=0.8)
        for name, (label, colour, line, marker) in METHODS.items():
            if name != "linear":
                _band(axes, rows.where(method=name), "delta_x_percent", (label, colour, line, marker))
        for sign in (-1, 1):
            axes.axhline(sign * PRINTED[degrees], color=RED, linestyle=(0, (1, 2)), linewidth=1.2)
        axes.annotate(
            f"the paper: ±{PRINTED[degrees]:g} %", (CYCLES, -PRINTED[degrees]), xytext=(0, -11),
            textcoords="offset points", ha="right", color=RED, fontsize=8,
        )  # fmt: skip
        _cycles(axes)
        axes.set_ylabel("Δx: change of the error in x [%]")
        figure.legend(loc="outside lower center", ncols=3)
    return Picture(
        f"prosov_figure_{degrees}",
        figure,
        f"Prosov, figure {degrees}: relative change of the root mean square error of x against the linear conversion, "
        f"σᵣ = 250 m, σᵦ = {degrees}°, {PERIOD:g} s from cycle to cycle, target flying away; shaded: 95 % intervals. "
        "Every plot is weighed by a covariance computed from itself, but for those called decorrelated.",
        _said(rows, degrees),
    )


def _said(rows: Table, degrees: int) -> str:
    last = {name: rows.where(method=name).column("delta_x_percent")[-1] for name in METHODS if name != "linear"}
    listed = ", ".join(f"{METHODS[name][0]} {value:+.1f} %" for name, value in last.items())
    return f"Curves of the change of the error in x over 20 cycles for {degrees}° azimuth error. At the end: {listed}."


def _band(axes: Axes, rows: Table, name: str, style: tuple[str, str, str, str]) -> None:
    label, colour, line, marker = style
    first_marker = list(METHODS.values()).index(style) % 3  # lines that coincide show their markers side by side
    cycle = rows.column("cycle")
    axes.fill_between(
        cycle, rows.column(f"{name}_lower"), rows.column(f"{name}_upper"), color=colour, alpha=0.18, linewidth=0
    )
    axes.plot(
        cycle, rows.column(name), color=colour, linestyle=line, marker=marker, markevery=(first_marker, 3), label=label
    )


def _cycles(axes: Axes) -> None:
    axes.set_xlabel("cycle n")
    axes.set_xlim(1, CYCLES)
    axes.set_xticks([1, 5, 10, 15, 20])


def _two_biases(rows: Table) -> Picture:
    with drawing(7.2, 4.2) as figure:
        both = figure.subplots(1, 2, sharey=True)
        for axes, degrees in zip(both, DEGREES, strict=True):
            chosen = rows.where(azimuth_std_deg=degrees)
            places = np.arange(len(SEPARATED))
            for shift, (name, (label, colour, marker)) in zip((-0.24, -0.08, 0.08, 0.24), PLACES.items(), strict=True):
                value = chosen.column(name)
                ends = np.abs(np.stack([chosen.column(f"{name}_lower"), chosen.column(f"{name}_upper")]) - value)
                axes.errorbar(
                    places + shift, value, yerr=ends, color=colour, marker=marker, ls="none", label=label, ms=5
                )
            axes.axhline(0, color=BLACK, linewidth=0.8)
            axes.set_xticks(places, [LABELS.get(name, name) for name in SEPARATED], fontsize=7)
            axes.grid(visible=False, axis="x")
            axes.set_title(f"σᵦ = {degrees}°, r σᵦ² = {chosen.column('r_sigma2_m')[0]:.0f} m")
        both[0].set_ylabel("bias of x over r σᵦ²")
        figure.legend(*both[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
    return Picture(
        "prosov_two_biases",
        figure,
        f"Two biases after {CYCLES} cycles. The conversion’s own is what one plot and a filter with the covariance at "
        "the truth show: −½, −1 or 0 times r σᵦ². A covariance computed from the plot that it weighs adds about 0.9 "
        "r σᵦ² (1 in the limit) whatever the conversion; one at the prediction takes 0.2 away. Bars: 95 % intervals.",
        "Points for five conversions and four ways of weighing. At the truth the biases are −0.5 for linear, −1 for "
        "(10) as printed and posterior, 0 for the others; weighed at the plot itself all are higher by 0.9.",
    )


def _map(rows: Table) -> Picture:
    with drawing(7.2, 5.6) as figure:
        grid = figure.subplots(len(VERSIONS), len(WEIGHTINGS), sharex=True, sharey=True)
        for i, version in enumerate(VERSIONS):
            for j, weighting in enumerate(WEIGHTINGS):
                _trajectories(grid[i, j], rows.where(version=version, weighting=weighting))
                said = "as printed" if version == "printed" else "sign reversed"
                grid[i, j].set_title(f"(10) {said},\ncovariance at the {weighting}", fontsize=8)
        grid[1, 1].set_xlabel("largest |Δx| up to the cycle at σᵦ = 1° [%]")
        for axes in grid[:, 0]:
            axes.set_ylabel("the same at σᵦ = 2° [%]")
        keys = [Line2D([], [], color=colour, label=f"T₀ = {period:g} s") for period, colour in PERIOD_COLOURS.items()]
        keys += [Line2D([], [], color=BLACK, linestyle="-", label="away")]
        keys += [Line2D([], [], color=BLACK, linestyle="--", label="towards")]
        keys.append(Line2D([], [], color=RED, marker="*", linestyle="none", markersize=10, label="the paper"))
        figure.legend(handles=keys, loc="outside lower center", ncols=7)
    return Picture(
        "prosov_map",
        figure,
        "Which settings give the paper’s two numbers: each curve is one period and one direction, followed over the "
        "cycles; dots at cycles 5, 10, 20 and 40. A curve through the star gives both numbers with the number of "
        "cycles there.",
        "Six panels of curves of the largest change at 2° over that at 1°. With (10) as printed and covariances from "
        "the plots the curves run through the paper’s point (2.1, 18); so they do with the sign reversed and "
        "covariances at the truth.",
    )


def _trajectories(axes: Axes, rows: Table) -> None:
    for period, colour in PERIOD_COLOURS.items():
        for direction in DIRECTIONS:
            chosen = rows.where(period_s=period, direction=direction)
            one, two = (
                np.maximum.accumulate(np.abs(chosen.where(azimuth_std_deg=d).column("delta_x_percent")))
                for d in DEGREES
            )
            dots = [n - 1 for n in (5, 10, 20, 40) if n <= len(one)]
            line = "-" if direction == "away" else "--"
            axes.plot(one, two, color=colour, linestyle=line, marker="o", markersize=3, markevery=dots, linewidth=1.1)
    mark(axes, PRINTED[1], PRINTED[2], "")
    axes.set_xlim(0, 6)
    axes.set_ylim(0, 40)


def _errors(rows: Table) -> Picture:
    with drawing(7.2, 5.4) as figure:
        grid = figure.subplots(2, 2, sharex=True)
        for column, degrees in enumerate(DEGREES):
            for name, style in METHODS.items():
                if name in {"averaged", "reversed"}:
                    continue  # they lie on "unbiased"
                chosen = rows.where(azimuth_std_deg=degrees, method=name)
                _band(grid[0, column], chosen, "rmse_x_m", style)
                _band(grid[1, column], chosen, "nees", style)
            grid[0, column].set_title(f"σᵦ = {degrees}°")
            grid[0, column].set_ylim(90, 350)
            grid[1, column].axhline(1, color=BLACK, linewidth=0.8, linestyle=":")
            grid[1, column].set_ylim(0.8, 2.5)
            _cycles(grid[1, column])
        grid[0, 0].set_ylabel("root mean square error of x [m]")
        grid[1, 0].set_ylabel("NEES per coordinate")
        figure.legend(*grid[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=3)
    return Picture(
        "prosov_methods",
        figure,
        "Errors of x, and how well the filter knows its own errors (average normalised error squared per coordinate, "
        "1 if right), in the setting of figures 1 and 2. Averaged and sign reversed lie on unbiased. Shaded: 95 % "
        "intervals.",
        "Four panels. At 2° the error of x after 20 cycles is least for (10) as printed and posterior, then "
        "decorrelated, then linear, and largest for unbiased; the normalised error stays near 1 for decorrelated and "
        "(10) as printed, and grows above 2 for linear and unbiased.",
    )
