"""Draws the picture of a conversion for README and documents: `python pictures.py FILE.png`."""

from __future__ import annotations

import sys

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse

import radartrack as rt

RANGE, AZIMUTH, RANGE_STD, AZIMUTH_STD = 100e3, np.deg2rad(20.0), 500.0, np.deg2rad(10.0)
PLOTS = 3000
DEVIATIONS = 2.4477  # of an ellipse that holds 95 % of a Gaussian in the plane
METHODS = {"linear": ("linear", "#c04a00", "--"), "posterior": ("posterior", "#0059a0", "-")}


def main(target: str) -> None:
    """Where a target may be after one plot, and what two conversions say of that."""
    random = np.random.default_rng(1)
    ranges = RANGE + RANGE_STD * random.standard_normal(PLOTS)
    azimuths = AZIMUTH + AZIMUTH_STD * random.standard_normal(PLOTS)
    x, y = ranges * np.sin(azimuths) / 1e3, ranges * np.cos(azimuths) / 1e3
    figure = Figure(figsize=(7.2, 3.4), layout="constrained")
    axes = figure.subplots()
    axes.plot(x, y, ".", color="#9aa0a6", ms=2, label="where the target may be")
    for method, (label, colour, line) in METHODS.items():
        found = rt.convert.polar(
            RANGE, AZIMUTH, range_std=RANGE_STD, azimuth_std=AZIMUTH_STD, azimuth_from="y", method=method
        )
        values, vectors = np.linalg.eigh(found.covariance)
        width, height = 2 * DEVIATIONS * np.sqrt(values) / 1e3
        angle = np.degrees(np.arctan2(vectors[1, 0], vectors[0, 0]))
        axes.add_patch(
            Ellipse(found.mean / 1e3, width, height, angle=angle, fill=False, ec=colour, ls=line, lw=1.8, label=label)
        )
        axes.plot(*(found.mean / 1e3), "+", color=colour, ms=9, mew=1.8)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel("x [km]")
    axes.set_ylabel("y [km]")
    axes.legend(loc="lower left", frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(target, dpi=130, metadata={"Software": None})


if __name__ == "__main__":
    main(sys.argv[1])
