"""Gao, Dong and Zhang: the fusion of figure 1, and what the deviation (9) measures.

The paper shows its radars and tracks in a picture alone. The situations here are this project's
(`radartrack.straight_flight`); each changes one thing.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from radartrack import line, straight_flight
from radartrack._arrays import repeated_trials
from radartrack._arrays.repeated_trials import Estimate
from radartrack._arrays.validation import RealArray
from radartrack.generated import fusion as formulas
from radartrack.generated import line as line_formulas
from radartrack.reproduction.results import (
    Cell,
    Finding,
    Reproduction,
    Step,
    Table,
    Verdict,
    columns,
    interval,
    number,
    silent,
    table,
)
from radartrack.simulate import Radar, Seed, Straight, plots
from radartrack.straight_flight import DURATION, EVALUATED, FLIGHT, Comparison, situations

TITLE = "Gao, Dong and Zhang: two methods for the variance of radar measurements"
RUNS, TRACKS = 2000, 1000
SPEEDS = (0.0, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 200.0, 300.0, 1000.0)
TRUE_STD = 100.0
PLOTS_OF_A_TRACK = 100
PERIOD = 5.0
SPOKEN_OF = 200.0
SOURCES = {
    "equal": "none (equal)",
    "stated": "stated deviations",
    "propagated": "error propagation",
    "printed": "scatter, (3) to (10)",
    "consistent": "scatter, consistent",
    "covariance": "covariance of each plot",
}


def reproduce(runs: int = RUNS, tracks: int = TRACKS, seed: int = 0, step: Step = silent) -> Reproduction:
    """Run all experiments.

    Args:
        runs: of each situation of the fusion.
        tracks: at each speed of what (9) measures.
        seed: of the simulations.
        step: called before each part.

    """
    compared: dict[str, Comparison] = {}
    for name, stations in situations().items():
        step(f"Gao: fusion, {name}")
        compared[name] = straight_flight.compare(stations, runs=runs, seed=seed)
    tables = {
        "fusion": _fusion(compared),
        "figure_1": _one_run((seed, 1)),
        "deviation_9": _deviation(tracks, seed, step),
    }
    findings = (*_examples(), *_fusions(compared), *_deviations(tables["deviation_9"]))
    return Reproduction("gao", TITLE, tables, findings, _found(tables["deviation_9"]), "gao_deviation_9")


def _found(rows: Table) -> str:
    """What the figure shows, in a sentence or two."""
    speeds, estimates = rows.column("speed_m_s"), rows.column("printed_m")
    return (
        f"(9) does not measure the deviation: of {TRUE_STD:g} m it makes {number(estimates[0])} m at "
        f"{speeds[0]:g} m/s and {number(estimates[-1], 3)} m at {speeds[-1]:g} m/s. Whether fusing by scatter is "
        "better than by error propagation depends on the situation, which the paper does not give."
    )


def _fusion(compared: Mapping[str, Comparison]) -> Table:
    rows: list[dict[str, Cell]] = []
    for situation, found in compared.items():
        for source in SOURCES:
            row: dict[str, Cell] = {"situation": situation, "weights": source}
            row |= columns("rmse_m", found.rmse[source])
            rows.append(row | columns("excess_percent", found.excess[source], (), 100.0))
    return table(rows)


def _one_run(seed: Seed) -> Table:
    """One run with two radars without elevation: the flight, the plots and the fused lines, for the picture."""
    stations = situations()["no elevation"]
    seen = [straight_flight.plots_of(station, 1, (*np.atleast_1d(seed), n)) for n, station in enumerate(stations)]
    rows: list[dict[str, Cell]] = []
    for n, (station, own) in enumerate(zip(stations, seen, strict=True), start=1):
        rows += _points(f"site of radar {n}", np.array([station.site]))
        rows += _points(f"plots of radar {n}", np.stack([own.x[0], own.y[0]], axis=-1))
    times = np.linspace(0.0, DURATION, EVALUATED)
    rows += _points("flight", FLIGHT.states(times)[:, :2])
    for source in ("propagated", "printed", "consistent"):
        rows += _points(f"line by {source}", straight_flight.fused(source, stations, seen).at(times)[0])
    return table(rows)


def _points(what: str, points: RealArray) -> list[dict[str, Cell]]:
    return [{"what": what, "x_km": float(x) / 1e3, "y_km": float(y) / 1e3} for x, y in points]


def _deviation(tracks: int, seed: int, step: Step) -> Table:
    rows: list[dict[str, Cell]] = []
    radar = Radar("polar", PERIOD, {"range_std": TRUE_STD, "azimuth_std": 0.0})
    for speed in SPEEDS:
        step(f"Gao: (9) at {speed:g} m/s")
        target = Straight((50e3, 0.0), (speed, 0.0))
        seen = plots(target, radar, scans=PLOTS_OF_A_TRACK, trials=tracks, seed=seed)
        row: dict[str, Cell] = {"speed_m_s": speed, "true_m": TRUE_STD}
        methods: Sequence[line.StdMethod] = ("printed", "consistent")
        for method in methods:
            found = line.measurement_std(seen.t, seen.measured["r"], seen.measured["r"], method).x
            row |= columns(f"{method}_m", repeated_trials.mean(found))
        row["derived_m"] = float(line_formulas.motion_printed_std(sigma_x=TRUE_STD, v=speed, c=1.0))
        rows.append(row)
    return table(rows)


def _examples() -> Iterator[Finding]:
    for kilometres, printed in ((50, 873), (500, 8730)):
        ours = float(formulas.cross_range_std(r=kilometres * 1e3, sigma_beta=np.radians(1.0)))
        verdict: Verdict = "agrees" if f"{ours:.3g}" == f"{printed:.3g}" else "differs"
        yield Finding(f"Error across, 1° at {kilometres} km", f"{printed} m", f"{number(ours)} m", "", verdict)


_BETTER = "the statistical method is slightly better"


def _fusions(compared: Mapping[str, Comparison]) -> Iterator[Finding]:
    for situation, found in compared.items():
        for source in ("printed", "consistent"):
            excess = found.excess[source]
            yield Finding(
                f"Mean square error of the fused line over that with error propagation: {situation}, {SOURCES[source]}",
                _BETTER,
                f"{number(100 * float(excess.value))} %",
                interval(excess, scale=100),
                _sign(excess),
                "the paper gives neither its radars nor its numbers",
            )


def _sign(excess: Estimate) -> Verdict:
    if excess.upper < 0:
        return "agrees"
    return "differs" if excess.lower > 0 else "depends"


def _deviations(found: Table) -> Iterator[Finding]:
    for speed in (0.0, SPOKEN_OF):
        rows = found.where(speed_m_s=speed)
        value, lower, upper = (float(rows.column(f"printed_m{end}")[0]) for end in ("", "_lower", "_upper"))
        yield Finding(
            f"What (9) gives for σ = {TRUE_STD:g} m, target at {speed:g} m/s along x",
            "the standard deviation of x",
            f"{number(value, 3)} m",
            f"[{number(lower, 3)}, {number(upper, 3)}]",
            "agrees" if lower <= TRUE_STD <= upper else "differs",
            f"derived: {number(float(rows.column('derived_m')[0]), 3)} m, for many plots",
        )
