"""Range and azimuth in the plane, azimuth counter-clockwise from the x axis."""

from radartrack.derive.bibliography import cite
from radartrack.derive.language.model import Model
from radartrack.derive.language.variable import angle, correlation, deviation, length
from radartrack.derive.symbolic import cos, sin
from radartrack.derive.units import METRE

r = length("r", "range")
beta = angle("beta", "azimuth, counter-clockwise from the x axis")

MODEL = Model(
    name="polar",
    title="Range and azimuth to x and y",
    measured=(r, beta),
    deviations=(deviation(r, low=1e-3, high=1e4), deviation(beta, low=1e-9, high=1.0)),
    correlations={(r, beta): correlation("rho", r, beta)},
    outputs={"x": r * cos(beta), "y": r * sin(beta)},
    units=(METRE, METRE),
    source=cite("prosov", "(8)"),
)
