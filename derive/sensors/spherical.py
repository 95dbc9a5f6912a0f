"""Range, azimuth and elevation in space, azimuth clockwise from the y axis (compass)."""

from radartrack.derive.bibliography import cite
from radartrack.derive.language.model import Model
from radartrack.derive.language.variable import angle, correlation, deviation, length
from radartrack.derive.symbolic import cos, sin
from radartrack.derive.units import METRE

r = length("r", "range")
beta = angle("beta", "azimuth, clockwise from the y axis")
epsilon = angle("epsilon", "elevation, up from the horizontal plane", low=-1.5707963267948966, high=1.5707963267948966)

MODEL = Model(
    name="spherical",
    title="Range, azimuth and elevation to x, y and z",
    measured=(r, beta, epsilon),
    deviations=(
        deviation(r, low=1e-3, high=1e4),
        deviation(beta, low=1e-9, high=1.0),
        deviation(epsilon, low=1e-9, high=1.0),
    ),
    correlations={(r, beta): correlation("rho", r, beta)},
    outputs={
        "x": r * cos(epsilon) * sin(beta),
        "y": r * cos(epsilon) * cos(beta),
        "z": r * sin(epsilon),
    },
    units=(METRE, METRE, METRE),
    source=cite("gao2020", "(1)"),
)
