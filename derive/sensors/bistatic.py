"""Bistatic path and azimuth in the plane: the receiver at the origin, the transmitter on the axis of the azimuth."""

from radartrack.derive.bibliography import cite
from radartrack.derive.language.model import Model
from radartrack.derive.language.variable import angle, correlation, deviation, length
from radartrack.derive.symbolic import cos, sin
from radartrack.derive.units import METRE

path = length("path", "length of the path from transmitter to target to receiver", low=3e4, high=1e6)
beta = angle("beta", "azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands")
baseline = length("baseline", "distance from transmitter to receiver; less than the path", low=1.0, high=2e4)
r = (path**2 - baseline**2) / (2 * (path - baseline * cos(beta)))

MODEL = Model(
    name="bistatic",
    title="Bistatic path length and azimuth to x and y",
    measured=(path, beta),
    parameters=(baseline,),
    scaled_by=path,
    deviations=(deviation(path, low=1e-3, high=1e3), deviation(beta, low=1e-9, high=0.1)),
    correlations={(path, beta): correlation("rho", path, beta)},
    outputs={"x": r * cos(beta), "y": r * sin(beta)},
    units=(METRE, METRE),
    variances_vanish=True,  # y is largest on the ellipse of a path at cos(beta) = baseline/path, and constant nearby
    source=cite("willis1991", "bistatic triangle"),
)
