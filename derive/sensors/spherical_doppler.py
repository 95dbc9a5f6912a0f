"""Range, azimuth, elevation and range rate in space; range times range rate is the pseudo-measurement eta."""

from radartrack.derive.bibliography import cite
from radartrack.derive.language.model import Model
from radartrack.derive.language.variable import angle, correlation, deviation, length, speed
from radartrack.derive.symbolic import cos, sin
from radartrack.derive.units import METRE, METRE_PER_SECOND

r = length("r", "range")
beta = angle("beta", "azimuth, clockwise from the y axis")
epsilon = angle("epsilon", "elevation, up from the horizontal plane", low=-1.5707963267948966, high=1.5707963267948966)
rdot = speed("rdot", "range rate")

MODEL = Model(
    name="spherical_doppler",
    title="Range, azimuth, elevation and range rate to x, y, z and the pseudo-measurement eta = r·rdot",
    measured=(r, beta, epsilon, rdot),
    deviations=(
        deviation(r, low=1e-3, high=1e4),
        deviation(beta, low=1e-9, high=1.0),
        deviation(epsilon, low=1e-9, high=1.0),
        deviation(rdot, low=1e-4, high=1e3),
    ),
    correlations={(r, rdot): correlation("rho", r, rdot)},
    outputs={
        "x": r * cos(epsilon) * sin(beta),
        "y": r * cos(epsilon) * cos(beta),
        "z": r * sin(epsilon),
        "eta": r * rdot,
    },
    units=(METRE, METRE, METRE, METRE * METRE_PER_SECOND),
    source=cite("duan2005", "range rate as a pseudo-measurement"),
)
