"""A bistatic radar in the plane: receiver at the origin, transmitter on the x axis at a known baseline."""

from radartrack.derive import Model, Source, angle, deviation, length
from radartrack.derive.symbolic import cos, sin
from radartrack.derive.units import METRE

path = length("path", "transmitter to target to receiver", low=3e4, high=1e6)
beta = angle("beta", "azimuth at the receiver, counter-clockwise from the x axis")
baseline = length("baseline", "transmitter to receiver", low=1e3, high=2e4)
r = (path**2 - baseline**2) / (2 * (path - baseline * cos(beta)))

MODEL = Model(
    name="bistatic_w",
    title="Bistatic path length and azimuth to x and y",
    measured=(path, beta),
    parameters=(baseline,),
    deviations=(deviation(path, low=1.0, high=300.0), deviation(beta, low=1e-6, high=0.05)),
    outputs={"x": r * cos(beta), "y": r * sin(beta)},
    units=(METRE, METRE),
    source=Source("Willis", 1991, "bistatic triangle"),
)
