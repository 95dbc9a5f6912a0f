"""Range and two direction cosines (phased array), r·√(1 − u² − v²) along the array's normal."""

from radartrack.derive.bibliography import cite
from radartrack.derive.language.model import Model
from radartrack.derive.language.variable import Variable, correlation, deviation, length
from radartrack.derive.symbolic import sqrt
from radartrack.derive.units import METRE, ONE

r = length("r", "range")
u = Variable("u", "direction cosine along the x axis; u^2 + v^2 < 1", ONE, -0.6, 0.6)
v = Variable("v", "direction cosine along the y axis; u^2 + v^2 < 1", ONE, -0.6, 0.6)

MODEL = Model(
    name="ruv",
    title="Range and direction cosines to x, y and z",
    measured=(r, u, v),
    deviations=(
        deviation(r, low=1e-3, high=1e4),
        deviation(u, low=1e-9, high=0.1),
        deviation(v, low=1e-9, high=0.1),
    ),
    correlations={(u, v): correlation("rho", u, v)},
    outputs={"x": r * u, "y": r * v, "z": r * sqrt(1 - u**2 - v**2)},
    units=(METRE, METRE, METRE),
    source=cite("barshalom2011", "direction cosines"),
)
