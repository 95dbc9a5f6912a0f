"""Sine, cosine, e^x and e^x − 1 as Python in plain numbers, which Numba compiles into the loops over plots."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from hashlib import sha256

from radartrack.derive.elementary.precision import DOUBLE, SINGLE, Precision
from radartrack.derive.elementary.straight_line import (
    Steps,
    angle_less_quarters,
    exponential,
    exponential_less_one,
    sine_and_cosine,
)
from radartrack.derive.writing.numpy_writer import INDENT, VERSION

NAME = "elementary.py"
PRIMITIVES = '''\
import math

LARGEST_ANGLE, LARGEST_ANGLE_SINGLE = {double}, {single}
NAN = math.nan


def chosen(condition: bool, first: float, second: float) -> float:  # noqa: FBT001 - as a selection has it
    """The first where the condition holds, else the second; a compiler puts a selection in place of this."""
    return first if condition else second


def power_of_two(exponent: float) -> float:
    """2 to a whole power, from -1074 to 1023; a compiler puts its bits in place of this."""
    return math.ldexp(1.0, int(exponent)) if abs(exponent) < math.inf else exponent
'''


class Python:
    """How Python writes the steps; numbers of single precision are numbers of double precision too."""

    def number(self, value: float) -> str:
        """By the shortest digits that are read as it."""
        return repr(value)

    def absolute(self, value: str) -> str:
        """The function for it."""
        return f"abs({value})"

    def chosen(self, condition: str, first: str, second: str) -> str:
        """The function of the module."""
        return f"chosen({condition}, {first}, {second})"

    def power_of_two(self, exponent: str) -> str:
        """The function of the module."""
        return f"power_of_two({exponent})"

    def in_type(self, value: str) -> str:
        """As it is: Python computes in no wider one."""
        return f"({value})"


def module_text() -> str:
    """The module."""
    functions = [text for precision in (DOUBLE, SINGLE) for text in _functions(precision)]
    digest = sha256("".join(functions).encode()).hexdigest()[:16]
    header = (
        '"""Elementary functions without a branch, in double and, for NumPy\'s float32, single precision.\n\n'
        "Each is within one unit in the last place of the exact value; sine and cosine up to a largest angle,\n"
        "beyond which they are NaN. The bits are the same on every processor. A zero has no sign.\n\n"
        f'Written by radartrack regenerate, generator {VERSION}, derivation {digest}; not to be edited.\n"""\n'
    )
    primitives = PRIMITIVES.format(double=DOUBLE.largest_angle, single=SINGLE.largest_angle)
    return "\n\n".join([f"{header}\n{primitives}", *functions])


def _functions(precision: Precision) -> Iterator[str]:
    say, end = Python(), precision.suffix
    reduction, both = angle_less_quarters(precision, say), sine_and_cosine(precision, say)
    within = ("x", f"chosen(abs(angle) <= LARGEST_ANGLE{end.upper()}, angle, NAN)")
    together = Steps((within, *reduction.assignments, *both.assignments), both.results)
    yield _function(f"sin_and_cos{end}", "angle", "Sine and cosine of an angle in radians.", together)
    for place, (name, said) in enumerate((("sin", "Sine"), ("cos", "Cosine"))):
        alone = Steps((), (f"sin_and_cos{end}(angle)[{place}]",))
        yield _function(f"{name}{end}", "angle", f"{said} of an angle in radians.", alone)
    yield _function(f"exp{end}", "x", "e^x.", exponential(precision, say))
    yield _function(f"expm1{end}", "x", "e^x less one.", exponential_less_one(precision, say))


def _function(name: str, argument: str, said: str, steps: Steps) -> str:
    lines = [f"{target} = {value}" for target, value in steps.assignments]
    kind = "float" if len(steps.results) == 1 else "tuple[float, float]"
    body = "\n".join([f'"""{said}"""', *lines, f"return {', '.join(steps.results)}"])
    return f"def {name}({argument}: float) -> {kind}:\n{textwrap.indent(body, INDENT)}\n"
