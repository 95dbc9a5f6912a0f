"""A height finder over the curved Earth: slant range and elevation to ground distance and height."""

from radartrack.derive import Model, Source, angle, deviation, length
from radartrack.derive.symbolic import cos, sin
from radartrack.derive.units import METRE

r = length("r", "slant range")
epsilon = angle("epsilon", "elevation")
R = length("R", "effective radius of the Earth", low=6e6, high=9e6)

MODEL = Model(
    name="height_finder",
    title="Slant range and elevation to ground distance and height over a curved Earth",
    measured=(r, epsilon),
    parameters=(R,),
    deviations=(deviation(r, low=1.0, high=1e3), deviation(epsilon, low=1e-6, high=0.1)),
    outputs={"d": r * cos(epsilon), "h": r * sin(epsilon) + r**2 * cos(epsilon) ** 2 / (2 * R)},
    units=(METRE, METRE),
    source=Source("Skolnik", 2001, "height finding"),
)
