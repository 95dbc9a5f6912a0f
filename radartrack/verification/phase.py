"""How fast the waves and exponentials of a map turn or grow with what is measured.

Errors of many radians of phase leave nothing of a wave: no rule of quadrature and no number of draws sees it then.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache

import numpy as np
import numpy.typing as npt

from radartrack.derive import symbolic as sp
from radartrack.derive.language.model import Model, predicted
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.verification.array_program import Program
from radartrack.verification.program_compilation import compiled

MOST = 0.6  # radians that one standard deviation of an error may be
WAVES = (sp.cos, sp.cosh, sp.exp, sp.sin, sp.sinh, sp.tan, sp.tanh)
Array = npt.NDArray[np.float64]


@cache
def phase_rates(model: Model) -> Mapping[Variable, Program]:
    """For each measured quantity that occurs in a wave, how fast the arguments of the waves grow with it."""
    arguments = list(dict.fromkeys(wave.args[0] for h in model.map for wave in _waves(h)))
    found = {}
    for variable in model.measured:
        rates = [sp.diff(argument, variable) for argument in arguments if variable in argument.free_symbols]
        if rates:
            found[variable] = compiled(Tensor((len(rates),), tuple(rates)), model.arguments)
    return found


def _waves(expression: Expr) -> Iterator[Expr]:
    if isinstance(expression, WAVES):
        yield expression
    for part in expression.args:
        yield from _waves(part)


def calmed(model: Model, points: Mapping[str, Array]) -> dict[str, Array]:
    """The same points with deviations made smaller where an error would be more than a fraction of a turn."""
    calm = dict(points)
    known = {symbol.name: points[symbol.name] for symbol in model.arguments if symbol.name in points}
    if len(known) < len(model.arguments):
        return calm
    for variable, deviation in zip(model.measured, model.deviations, strict=False):
        if variable not in phase_rates(model):
            continue
        with np.errstate(all="ignore"):
            fastest = np.abs(phase_rates(model)[variable](**known)).max(axis=-1)
        for symbol in (deviation, predicted(deviation)):
            if symbol.name in calm:
                calm[symbol.name] = np.where(calm[symbol.name] * fastest > MOST, MOST / fastest, calm[symbol.name])
    return calm
