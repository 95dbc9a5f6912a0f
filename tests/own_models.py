"""A model of one's own as the tests have it, in TOML and in Python: range and a turning angle ωT."""

from pathlib import Path

TOML = """
[symbols]
r = { unit = "m", low = 1e3, high = 1e5, meaning = "range" }
w = { unit = "rad/s", low = -0.1, high = 0.1, meaning = "rate of turn" }
T = { unit = "s", low = 0.1, high = 10, meaning = "period" }
s_r = { unit = "m", low = 1, high = 100 }
s_w = { unit = "rad/s", low = 1e-6, high = 0.01 }
[[model]]
name = "rotor"
title = "Range and rate of turn to x and y"
measured = ["r", "w"]
parameters = ["T"]
outputs = { x = "r*cos(w*T)", y = "r*sin(w*T)" }
units = { x = "m", y = "m" }
deviations = { r = "s_r", w = "s_w" }
correlations = { c = ["r", "w"] }
"""

PYTHON = """
from radartrack.derive import Model, Source, Variable, correlation, length
from radartrack.derive.symbolic import cos, sin
from radartrack.derive.units import METRE, RADIAN, SECOND

r = length("r", "range", low=1e3, high=1e5)
w = Variable("w", "rate of turn", RADIAN / SECOND, -0.1, 0.1)
T = Variable("T", "period", SECOND, 0.1, 10)
MODEL = Model(
    name="rotor",
    title="Range and rate of turn to x and y",
    measured=(r, w),
    parameters=(T,),
    deviations=(Variable("s_r", "s_r", METRE, 1, 100), Variable("s_w", "s_w", RADIAN / SECOND, 1e-6, 0.01)),
    correlations={(r, w): correlation("c", r, w)},
    outputs={"x": r * cos(w * T), "y": r * sin(w * T)},
    units=(METRE, METRE),
    source=Source("Nobody", 2026),
)
"""


def files(folder: Path) -> dict[str, Path]:
    """The same model in both languages, by the end of the name."""
    paths = {"toml": folder / "rotor.toml", "py": folder / "rotor.py"}
    for kind, text in (("toml", TOML), ("py", PYTHON)):
        paths[kind].write_text(text)
    return paths
