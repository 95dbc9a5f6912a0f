"""The figures of the reproduction of Gao, Dong and Zhang, drawn from its tables."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from radartrack._arrays.validation import RealArray
from radartrack.reproduction.gao import SOURCES, TRUE_STD
from radartrack.reproduction.pictures import BLACK, BLUE, GREEN, ORANGE, PURPLE, RED, SKY, Picture, drawing
from radartrack.reproduction.results import Reproduction, Table

RADAR_COLOURS = (BLUE, ORANGE, GREEN, PURPLE)
LINES = {"propagated": (BLACK, "--"), "printed": (RED, "-."), "consistent": (SKY, ":")}
STYLES = {
    "equal": (BLACK, "o"), "stated": (PURPLE, "v"), "propagated": (BLUE, "s"),
    "printed": (RED, "^"), "consistent": (GREEN, "D"), "covariance": (ORANGE, "X"),
}  # fmt: skip


def pictures(found: Reproduction) -> Iterator[Picture]:
    """All figures, in the order in which they are read."""
    yield _scene(found.tables["figure_1"])
    yield _fusion(found.tables["fusion"])
    yield _deviation(found.tables["deviation_9"])


def _scene(rows: Table) -> Picture:
    with drawing(7.2, 4.6) as figure:
        left, right = figure.subplots(1, 2)
        left.set_aspect("equal", adjustable="datalim")
        for n, colour in enumerate(RADAR_COLOURS, start=1):
            x, y = _coordinates(rows, f"site of radar {n}")
            left.plot(x, y, color=colour, marker="P", ls="none", markersize=9)
            left.annotate(f"{n}", (x[0], y[0]), textcoords="offset points", xytext=(7, 3), color=colour)
            right.plot(*_along_and_across(rows, f"plots of radar {n}"), color=colour, marker=".", ls="none", ms=4,
                       label=f"plots of radar {n}")  # fmt: skip
        left.plot(*_coordinates(rows, "flight"), color=BLACK, linewidth=3, alpha=0.3, label="flight")
        for source, (colour, line) in LINES.items():
            right.plot(
                *_along_and_across(rows, f"line by {source}"), color=colour, linestyle=line, label=SOURCES[source]
            )
        right.axhline(0, color=BLACK, linewidth=3, alpha=0.3)
        left.set_xlabel("x [km]")
        left.set_ylabel("y [km]")
        left.set_title("radars (crosses) and flight")
        right.set_xlabel("along the flight [km]")
        right.set_ylabel("to the left of the flight [m]")
        right.set_title("plots and fused lines")
        figure.legend(loc="outside lower center", ncols=4)
    return Picture(
        "gao_figure_1",
        figure,
        "One run of a scene like figure 1 of Gao et al.: four radars, two of them (2 and 4) without elevation, a "
        "straight flight at 8 km height, and the lines fused with weights from error propagation and from scatter.",
        "Left, a map of four radar sites about a straight flight. Right, plots scattered by some hundred metres to "
        "both sides of the flight, and three fused lines within 200 m of it.",
    )


def _coordinates(rows: Table, what: str) -> tuple[RealArray, RealArray]:
    chosen = rows.where(what=what)
    return chosen.column("x_km"), chosen.column("y_km")


def _along_and_across(rows: Table, what: str) -> tuple[RealArray, RealArray]:
    """Distance along the flight [km] and to the left of it [m]."""
    flight_x, flight_y = _coordinates(rows, "flight")
    x, y = _coordinates(rows, what)
    course = np.array([flight_x[-1] - flight_x[0], flight_y[-1] - flight_y[0]])
    east, north = course / np.hypot(*course)
    return (x - flight_x[0]) * east + (y - flight_y[0]) * north, 1e3 * (
        (y - flight_y[0]) * east - (x - flight_x[0]) * north
    )


def _fusion(rows: Table) -> Picture:
    situations = list(dict.fromkeys(rows.columns["situation"]))
    with drawing(7.2, 4.0) as figure:
        axes = figure.subplots()
        for shift, (source, (colour, marker)) in zip(np.linspace(-0.3, 0.3, len(STYLES)), STYLES.items(), strict=True):
            chosen = rows.where(weights=source)
            value = chosen.column("rmse_m")
            ends = np.abs(np.stack([chosen.column("rmse_m_lower"), chosen.column("rmse_m_upper")]) - value)
            axes.errorbar(
                np.arange(len(situations)) + shift,
                value,
                yerr=ends,
                color=colour,
                marker=marker,
                ls="none",
                label=SOURCES[source],
            )
        axes.set_xticks(np.arange(len(situations)), [str(name) for name in situations])
        axes.grid(visible=False, axis="x")
        axes.set_ylim(0, None)
        axes.set_ylabel("root mean square error of the fused line [m]")
        figure.legend(loc="outside lower center", ncols=3, title="weights from")
    return Picture(
        "gao_fusion",
        figure,
        "Error of the fused line by where the weights of the radars come from, in four situations. Bars: 95 % "
        "intervals. The paper finds scatter slightly better than error propagation and gives no numbers: here that "
        "holds where radars are aged or lack elevation, and not where they are as stated.",
        _said(rows),
    )


def _said(rows: Table) -> str:
    lines = []
    for situation in dict.fromkeys(rows.columns["situation"]):
        chosen = rows.where(situation=situation)
        values = ", ".join(
            f"{SOURCES[str(source)]} {value:.0f} m"
            for source, value in zip(chosen.columns["weights"], chosen.column("rmse_m"), strict=True)
        )
        lines.append(f"{situation}: {values}")
    return f"Errors by source of the weights. {'; '.join(lines)}."


def _deviation(rows: Table) -> Picture:
    speed = np.maximum(rows.column("speed_m_s"), 0.03)
    with drawing(7.2, 3.9) as figure:
        axes = figure.subplots()
        axes.axhline(TRUE_STD, color=BLACK, linewidth=0.8, label="true σ")
        axes.plot(speed, rows.column("consistent_m"), color=BLUE, marker="s", ls="none", label="consistent estimate")
        axes.plot(speed, rows.column("printed_m"), color=RED, marker="o", ls="none", label="(9) as printed, simulated")
        axes.plot(speed, rows.column("derived_m"), color=RED, linestyle="--", label="(9), derived for many plots")
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xticks([0.03, 0.1, 1, 10, 100, 1000], ["0", "0.1", "1", "10", "100", "1000"])
        axes.set_xlabel("speed of the target along x [m/s]")
        axes.set_ylabel("mean estimate of σₓ [m]")
        figure.legend(loc="outside lower center", ncols=2)
    return Picture(
        "gao_deviation_9",
        figure,
        f"What (9) measures for σ = {TRUE_STD:g} m over the speed of the target (metres and seconds, 100 plots): "
        "0.603 σ for a target that stands, and ever less the faster it flies. The 95 % intervals are smaller than "
        "the dots.",
        "Log-log plot: the consistent estimate stays at 100 m; that of (9) falls from 60 m at rest to 0.3 m at 200 "
        "m/s and 0.06 m at 1000 m/s, on the derived curve.",
    )
