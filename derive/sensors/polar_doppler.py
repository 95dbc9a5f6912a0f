"""Range, azimuth and range rate in the plane; the product of range and range rate is the pseudo-measurement eta."""

from radartrack.derive.bibliography import cite
from radartrack.derive.language.model import Model
from radartrack.derive.language.variable import angle, correlation, deviation, length, speed
from radartrack.derive.symbolic import cos, sin
from radartrack.derive.units import METRE, METRE_PER_SECOND

r = length("r", "range")
beta = angle("beta", "azimuth, counter-clockwise from the x axis")
rdot = speed("rdot", "range rate")

MODEL = Model(
    name="polar_doppler",
    title="Range, azimuth and range rate to x, y and the pseudo-measurement eta = r·rdot",
    measured=(r, beta, rdot),
    deviations=(
        deviation(r, low=1e-3, high=1e4),
        deviation(beta, low=1e-9, high=1.0),
        deviation(rdot, low=1e-4, high=1e3),
    ),
    correlations={(r, rdot): correlation("rho", r, rdot)},
    outputs={"x": r * cos(beta), "y": r * sin(beta), "eta": r * rdot},
    units=(METRE, METRE, METRE * METRE_PER_SECOND),
    source=cite("duan2005", "range rate as a pseudo-measurement"),
)
