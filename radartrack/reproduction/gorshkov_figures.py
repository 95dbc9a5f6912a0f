"""The figures of the reproduction of Gorshkov and Zavizhenets, drawn from its tables."""

from __future__ import annotations

from collections.abc import Iterator

from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from radartrack.finite_sample_experiment import COMPONENTS
from radartrack.reproduction.gorshkov import RADARS, SCANS, SHOWN, UNITS, coefficient
from radartrack.reproduction.pictures import BLACK, BLUE, GREEN, ORANGE, PURPLE, RED, SKY, Picture, drawing, mark
from radartrack.reproduction.results import Reproduction, Table

RADAR_STYLES = dict(
    zip(RADARS, ((BLACK, "o"), (SKY, "v"), (GREEN, "^"), (ORANGE, "s"), (PURPLE, "D"), (BLUE, "P")), strict=True)
)
OBSERVED = {"range": (BLUE, "s", "--"), "range and rate": (RED, "o", "-")}
HIGHEST = {"range": 300.0, "speed": 45.0, "acceleration": 6.0}


def pictures(found: Reproduction) -> Iterator[Picture]:
    """Figures 1 to 3, each with its parts a and b."""
    for number, component in enumerate(COMPONENTS, start=1):
        yield _figure(found, number, component)


def _figure(found: Reproduction, number: int, component: str) -> Picture:
    errors = found.tables["errors"].where(radar=SHOWN, component=component)
    gains = found.tables["gains"].where(component=component)
    with drawing(7.2, 3.9) as figure:
        left, right = figure.subplots(1, 2)
        _errors(left, errors, component)
        _gains(right, gains)
        if component == "range":
            mark(right, 3, 20, "20 %", (-4, -26))
            mark(right, 9, 55, "55 %", (-4, 8))
        if component == "speed":
            level = RADARS[SHOWN].noise["range_rate_std"]
            left.axhline(level, color=RED, linestyle=(0, (1, 2)), linewidth=1.2)
            left.axvspan(7, 8, color=RED, alpha=0.15, linewidth=0)
            left.annotate("the paper: crossed\nat k = 7–8", (8.2, level + 3), color=RED, fontsize=8)
        keys = [
            Line2D([], [], color=colour, marker=marker, label=f"radar {radar}")
            for radar, (colour, marker) in RADAR_STYLES.items()
        ]
        figure.legend(handles=keys, loc="outside lower center", ncols=6)
    return Picture(
        f"gorshkov_figure_{number}",
        figure,
        f"Gorshkov and Zavizhenets, figure {number}: a, root mean square error of {component} of radar {SHOWN}; b, "
        "what the range rate gains for six radars. Lines: closed forms; markers: simulation; stars and shading: the "
        "paper’s numbers.",
        _said(gains, component),
    )


def _errors(axes: Axes, rows: Table, component: str) -> None:
    for observed, (colour, marker, line) in OBSERVED.items():
        chosen = rows.where(observed=observed)
        k = chosen.column("k")
        axes.plot(k, chosen.column("expected"), color=colour, linestyle=line, label=f"{observed}, closed form")
        axes.plot(k, chosen.column("measured"), color=colour, marker=marker, ls="none", label=f"{observed}, simulated")
    axes.set_ylim(0, HIGHEST[component])
    axes.set_ylabel(f"error of {component} [{UNITS[component]}]")
    axes.set_title(f"a: errors of radar {SHOWN}")
    axes.legend(loc="upper right" if component != "range" else "lower left")
    _scans(axes)


def _gains(axes: Axes, rows: Table) -> None:
    for radar, (colour, marker) in RADAR_STYLES.items():
        chosen = rows.where(radar=radar)
        k = chosen.column("k")
        axes.plot(k, chosen.column("closed_form_percent"), color=colour)
        axes.plot(k, chosen.column("simulated_percent"), color=colour, marker=marker, linestyle="none")
    axes.set_ylim(0, 100)
    axes.set_ylabel("gain by the range rate [%]")
    axes.set_title("b: gains of six radars")
    _scans(axes)


def _scans(axes: Axes) -> None:
    axes.set_xlabel("scan k")
    axes.set_xlim(0.5, SCANS + 0.5)
    axes.set_xticks([1, 5, 10, 15, 20])


def _said(gains: Table, component: str) -> str:
    after_nine = gains.where(k=9)
    at = ", ".join(
        f"radar {radar} (C = {coefficient(RADARS[radar]):.3g}) "
        f"{after_nine.where(radar=radar).column('closed_form_percent')[0]:.0f} %"
        for radar in RADARS
    )
    return f"Errors of {component} fall with the scans, faster with range rate. Gains after nine scans: {at}."
