"""Gorshkov and Zavizhenets: errors and gains of the finite-sample filter for six radars, figures 1 to 3, a and b."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from radartrack._arrays.validation import RealArray
from radartrack.finite_sample_experiment import COMPONENTS, Comparison, Errors, compare, radial_radar
from radartrack.finite_sample_filter import FiniteSampleFilter
from radartrack.reproduction.results import (
    Cell,
    Finding,
    Reproduction,
    Step,
    Table,
    Verdict,
    number,
    silent,
    table,
)
from radartrack.simulate import Radar

TITLE = "Gorshkov and Zavizhenets: filtering over a finite sample with range and range rate"
SCANS = 20
TRIALS = 100_000
UNITS = {"range": "m", "speed": "m/s", "acceleration": "m/s²"}
SHOWN = 3
"""The radar of the parts a of the figures."""
RADARS: Mapping[int, Radar] = {
    1: radial_radar(250.0, 35.0, 10.0),
    2: radial_radar(250.0, 25.0, 10.0),
    3: radial_radar(250.0, 15.0, 10.0),
    4: radial_radar(250.0, 15.0, 5.0),
    5: radial_radar(50.0, 1.0, 10.0),
    6: radial_radar(50.0, 1.0, 5.0),
}
PRINTED_C = {1: "0.51", 2: "1", 3: "2.78", 4: "11.01", 5: "25", 6: "100"}
FALSE_ALARM = 1e-6
BAND = "band that a right formula leaves once in a million"


def reproduce(trials: int = TRIALS, seed: int = 0, step: Step = silent) -> Reproduction:
    """Run all experiments.

    Args:
        trials: of each radar; the paper's number.
        seed: of the simulations.
        step: called before each part.

    """
    compared = {}
    for name, radar in RADARS.items():
        step(f"Gorshkov: radar {name}")
        compared[name] = compare(radar, scans=SCANS, trials=trials, seed=(seed, name), false_alarm=FALSE_ALARM)
    tables = {"errors": _errors(compared), "gains": _gains(compared)}
    findings = tuple(_findings(compared))
    return Reproduction("gorshkov", TITLE, tables, findings, _found(findings), "gorshkov_figure_1")


def _found(findings: Sequence[Finding]) -> str:
    """What the figures show, in a sentence or two."""
    agree = sum(finding.verdict == "agrees" for finding in findings)
    wrong = (finding.what for finding in findings if finding.verdict != "agrees")
    others = "; ".join(what[0].lower() + what[1:] for what in wrong)
    rest = f" What differs: {others}." if others else ""
    return f"{agree} of {len(findings)} statements hold, by simulation and by the closed forms.{rest}"


def coefficient(radar: Radar) -> float:
    """C of a radar, the weight of its range rate."""
    return FiniteSampleFilter(radar.period, radar.noise["range_std"], radar.noise["range_rate_std"]).C


def _errors(compared: Mapping[int, Comparison]) -> Table:
    rows: list[dict[str, Cell]] = []
    for radar, found in compared.items():
        for name, errors in (("range", found.without), ("range and rate", found.with_rate)):
            for place, component in enumerate(COMPONENTS):
                for k in range(SCANS):
                    row: dict[str, Cell] = {"radar": radar, "observed": name, "component": component, "k": k + 1}
                    rows.append(row | {part: float(getattr(errors, part)[k, place]) for part in Errors._fields})
    return table(rows)


def _gains(compared: Mapping[int, Comparison]) -> Table:
    rows: list[dict[str, Cell]] = []
    for radar, found in compared.items():
        low, high = found.gain_band
        parts = {"simulated": found.gain, "closed_form": found.expected_gain, "band_low": low, "band_high": high}
        for place, component in enumerate(COMPONENTS):
            for k in range(SCANS):
                row: dict[str, Cell] = {"radar": radar, "component": component, "k": k + 1}
                rows.append(row | {f"{name}_percent": 100 * float(part[k, place]) for name, part in parts.items()})
    return table(rows)


def _findings(compared: Mapping[int, Comparison]) -> Iterator[Finding]:
    for name, radar in RADARS.items():
        c = coefficient(radar)
        agrees = abs(c - float(PRINTED_C[name])) <= 0.5 * 10.0 ** -len(PRINTED_C[name].partition(".")[2])
        yield Finding(f"C of radar {name}", PRINTED_C[name], number(c, 2), "", "agrees" if agrees else "differs")
    yield _largest_gain(1, compared[1], 20, 3)
    yield _largest_gain(6, compared[6], 55, 9)
    yield from (_first_scan(compared[SHOWN]), _crossing(compared[SHOWN]), _exponential(compared))
    yield _inside(compared)


def _largest_gain(radar: int, found: Comparison, printed: int, printed_k: int) -> Finding:
    gain = found.expected_gain[2:, 0]
    k = int(np.argmax(gain)) + 3
    low, high = (100 * band[k - 1, 0] for band in found.gain_band)
    agrees = round(100 * float(gain.max())) == printed and k == printed_k
    return Finding(
        f"Largest gain in range of radar {radar}",
        f"{printed} % at k = {printed_k}",
        f"{number(100 * gain.max())} % at k = {k} (simulated {number(100 * found.gain[k - 1, 0])} %)",
        f"[{number(low)}, {number(high)}]",
        "agrees" if agrees else "differs",
        BAND if agrees else f"at k = {printed_k}: {number(100 * gain[printed_k - 3])} %; {BAND}",
    )


def _first_scan(found: Comparison) -> Finding:
    single = np.array([RADARS[SHOWN].noise["range_std"], RADARS[SHOWN].noise["range_rate_std"]])
    equal = bool((np.abs(found.with_rate.measured[0, :2] / single - 1) < 0.02).all())
    return Finding(
        f"Error of range and speed of radar {SHOWN} after one scan with range rate",
        "those of one measurement",
        f"{number(found.with_rate.measured[0, 0])} m, {number(found.with_rate.measured[0, 1], 2)} m/s",
        f"[{number(found.with_rate.low[0, 0])}, {number(found.with_rate.high[0, 0])}] m",
        "agrees" if equal else "differs",
        BAND,
    )


def _crossing(found: Comparison) -> Finding:
    speed = found.without.measured[:, 1]
    below = int(np.argmax(speed[2:] < RADARS[SHOWN].noise["range_rate_std"])) + 3
    verdict: Verdict = "agrees" if below == 8 else "differs"
    return Finding(
        f"Scans after which range alone gives the speed of radar {SHOWN} as well as one measured rate",
        "7–8",
        f"between {below - 1} ({number(speed[below - 2])} m/s) and {below} ({number(speed[below - 1])} m/s)",
        f"[{number(found.without.low[below - 1, 1])}, {number(found.without.high[below - 1, 1])}] m/s at {below}",
        verdict,
        BAND,
    )


def _exponential(compared: Mapping[int, Comparison]) -> Finding:
    largest = [100 * float(np.max(found.expected_gain[2:, 0])) for found in compared.values()]
    slopes = np.diff(largest) / np.diff([coefficient(radar) for radar in RADARS.values()])
    falls = bool((np.diff(slopes) < 0).all())
    said = ", ".join(f"{number(gain, 0)} % at C = {coefficient(RADARS[n]):.3g}" for n, gain in enumerate(largest, 1))
    return Finding(
        "Largest gain in range over C",
        "grows exponentially with C",
        said,
        "",
        "differs" if falls else "agrees",
        "it grows ever more slowly, and stays below 2/3 for every C" if falls else "",
    )


def _inside(compared: Mapping[int, Comparison]) -> Finding:
    outside = [name for name, found in compared.items() if not (found.without.inside and found.with_rate.inside)]
    widest = max(float(np.nanmax(_width(errors))) for found in compared.values() for errors in found[:2])
    return Finding(
        "Simulated errors of all radars, components and scans against the closed forms",
        "formulas (6) to (12), most of them lost",
        "all inside their bands" if not outside else f"outside for radars {outside}",
        f"±{number(50 * widest)} % at most",
        "agrees" if not outside else "differs",
        BAND,
    )


def _width(errors: Errors) -> RealArray:
    width: RealArray = (errors.high - errors.low) / errors.expected
    return width
