"""Writes derived quantities as a module of plain NumPy functions."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256

from radartrack.derive import symbolic as sp
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import nested
from radartrack.derive.symbolic import Expr
from radartrack.derive.writing.computed_statements import first_or_known, statements_of
from radartrack.derive.writing.numpy_expression import code, terms

VERSION = "1"
WIDTH = 110
INDENT = "    "

PRELUDE = '''\
import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.floating]


def _floats(*arguments: npt.ArrayLike) -> tuple[Floats, ...]:
    """The arguments as arrays of one type: float32 where every array is float32, else float64.

    Python numbers follow the arrays; integers and anything narrower than float32 compute in float64.
    """
    typed = [np.asarray(argument) for argument in arguments if hasattr(argument, "dtype")]
    single = bool(typed) and all(array.dtype == np.float32 for array in typed)
    dtype = np.float32 if single else np.float64
    arrays = (np.asarray(argument) for argument in arguments)
    return tuple(array.astype(dtype, casting="same_kind", copy=False) for array in arrays)


def _empty(arguments: tuple[Floats, ...], shape: tuple[int, ...]) -> Floats:
    """Room for a result: the shape that the arguments broadcast to, then the tensor's own."""
    return np.empty(np.broadcast_shapes(*(a.shape for a in arguments)) + shape, arguments[0].dtype)
'''


RATIO = '''

def _ratio(above: Floats, below: Floats) -> Floats:
    """above / below, and zero where below is zero."""
    shape = np.broadcast_shapes(np.shape(above), np.shape(below))
    quotient = np.zeros(shape, np.result_type(above, below))
    return np.divide(above, below, out=quotient, where=below != 0)
'''


REMAINDER = '''

def _remainder(x: Floats, order: int) -> Floats:
    """e^x less the terms of its series below the order; where these would cancel, by the rest of the series."""
    is_small = np.abs(x) < order
    small, large = np.where(is_small, x, 0.0), np.where(is_small, 0.0, x)
    rest, series, term = np.ones_like(small), np.zeros_like(large), np.ones_like(large)
    for n in range(order + 30, order, -1):
        rest = 1.0 + small * rest / n
    for n in range(order):
        series = series + term
        term = term * large / (n + 1)
        rest = rest * small / (n + 1)
    return np.where(is_small, rest, np.exp(large) - series)
'''


STUMPFF = '''

def _stumpff(x: Floats, order: int) -> Floats:
    """1/n! - x^2/(n+2)! + x^4/(n+4)! - ..., by this series; where it is long, by cosine or sine less its beginning."""
    is_small = np.abs(x) < order
    small, large = np.where(is_small, x * x, 0.0), np.where(is_small, 1.0, x)
    series = np.ones_like(small)
    for n in range(order + 30, order, -2):
        series = 1.0 - small * series / (n * (n - 1))
    closed, term = (np.sin(large) / large, 1.0) if order % 2 else (np.cos(large), 1.0)
    for n in range(order % 2, order, 2):
        closed = (term - closed) / large**2
        term /= (n + 1) * (n + 2)
    return np.where(is_small, series * term, closed)
'''


THIRD = '''

def _third(x: Floats) -> Floats:
    """The positive root c of 4 c^3 - 3 c = x, a cosine or hyperbolic cosine and a step of Newton's."""
    wide, flat = np.maximum(x, 1.0), np.minimum(x, 1.0)
    c = np.where(x > 1.0, np.cosh(np.arccosh(wide) / 3.0), np.cos(np.arccos(flat) / 3.0))
    return c - ((4.0 * c**2 - 3.0) * c - x) / (12.0 * c**2 - 3.0)
'''

HELPERS = {"_ratio(": RATIO, "_remainder(": REMAINDER, "_stumpff(": STUMPFF, "_third(": THIRD}


@dataclass(frozen=True)
class Function:
    """A quantity as a NumPy function.

    Attributes:
        quantity: what it computes.
        body: the statements, without the docstring.
    """

    quantity: Quantity
    body: str

    @property
    def digest(self) -> str:
        """What identifies the code; comments and docstrings do not enter."""
        return sha256(self.body.encode()).hexdigest()

    def text(self, accuracy: str) -> str:
        """The whole function, its measured accuracy in the docstring."""
        quantity = self.quantity
        keywords = ", ".join(f"{symbol.name}: npt.ArrayLike" for symbol in quantity.symbols)
        signature = f"def {quantity.function}({'*, ' if keywords else ''}{keywords}) -> Floats:"
        if len(signature) > WIDTH:
            lines = (f"{INDENT}{symbol.name}: npt.ArrayLike," for symbol in quantity.symbols)
            signature = "\n".join([f"def {quantity.function}(", f"{INDENT}*,", *lines, ") -> Floats:"])
        inside = f'"""{docstring(quantity, accuracy)}\n"""\n{self.body}'
        return f"{signature}\n{textwrap.indent(inside, INDENT)}\n"


def body(quantity: Quantity, form: StableForm) -> str:
    """The statements that compute a quantity as it is rewritten, without the docstring."""
    if not quantity.symbols:
        return f"return np.array({nested(form.entries.map(code), gap=', ')})[()]"
    statements = statements_of(quantity, form)
    names = [symbol.name for symbol in quantity.symbols]
    arguments = ", ".join(names)
    lines = [f"arguments = _floats({arguments})", f"{arguments}{',' * (len(names) == 1)} = arguments"]
    lines += assignments(statements.definitions)
    lines.append(f"result = _empty(arguments, {quantity.shape})")
    places = (f"result[{', '.join(['...', *map(str, index)])}]" for index, _ in form.entries.items())
    lines += assignments(zip(places, statements.results, strict=True))
    lines.append("return result[()]" if not quantity.shape else "return result")
    return "\n".join(lines)


def assignments(pairs: Iterable[tuple[str, Expr]]) -> list[str]:
    """One assignment a pair of target and value; a value that was computed before is copied."""
    return [
        f"{target} = {value}" if isinstance(value, str) else _assignment(target, value)
        for target, value in first_or_known(pairs)
    ]


def docstring(quantity: Quantity, accuracy: str) -> str:
    """Name, definition, conditioning, source, shapes, units, domain and measured error."""
    shape = ", ".join(map(str, quantity.shape))
    returns = f"Shape of the broadcast arguments{f' + ({shape})' if shape else ''}, unit {quantity.unit_text}."
    return _escaped(documentation(quantity, returns, [f"Accuracy: {accuracy}"]))


def documentation(quantity: Quantity, returns: str, accuracy: Sequence[str]) -> str:
    """What is said of a function in any language.

    Args:
        quantity: what it computes.
        returns: what it gives back.
        accuracy: sentences on its errors.
    """
    meaning = quantity.meaning[0].upper() + quantity.meaning[1:]
    facts = [
        f"Name: {quantity.name}.",
        f"Definition: {quantity.word}.",
        f"Conditioning: {quantity.conditioning.value}.",
        f"Source: {quantity.source.reference}.",
    ]
    arguments = [f"{INDENT}{s.name}: {s.meaning} [{s.unit}], {s.low:.5g} to {s.high:.5g}." for s in quantity.symbols]
    scale = "the sizes of the terms" if quantity.is_difference else quantity.measured_against
    against = f" Errors are measured against {scale}." if scale else ""
    *earlier, last = accuracy
    sections = [
        f"{meaning}.",
        "\n".join(line for fact in facts for line in textwrap.wrap(fact, WIDTH - 4)),
        *(["\n".join(["Args:", *arguments])] if arguments else []),
        "\n".join(["Returns:", *textwrap.wrap(returns, WIDTH - 4, initial_indent=INDENT, subsequent_indent=INDENT)]),
        "\n".join(line for said in [*earlier, f"{last}{against}"] for line in textwrap.wrap(said, WIDTH - 4)),
    ]
    return "\n\n".join(sections)


def wrapped(text: str) -> str:
    """In lines."""
    return "\n".join(textwrap.wrap(text, WIDTH - 4))


def _escaped(text: str) -> str:
    """As it stands between triple quotes: a user's own words may hold quotes and backslashes."""
    return text.replace("\\", "\\\\").replace('"""', '\\"\\"\\"')


def module_text(title: str, functions: Sequence[Function], accuracy: Mapping[str, str]) -> str:
    """A module with a header, the shared helpers, and one function a quantity."""
    digest = sha256("".join(function.digest for function in functions).encode()).hexdigest()[:16]
    names = "".join(f'    "{name}",\n' for name in sorted(function.quantity.function for function in functions))
    header = (
        f'"""{title}.\n\nWritten by radartrack regenerate, generator {VERSION}, derivation {digest}; '
        'not to be edited.\n"""\n'
    )
    written = [function.text(accuracy[function.quantity.name]) for function in functions]
    body = "\n\n".join([f"{header}\n{PRELUDE}{helpers(''.join(written))}", *written])
    return body.replace("\nFloats = ", f"\n__all__ = [\n{names}]\n\nFloats = ", 1)


def helpers(statements: str) -> str:
    """The functions beside NumPy's that statements call."""
    return "".join(helper for call, helper in HELPERS.items() if call in statements)


def _assignment(target: str, expression: Expr) -> str:
    line = f"{target} = {code(expression)}"
    if len(line) + len(INDENT) <= WIDTH or not isinstance(expression, sp.Add):
        return line
    return "\n".join([f"{target} = (", *(f"{INDENT}{term}" for term in terms(expression)), ")"])
