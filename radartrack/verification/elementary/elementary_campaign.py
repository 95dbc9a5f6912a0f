"""The elementary functions beside correctly rounded values of python-flint, at arguments of every kind.

`python -m radartrack.verification.elementary.elementary_campaign 100000000` takes so many arguments, shared among
functions and precisions, and prints the largest errors.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from dataclasses import dataclass
from types import FunctionType
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack.generated import elementary
from radartrack.verification.elementary.ball_arithmetic import flint
from radartrack.verification.elementary.elementary_checker import FUNCTIONS

Floats = npt.NDArray[np.floating[Any]]
TYPES: dict[str, type[np.floating[Any]]] = {"double": np.float64, "single": np.float32}
BLOCK = 50_000
STEP = {"sin": math.pi / 2, "cos": math.pi / 2, "exp": math.log(2), "expm1": math.log(2)}
REACH = {
    "double": {"sin": 32768.0, "cos": 32768.0, "exp": 709.7, "expm1": 709.7},
    "single": {"sin": 256.0, "cos": 256.0, "exp": 88.7, "expm1": 88.7},
}


@dataclass(frozen=True)
class Largest:
    """The largest error of a function among so many arguments.

    Attributes:
        ulp: in units of the last place of the exact value.
        argument: where.
        correct: the share of results that are the nearest number.
        count: of arguments.
    """

    ulp: float
    argument: float
    correct: float
    count: int


def over_arrays(name: str) -> Callable[[Floats], Any]:
    """A function of the generated module, over arrays: the same statements, an operation at a time."""
    primitives: dict[str, Any] = {"chosen": np.where, "power_of_two": _powers_of_two}
    function = getattr(elementary, name)
    for together in {"sin_and_cos", "sin_and_cos_single"}.intersection(function.__code__.co_names):
        primitives[together] = over_arrays(together)
    return FunctionType(function.__code__, function.__globals__ | primitives)


def _powers_of_two(exponents: Floats) -> Floats:
    whole = np.where(np.isfinite(exponents), exponents, 0).astype(np.int64)
    return np.asarray(np.ldexp(exponents.dtype.type(1), whole) + 0 * exponents, exponents.dtype)


def largest(name: str, precision: str, count: int, seed: int) -> Largest:
    """Look at so many arguments."""
    generator, function = np.random.default_rng(seed), over_arrays(name + ("" if precision == "double" else "_single"))
    worst, place, correct = 0.0, math.nan, 0
    for start in range(0, count, BLOCK):
        arguments = drawn(name, precision, min(BLOCK, count - start), generator)
        errors = in_ulp(name, arguments, function(arguments))
        correct += int((errors <= 0.5).sum())
        top = int(errors.argmax())
        if errors[top] > worst:
            worst, place = float(errors[top]), float(arguments[top])
    return Largest(worst, place, correct / count, count)


def drawn(name: str, precision: str, count: int, generator: np.random.Generator) -> Floats:
    """Over the range, over the reduced interval, over magnitudes, and beside the multiples that are taken off."""
    reach, step = REACH[precision][name], STEP[name]
    near = 3e-16 if precision == "double" else 2e-7
    halves = np.rint(generator.uniform(-1.9, 1.9, count) * reach / step) * step / 2
    kinds = [
        generator.uniform(-reach, reach, count),
        generator.uniform(-step, step, count),
        np.copysign(10.0 ** generator.uniform(-12, math.log10(reach), count), generator.uniform(-1, 1, count)),
        halves * (1 + generator.normal(0, near, count)),
    ]
    found = np.choose(generator.integers(len(kinds), size=count), kinds)
    return np.asarray(np.clip(found, -reach, reach), TYPES[precision])


def in_ulp(name: str, arguments: Floats, results: Floats) -> npt.NDArray[np.float64]:
    """Errors in units of the last place of the exact value, subnormal numbers included."""
    kind = np.finfo(arguments.dtype)
    arb, bits = flint().arb, kind.nmant + 1
    exact = [getattr(arb(x), name)() for x in arguments.tolist()]
    exponents = np.frexp(np.array([abs(float(value)) for value in exact]))[1]
    last = np.maximum(exponents, kind.minexp + 1) - bits
    pairs = zip(exact, results.tolist(), last.tolist(), strict=True)
    return np.array([abs(float((value - arb(result)) * arb(2) ** -place)) for value, result, place in pairs])


def main(count: int) -> None:
    """Print the largest errors."""
    each = count // (len(FUNCTIONS) * len(TYPES))
    for precision in TYPES:
        for name in FUNCTIONS:
            found = largest(name, precision, each, seed=1)
            print(  # noqa: T201 - a campaign is looked at
                f"{name}, {precision}: {found.count} arguments, at most {found.ulp:.4f} ulp at {found.argument!r}, "
                f"{100 * found.correct:.2f} % correctly rounded",
                flush=True,
            )


if __name__ == "__main__":
    main(int(sys.argv[1]))
