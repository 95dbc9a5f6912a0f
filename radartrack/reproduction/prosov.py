"""Prosov: what the correction (10) and the covariance (11) do to a Kalman filter, figures 1 and 2.

The paper gives the range, the speed, the deviations and 1000 trials; the period T₀, the number of cycles and the
direction of the flight are not legible. `reproduce` maps which of them give the paper's two numbers.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import product
from typing import NamedTuple

import numpy as np

from radartrack._arrays import repeated_trials
from radartrack._arrays.repeated_trials import Estimate
from radartrack._arrays.validation import RealArray
from radartrack.reproduction import tracking
from radartrack.reproduction.results import (
    Cell,
    Finding,
    Reproduction,
    Step,
    Table,
    columns,
    interval,
    number,
    silent,
    table,
)
from radartrack.reproduction.tracking import CONVERSIONS, Scene, Tracked, Weighting, scene

TITLE = "Prosov: linearisation and the accuracy of a tracking filter"
DEGREES = (1, 2)
TRIALS, MAPPED_TRIALS = 20_000, 2_000
PRINTED = {1: 2.1, 2: 18.0}
PERIOD, CYCLES, OUTWARD = 10.0, 20, 1
PERIODS = (2.0, 5.0, 10.0, 20.0)
DIRECTIONS = {"away": 1, "towards": -1}
MAPPED_CYCLES = 40
NEAREST = 30e3
PAPER_TRIALS = 1000
VERSIONS = ("printed", "reversed")
WEIGHTINGS: tuple[Weighting, ...] = ("measurement", "prediction", "truth")
SEPARATED = ("linear", "printed", "reversed", "unbiased", "posterior")


class Fit(NamedTuple):
    """The number of cycles that comes closest to both numbers of the paper, and those that fit both."""

    closest: int
    distance: float
    fitting: list[int]


def reproduce(
    trials: int = TRIALS, mapped_trials: int = MAPPED_TRIALS, seed: int = 0, step: Step = silent
) -> Reproduction:
    """Run all experiments.

    Args:
        trials: of the figures and of the separation of both biases.
        mapped_trials: of each point of the map.
        seed: of the simulations.
        step: called before each part.

    """
    runs = dict(_runs(trials, seed, step))
    tables = {
        "figures_1_2": _figures(runs),
        "two_biases": _two_biases(trials, seed, step),
        "map": _map(mapped_trials, seed, step),
    }
    tables["map_fits"] = _fits(tables["map"], mapped_trials)
    step("Prosov: F as printed")
    findings = (*_findings(tables, trials), _printed_transition(trials // 10, seed))
    found = _found(tables["figures_1_2"])
    return Reproduction("prosov", TITLE, tables, findings, found, f"prosov_figure_{DEGREES[-1]}")


def _found(rows: Table) -> str:
    """What the figures show, in a sentence or two."""
    last = rows.where(azimuth_std_deg=DEGREES[-1])
    printed, right = (last.where(method=version).column("delta_x_percent")[-1] for version in VERSIONS)
    return (
        "The bias correction (10) is printed with the wrong sign, and as printed it changes the filter’s error of x by "
        f"{number(printed)} % at {DEGREES[-1]}°; with the sign put right, by {number(right)} %. Plots that are weighed "
        "by covariances computed from themselves add a bias of their own, which the wrong sign takes away."
    )


def figure(degrees: int, trials: int = TRIALS, seed: int = 0) -> Iterator[tuple[str, Tracked]]:
    """Figure 1 (1 degree) or 2 (2 degrees): the tracks of every conversion, from the same plots.

    Args:
        degrees: deviation of the azimuth.
        trials: number of trials.
        seed: of the simulation.

    """
    view = scene(PERIOD, math.radians(degrees), OUTWARD, CYCLES, trials, seed)
    for name, conversion in CONVERSIONS.items():
        yield name, tracking.track(view, conversion)
    yield "decorrelated", tracking.track_decorrelated(view)
    yield "handed over", tracking.track_handed_over(view)


def _runs(trials: int, seed: int, step: Step) -> Iterator[tuple[tuple[int, str], Tracked]]:
    for degrees in DEGREES:
        step(f"Prosov: figure {degrees}")
        for name, tracked in figure(degrees, trials, seed):
            yield (degrees, name), tracked


def _figures(runs: Mapping[tuple[int, str], Tracked]) -> Table:
    rows = []
    for (degrees, name), tracked in runs.items():
        squares, reference = tracked.error**2, runs[degrees, "linear"].error ** 2
        change = repeated_trials.root_excess(squares[..., 0], reference[..., 0])
        error, bias = repeated_trials.root_mean(squares), repeated_trials.mean(tracked.error[..., 0])
        nees = repeated_trials.mean(tracked.nees)
        for n in range(CYCLES):
            row: dict[str, Cell] = {"azimuth_std_deg": degrees, "method": name, "cycle": n + 1}
            row |= columns("delta_x_percent", change, n, 100.0)
            row |= columns("rmse_x_m", error, (n, 0)) | columns("rmse_y_m", error, (n, 1))
            rows.append(row | columns("bias_x_m", bias, n) | columns("nees", nees, n))
    return table(rows)


def _two_biases(trials: int, seed: int, step: Step) -> Table:
    """Bias of x after the last cycle over r sigma^2, by conversion and by where its covariance is evaluated."""
    rows = []
    for degrees in DEGREES:
        view = scene(PERIOD, math.radians(degrees), OUTWARD, CYCLES, trials, seed)
        unit = float(view.position[-1, 0]) * math.radians(degrees) ** 2
        for name in SEPARATED:
            step(f"Prosov: two biases, {name}")
            plot = CONVERSIONS[name].position(view.plots)[:, -1, 0] - view.position[-1, 0]
            row: dict[str, Cell] = {"azimuth_std_deg": degrees, "conversion": name, "r_sigma2_m": unit}
            row |= columns("one_plot", repeated_trials.mean(plot), (), 1 / unit)
            for weighting in WEIGHTINGS:
                error = tracking.track(view, CONVERSIONS[name], weighting).error[:, -1, 0]
                row |= columns(f"weighed_at_{weighting}", repeated_trials.mean(error), (), 1 / unit)
            rows.append(row)
    return table(rows)


def _map(trials: int, seed: int, step: Step) -> Table:
    """The relative difference for every period, direction, number of cycles, version of (10) and weighting."""
    rows: list[dict[str, Cell]] = []
    for period in PERIODS:
        for direction, sign in DIRECTIONS.items():
            step(f"Prosov: map, T₀ = {period:g} s, {direction}")
            scans = MAPPED_CYCLES if sign > 0 else min(MAPPED_CYCLES, int((150e3 - NEAREST) / (200 * period)) + 1)
            for degrees in DEGREES:
                view = scene(period, math.radians(degrees), sign, scans, trials, seed)
                place: dict[str, Cell] = {"period_s": period, "direction": direction, "azimuth_std_deg": degrees}
                rows += [place | row for row in _differences(view)]
    return table(rows)


def _differences(view: Scene) -> Iterator[dict[str, Cell]]:
    for weighting in WEIGHTINGS:
        reference = tracking.track(view, CONVERSIONS["linear"], weighting).error[..., 0] ** 2
        for version in VERSIONS:
            squares = tracking.track(view, CONVERSIONS[version], weighting).error[..., 0] ** 2
            change = repeated_trials.root_excess(squares, reference)
            for n in range(squares.shape[1]):
                row: dict[str, Cell] = {"weighting": weighting, "version": version, "cycle": n + 1}
                yield row | columns("delta_x_percent", change, n, 100.0)


def _fits(mapped: Table, trials: int) -> Table:
    rows: list[dict[str, Cell]] = []
    for weighting, version, period, direction in product(WEIGHTINGS, VERSIONS, PERIODS, DIRECTIONS):
        place: dict[str, Cell] = {
            "weighting": weighting,
            "version": version,
            "period_s": period,
            "direction": direction,
        }
        rows.append(place | _fit_row(mapped.where(**place), trials))
    return table(rows)


def _fit_row(chosen: Table, trials: int) -> dict[str, Cell]:
    found = fit(chosen, trials)
    row: dict[str, Cell] = {"closest_cycles": found.closest, "distance": found.distance}
    for degrees in DEGREES:
        largest = _largest(chosen.where(azimuth_std_deg=degrees))
        row[f"largest_delta_percent_{degrees}_deg"] = float(largest[found.closest - 1])
    row["first_fitting"] = found.fitting[0] if found.fitting else ""
    row["last_fitting"] = found.fitting[-1] if found.fitting else ""
    return row


def fit(chosen: Table, trials: int) -> Fit:
    """Which numbers of cycles give both of the paper's numbers.

    The distance is the root mean square of both differences, each over the standard error of a difference from the
    paper's 1000 trials and ours, with the same plots for both filters. A number of cycles fits where both differences
    are within the 95 % interval.

    Args:
        chosen: rows of the map for one period, direction, version and weighting.
        trials: that the rows rest on.

    """
    distances = []
    for degrees in DEGREES:
        rows = chosen.where(azimuth_std_deg=degrees)
        half = (rows.column("delta_x_percent_upper") - rows.column("delta_x_percent_lower")) / 2
        tolerance = half * _with_the_papers_trials(trials)
        distances.append((_largest(rows) - PRINTED[degrees]) / np.maximum(tolerance, 0.05))
    away = np.abs(np.stack(distances))
    together = np.sqrt((away**2).mean(axis=0))
    closest = int(np.argmin(together))
    return Fit(closest + 1, float(together[closest]), [int(n) + 1 for n in np.flatnonzero((away <= 1).all(axis=0))])


def _with_the_papers_trials(trials: int) -> float:
    """By how much the interval of the difference from the paper's own trials is wider than that of ours."""
    return math.sqrt(1 + trials / PAPER_TRIALS)


def _largest(rows: Table) -> RealArray:
    """The largest absolute value of the difference up to each cycle."""
    largest: RealArray = np.maximum.accumulate(np.abs(rows.column("delta_x_percent")))
    return largest


def _findings(tables: Mapping[str, Table], trials: int) -> Iterator[Finding]:
    figures = tables["figures_1_2"]
    for degrees, said in ((1, "at most 2.1 %"), (2, "up to 18 %")):
        for name in ("printed", "reversed", "averaged", "unbiased", "posterior", "decorrelated", "handed over"):
            rows = figures.where(azimuth_std_deg=degrees, method=name)
            yield _difference(rows, degrees, name, said, trials)
    for degrees in DEGREES:
        yield _growth(figures.where(azimuth_std_deg=degrees, method="printed"), degrees)
    yield from _biases(tables["two_biases"].where(azimuth_std_deg=2))
    yield from _combinations(tables["map_fits"])


_NAMES = {
    "linear": "(8), (9)",
    "printed": "(10) as printed, (11)",
    "reversed": "(10) with the sign reversed, (11)",
    "averaged": "averaged",
    "unbiased": "unbiased",
    "posterior": "posterior",
    "decorrelated": "decorrelated, covariance from the prediction",
    "handed over": "posterior for five plots, then decorrelated",
}


def _difference(rows: Table, degrees: int, name: str, said: str, trials: int) -> Finding:
    value, lower, upper = (rows.column(f"delta_x_percent{end}")[-1] for end in ("", "_lower", "_upper"))
    tolerance = (upper - lower) / 2 * _with_the_papers_trials(trials)
    agrees = abs(abs(value) - PRINTED[degrees]) <= tolerance
    return Finding(
        f"Δx after {CYCLES} cycles of {PERIOD:g} s away from the radar, σᵦ = {degrees}°: {_NAMES[name]}",
        said if name == "printed" else f"({said}, of (10) and (11))",
        f"{number(value)} %",
        interval(Estimate(value, lower, upper)),
        "agrees" if agrees else "differs",
        "within what 1000 trials can tell" if agrees else "",
    )


def _growth(rows: Table, degrees: int) -> Finding:
    change = rows.column("delta_x_percent")
    turn = int(np.argmax(change))
    grows = bool((np.diff(change[4::5]) < 0).all())
    return Finding(
        f"|Δx| over the cycles, σᵦ = {degrees}°: (10) as printed, (11)",
        "grows with the number of cycles",
        f"{number(change[turn])} % at cycle {turn + 1}, falling to {number(change[-1])} % at cycle {CYCLES}",
        "",
        "depends" if grows else "differs",
        "grows only after it has changed sign: at first (10) as printed is worse than (8)" if grows else "",
    )


def _biases(rows: Table) -> Iterator[Finding]:
    """What the paper calls unbiased: one plot, and the filter that weighs plots by covariances from themselves."""
    places = {"one_plot": "one plot", "weighed_at_measurement": f"filter after {CYCLES} cycles, own covariances"}
    for place, said in places.items():
        for name in ("linear", "printed", "reversed"):
            row = rows.where(conversion=name)
            value, lower, upper = (float(row.column(f"{place}{end}")[0]) for end in ("", "_lower", "_upper"))
            agrees = lower <= 0 <= upper
            yield Finding(
                f"Bias of x over r σᵦ² ({row.column('r_sigma2_m')[0]:.0f} m), σᵦ = 2°, {said}: {_NAMES[name]}",
                "biased" if name == "linear" else "(10) is unbiased",
                number(value, 3),
                f"[{number(lower, 3)}, {number(upper, 3)}]",
                "agrees" if agrees != (name == "linear") else "differs",
            )


def _combinations(fits: Table) -> Iterator[Finding]:
    for weighting in WEIGHTINGS:
        for version in VERSIONS:
            rows = fits.where(weighting=weighting, version=version).records()
            fitting = [_fitting(row) for row in rows if row["first_fitting"] != ""]
            yield Finding(
                f"T₀, direction and cycles that give both numbers: {_NAMES[version]}, covariance at the {weighting}",
                "not legible",
                f"cycles {'; '.join(fitting)}" if fitting else "none",
                "",
                "depends" if fitting else "differs",
            )


def _fitting(row: Mapping[str, Cell]) -> str:
    first, last = row["first_fitting"], row["last_fitting"]
    return f"{row['period_s']:g} s {row['direction']}: {first if first == last else f'{first}–{last}'}"


def _printed_transition(trials: int, seed: int) -> Finding:
    view = scene(PERIOD, math.radians(1), OUTWARD, CYCLES, max(trials, 2), seed)
    error = tracking.track(view, CONVERSIONS["linear"], moves=tracking.motion_as_printed(PERIOD)).error[:, -1, 0]
    found = repeated_trials.root_mean(error**2)
    return Finding(
        f"Root mean square error of x after {CYCLES} cycles with F as printed, σᵦ = 1°",
        "second row of F: 1 1 0 0",
        f"{number(float(found.value), 0)} m",
        interval(found, digits=0),
        "differs",
        "the filter loses the target, so the simulation behind the figures had 0 1 0 0",
    )
