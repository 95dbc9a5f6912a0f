"""Writes docs/benchmarks.md from the record of one run: python benchmarks/table.py RECORD.json > docs/benchmarks.md"""

import json
import platform
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

HEAD = """\
# Benchmarks

Every figure is a ratio of two times from one run on one machine: the least of several rounds each, divided by the
plots, tracks or samples that each does. `make bench` repeats the run and writes this page; another machine gives other
ratios.

Measured with {cores} cores ({cpu}), Python {python}, NumPy {numpy}.

| Work | Beside | Ratio | Aim |
|---|---|---|---|
"""


@dataclass(frozen=True)
class Row:
    """One comparison: `ours` and `peer` are tests; `faster` says that the peer should take the longer time."""

    work: str
    beside: str
    ours: str
    peer: str
    aim: str
    faster: bool = False


ROWS = (
    *(
        row
        for method in ("averaged", "unbiased")
        for row in (
            Row(f"`convert.polar`, {method}, 1e6 plots, NumPy alone", "a fused Numba loop, one thread",
                f"test_conversions.py::TestPolar::test_numpy[{method}]", f"TestPolar::test_fused[{method}]", "≤ 1.4"),
            Row(f"`convert.polar`, {method}, 1e6 plots, with `[fast]`", "the same loop",
                f"test_conversions.py::TestPolar::test_fast[{method}]", f"TestPolar::test_fused[{method}]", "≤ 0.25"),
            Row(f"`convert.polar`, {method}, 1e6 plots, with `[fast]`, one core", "the same loop",
                f"TestPolar::test_fast_on_one_core[{method}]", f"TestPolar::test_fused[{method}]", "≤ 0.45"),
            Row(f"`convert.polar`, {method}, 1e6 plots, with `[fast]`, one core", "copying arguments and results",
                f"TestPolar::test_fast_on_one_core[{method}]", "TestCopied::test_polar", "≤ 2.5"),
            Row(f"`convert.polar`, {method}, 1e6 plots, NumPy alone", "FilterPy's unscented transform, plot by plot",
                f"test_conversions.py::TestPolar::test_numpy[{method}]", "TestPolarPeers::test_filterpy",
                "≥ 300 times faster", faster=True),
            Row(f"`convert.polar`, {method}, 1e6 plots, NumPy alone", "Stone Soup's inverse function and Jacobian",
                f"test_conversions.py::TestPolar::test_numpy[{method}]", "TestPolarPeers::test_stone_soup",
                "≥ 2000 times faster", faster=True),
        )
    ),
    Row("`convert.spherical`, unbiased, 1e6 plots, NumPy alone", "a fused Numba loop, one thread",
        "TestSpherical::test_numpy", "TestSpherical::test_fused", "≤ 1.4"),
    Row("`convert.spherical`, unbiased, 1e6 plots, with `[fast]`", "the same loop",
        "TestSpherical::test_fast", "TestSpherical::test_fused", "≤ 0.25"),
    Row("`convert.spherical`, unbiased, 1e6 plots, with `[fast]`, one core", "the same loop",
        "TestSpherical::test_fast_on_one_core", "TestSpherical::test_fused", "≤ 0.45"),
    Row("`convert.spherical`, unbiased, 1e6 plots, with `[fast]`, one core", "copying arguments and results",
        "TestSpherical::test_fast_on_one_core", "TestCopied::test_spherical", "≤ 2.5"),
    Row("`convert.spherical_doppler`, unbiased, 1e6 plots, NumPy alone", "a fused Numba loop, one thread",
        "TestSphericalDoppler::test_numpy", "TestSphericalDoppler::test_fused", "≤ 2.0"),
    Row("`convert.spherical_doppler`, unbiased, 1e6 plots, with `[fast]`", "the same loop",
        "TestSphericalDoppler::test_fast", "TestSphericalDoppler::test_fused", "≤ 0.7"),
    Row("C, `radartrack_convert_polar_unbiased_n`, 1e6 plots", "the same formulas in a loop of C by hand, one thread",
        "TestCPolar::test_ours", "TestCPolar::test_by_hand", "≤ 1.0"),
    Row("C, `radartrack_convert_polar_unbiased_n`, 1e6 plots", "as printed, without correlation; digits cancel",
        "TestCPolar::test_ours", "TestCPolar::test_as_printed", "–"),
    Row("`convert.polar`, one plot", "Stone Soup's",
        "TestOnePlot::test_numpy", "TestOnePlot::test_stone_soup", "≥ 10 times faster", faster=True),
    Row("`FiniteSampleFilter.estimate`, 1e5 tracks of 20 scans", "the bare matrix product",
        "TestEstimate::test_radartrack", "TestEstimate::test_bare_product", "≤ 1.3"),
    Row("`FiniteSampleFilter.run` over the same", "FilterPy's LeastSquaresFilter, per update",
        "TestRun::test_radartrack", "TestRun::test_filterpy", "≥ 500 times faster", faster=True),
    Row("`kalman.run`, 1e4 tracks of 100 steps", "the same arithmetic in einsum and matmul",
        "TestKalman::test_radartrack", "TestKalman::test_by_hand", "≤ 1.0"),
    *(
        Row(f"`kalman.update_with`, order {order}, 1e5 tracks", "the same arithmetic in matmul and solve",
            f"TestUpdateWith::test_radartrack[{order}]", f"TestUpdateWith::test_by_hand[{order}]", "≤ 1.5")
        for order in (1, 2)
    ),
    Row("`kalman.update_with`, order 1, 1e5 tracks", "Stone Soup's extended updater, track by track",
        "TestUpdateWith::test_radartrack[1]", "TestUpdateWithPeer::test_stone_soup", "≥ 100 times faster", faster=True),
    *(
        Row(f"`frames.{ours}`, 1e6 positions", beside,
            f"test_frames.py::{test}::test_radartrack", f"test_frames.py::{test}::{peer}", "–")
        for ours, test in (("geodetic_from_ecef", "TestGeodetic"), ("ecef_from_geodetic", "TestEcef"))
        for beside, peer in (("PROJ, by pyproj", "test_proj"), ("pymap3d", "test_pymap3d"))
    ),
    Row("`initiate.one_plot`, `spherical_doppler`, 1e5 tracks", "a linearised start by hand, unchecked",
        "TestStart::test_one_plot", "TestStart::test_one_by_hand", "–"),
    Row("`initiate.two_plots`, `spherical_doppler`, 1e5 tracks", "differences by hand, range rates unused, unchecked",
        "TestStart::test_two_plots", "TestStart::test_two_by_hand", "–"),
    Row("`observe.spherical_doppler`, 1e5 states, with both derivatives", "Stone Soup's function and Jacobian",
        "TestObserve::test_radartrack", "TestObserve::test_stone_soup", "≥ 100 times faster", faster=True),
    Row("`kalman.predict`, 1e5 tracks in space", "F P F' + Q in matmul, unchecked",
        "TestPredict::test_radartrack", "TestPredict::test_by_hand", "–"),
    Row("`fusion.fuse`, 1e5 times three measurements in space", "inverses of the covariances, unchecked",
        "TestFuse::test_radartrack", "TestFuse::test_by_hand", "–"),
    Row("`fusion.covariance_intersection`, 1e5 pairs of four components", "SciPy's bounded search, pair by pair",
        "TestIntersection::test_radartrack", "TestIntersection::test_scipy", "≥ 10 times faster", faster=True),
    Row("`fusion.registration`, three radars, 200 targets", "SciPy's `least_squares` over all unknowns",
        "TestRegistration::test_radartrack", "TestRegistration::test_scipy", "≥ 20 times faster", faster=True),
    Row("`consistency.nees`, 1e5 errors of six components", "`numpy.linalg.solve`, unchecked",
        "TestNees::test_radartrack", "TestNees::test_by_hand", "–"),
    Row("`fixed_gain.alpha_beta(…).run`, 1e4 tracks of 100 scans", "FilterPy's `GHFilter`, per update",
        "TestFixedGain::test_radartrack", "TestFixedGain::test_filterpy", "≥ 20 times faster", faster=True),
    Row("`simulate.plots`, 1e6 plots of `spherical_doppler`", "drawing the normals alone",
        "TestSimulate::test_radartrack", "TestSimulate::test_normals", "–"),
    Row("`radartrack convert` of 1e6 spherical plots, Parquet to Parquet, with `[fast]`", "copying as many columns",
        "TestParquet::test_radartrack", "TestParquet::test_copied", "≤ 3.0"),
    Row("`stone_soup.OnePlotInitiator`, a scan of 300 plots", "Stone Soup's `SimpleMeasurementInitiator`",
        "TestOneScan::test_radartrack", "TestOneScan::test_stone_soup", "≥ 2 times faster", faster=True),
    Row("Monte Carlo of `polar.covariance.truth`, 8e6 samples, one process, NumPy alone", "drawing the normals alone",
        "TestMonteCarlo::test_numpy", "TestMonteCarlo::test_normals", "–"),
    Row("Monte Carlo of `polar.covariance.truth`, 8e6 samples, one process, with `[fast]`", "the same",
        "TestMonteCarlo::test_machine_code", "TestMonteCarlo::test_normals", "≤ 1.2"),
    Row("deriving and writing `polar.*`", "`simplify` and `lambdify(cse=True)` of the same formulas",
        "TestRegenerate::test_radartrack", "TestRegenerate::test_plain_sympy", "≥ 5 times faster", faster=True),
    Row("`import radartrack` and all that it loads on use, a whole process", "`import numpy`",
        "TestImport::test_radartrack", "TestImport::test_numpy", "≤ 1.3"),
)  # fmt: skip


def main(record: Path) -> None:
    """Print the page."""
    run = json.loads(record.read_text())
    times = {one["fullname"]: one["stats"]["min"] / one["extra_info"]["items"] for one in run["benchmarks"]}
    machine = run["machine_info"]
    print(HEAD.format(
        cores=machine["cpu"].get("count"), cpu=machine["cpu"].get("brand_raw"), python=platform.python_version(),
        numpy=__import__("numpy").__version__,
    ), end="")  # fmt: skip
    for row in ROWS:
        ours, peer = _found(times, row.ours), _found(times, row.peer)
        ratio = f"{peer / ours:,.0f} times faster" if row.faster else f"{ours / peer:.2f}"
        print(f"| {row.work} | {row.beside} | {ratio} | {row.aim} |")
    _others(run)


def _found(times: dict[str, float], name: str) -> float:
    (time,) = (value for full, value in times.items() if full.endswith(name))
    return time


def _others(run: dict[str, Any]) -> None:
    checks = [one for one in run["benchmarks"] if "TestCheck" in one["fullname"]]
    print("\nA check of an entry in a warm process, in seconds:\n")
    for one in checks:
        print(f"- `{one['params']['name']}`: {one['stats']['min']:.3f}")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
