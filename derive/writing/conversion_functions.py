"""Mean and covariance of a conversion together, as functions that fill arrays of the caller.

What both need is computed once, and sums are nested, for the fewest operations. The same statements are written twice:
over whole arrays for NumPy, and as a loop over plots in plain numbers, for a compiler or for one plot. The formulas are
those of the catalogue.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256
from typing import NamedTuple

from radartrack.derive import symbolic as sp
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Index, Tensor, indices
from radartrack.derive.stable.horner import nested
from radartrack.derive.stable.quantity_form import form_of
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.writing.common_products import with_common_products
from radartrack.derive.writing.common_subexpressions import with_common_parts
from radartrack.derive.writing.computed_statements import Statements, beside, joined
from radartrack.derive.writing.numpy_expression import FUNCTIONS
from radartrack.derive.writing.numpy_writer import INDENT, REMAINDER, VERSION, WIDTH, assignments


class Words(NamedTuple):
    """The estimate of a method, the bias that is taken from it, and the covariance of the result."""

    estimate: str
    bias: str | None
    covariance: str


METHODS = {
    "linear": Words("map", None, "covariance.linear"),
    "second_order": Words("map", "bias.second_order", "covariance.second_order"),
    "averaged": Words("map", "bias.averaged", "covariance.averaged"),
    "unbiased": Words("unbiased.estimate", None, "unbiased.covariance"),
    "posterior": Words("posterior.estimate", None, "posterior.covariance"),
}

RELEASED_AT_ONCE = 4
SQUARED_UP_TO = 3  # the power of a square; with the fourth, `polar.covariance.averaged` had 10 ulp, more than its 8
ARRAYS = "over arrays; mean, shape (..., n), and covariance, shape (..., n, n), are filled"
ARRAYS_HEAD = "import numpy as np\nimport numpy.typing as npt\n\nFloats = npt.NDArray[np.floating]\nFilled = Floats\n"
LOOPS = "as loops over given[symbol][plot]; mean[plot, n] and covariance[plot, n, n] are filled, arrays or dictionaries"
LOOPS_HEAD = """\
import math
from collections.abc import MutableMapping, Sequence

Floats = Sequence[float]
Filled = MutableMapping[tuple[int, ...], float]
"""
REMAINDER_OF_A_NUMBER = '''

def _remainder(x: float, order: int) -> float:
    """e^x less the terms of its series below the order; where these would cancel, by the rest of the series."""
    rest, series, term = 1.0, 0.0, 1.0
    for n in range(order + 30, order, -1):
        rest = 1.0 + x * rest / n
    for n in range(order):
        series += term
        term *= x / (n + 1)
    return rest * term if abs(x) < order else math.exp(x) - series
'''
REMAINDER_OF_KIND = {ARRAYS: REMAINDER, LOOPS: REMAINDER_OF_A_NUMBER}
OF_A_NUMBER = {numpy.removeprefix("np."): function.__name__ for function, numpy in FUNCTIONS.items()} | {"abs": "fabs"}


@dataclass(frozen=True)
class Conversion:
    """One conversion as it is computed.

    Attributes:
        name: model and method.
        symbols: names of the arguments.
        shapes: of mean and covariance.
        statements: the entries of the mean, then those of the covariance.
        title: what it converts how.
        meaning: of mean and covariance.
    """

    name: str
    symbols: tuple[str, ...]
    shapes: tuple[Index, Index]
    statements: Statements
    title: str
    meaning: str


@dataclass(frozen=True)
class ConversionCode:
    """One conversion.

    Attributes:
        name: of the functions: model and method.
        symbols: names of the arguments.
        intermediates: names of what is computed on the way.
        statements: which fill `mean` and `covariance`, for arrays.
        title: what it converts how.
        meaning: of mean and covariance.
    """

    name: str
    symbols: tuple[str, ...]
    intermediates: frozenset[str]
    statements: tuple[str, ...]
    title: str
    meaning: str

    def over_arrays(self) -> str:
        """The function for NumPy; it releases what it needs no more, so that the rest stays in the cache."""
        return self._function(dict.fromkeys(self.symbols, "Floats"), "\n".join(self._releasing()))

    def as_loop(self) -> str:
        """The function in plain numbers."""
        loaded = (f"{symbol} = given[{n}][i]" for n, symbol in enumerate(self.symbols))
        inside = "\n".join([*loaded, *self.statements]).replace("[..., ", "[i, ")
        of_numbers = re.sub(r"\bnp\.(\w+)", lambda found: f"math.{OF_A_NUMBER.get(found[1], found[1])}", inside)
        loop = f"for i in range(len(given[0])):\n{textwrap.indent(of_numbers, INDENT)}"
        return self._function({"given": "Sequence[Floats]"}, loop)

    def _releasing(self) -> Iterator[str]:
        """The statements, with deletions of intermediates behind their last use, a few at once."""
        used = [set(re.findall(r"\w+", statement)) & self.intermediates for statement in self.statements]
        last = {name: place for place, names in enumerate(used) for name in names}
        waiting: list[str] = []
        for place, statement in enumerate(self.statements):
            yield statement
            waiting += sorted(name for name in used[place] if last[name] == place)
            if len(waiting) >= RELEASED_AT_ONCE:
                yield f"del {', '.join(waiting)}"
                waiting = []

    def _function(self, arguments: Mapping[str, str], body: str) -> str:
        types = {**arguments, "mean": "Filled", "covariance": "Filled"}
        signature = "".join(f"{INDENT}{name}: {kind},\n" for name, kind in types.items())
        said = "\n".join([f'"""{self.title}.\n', *textwrap.wrap(f"{self.meaning}.", WIDTH - 4), '"""'])
        inside = textwrap.indent(f"{said}\n{body}", INDENT)
        return f"def {self.name}(\n{signature}) -> None:\n{inside}\n"


def conversions_of(quantities: Mapping[str, Quantity]) -> list[tuple[str, str]]:
    """Model and method of every conversion whose estimate, bias and covariance are all there."""
    models = dict.fromkeys(name.partition(".")[0] for name in quantities)
    return [
        (model, method)
        for model in models
        for method, words in METHODS.items()
        if all(quantity_of(quantities, model, word) for word in words if word)
    ]


def covariance_of(quantities: Mapping[str, Quantity], model: str, method: str) -> str:
    """The name of the covariance of a conversion."""
    return quantity_of(quantities, model, METHODS[method].covariance)


def conversion_of(quantities: Mapping[str, Quantity], model: str, method: str) -> Conversion:
    """Derive one conversion.

    Raises:
        KeyError: a part of it is missing.
    """
    words = METHODS[method]
    estimate = quantities[quantity_of(quantities, model, words.estimate)]
    covariance = quantities[quantity_of(quantities, model, words.covariance)]
    bias = quantities[quantity_of(quantities, model, words.bias)] if words.bias else None
    mean = _less(form_of(estimate), form_of(bias)) if bias else form_of(estimate)
    form = beside(_with_shared_exponentials(_together(mean, form_of(covariance))), covariance)
    given = {symbol: nested(value) for symbol, value in form.definitions.items()}
    statements = joined(*with_common_products(*with_common_parts(given, form.entries.map_distinct(nested))))
    symbols = tuple(symbol.name for symbol in covariance.symbols)
    less = f" less the {bias.meaning}" if bias else ""
    meaning = f"Mean: {estimate.meaning}{less}. Covariance: {covariance.meaning}"
    shapes = (estimate.shape, covariance.shape)
    return Conversion(f"{model}_{method}", symbols, shapes, statements, f"Conversion {model}, {method}", meaning)


def conversion_code(quantities: Mapping[str, Quantity], model: str, method: str) -> ConversionCode:
    """Derive one conversion and write it for NumPy.

    Raises:
        KeyError: a part of it is missing.
    """
    found = conversion_of(quantities, model, method)
    mean, covariance = found.shapes
    places = [*_places("mean", mean), *_places("covariance", covariance)]
    lines = assignments(found.statements.definitions)
    lines += assignments(zip(places, found.statements.results, strict=True))
    intermediates = frozenset(name for name, _ in found.statements.definitions)
    return ConversionCode(found.name, found.symbols, intermediates, tuple(lines), found.title, found.meaning)


def module_text(codes: Sequence[ConversionCode], kind: str) -> str:
    """A module of conversions, over ARRAYS or as LOOPS."""
    functions = [code.over_arrays() if kind == ARRAYS else code.as_loop() for code in codes]
    digest = sha256("".join(functions).encode()).hexdigest()[:16]
    header = (
        f'"""Conversions {kind}.\n\nWritten by radartrack regenerate, generator {VERSION}, derivation {digest}; '
        'not to be edited.\n"""\n'
    )
    head = ARRAYS_HEAD if kind == ARRAYS else LOOPS_HEAD
    helper = REMAINDER_OF_KIND[kind] if any("_remainder(" in function for function in functions) else ""
    return "\n\n".join([f"{header}\n{head}{helper}", *functions])


def quantity_of(quantities: Mapping[str, Quantity], model: str, word: str) -> str:
    """The name of a word, exact or else to fourth order, covariances as sums of squares; empty where there is none."""
    names = (f"{model}.{word}", f"{model}.{word}.semidefinite", f"{model}.{word}.fourth_order")
    return next((name for name in names if name in quantities), "")


def _less(first: StableForm, second: StableForm) -> StableForm:
    both = _together(first, second)
    size = len(first.entries.entries)
    entries = (a - b for a, b in zip(both.entries.entries[:size], both.entries.entries[size:], strict=True))
    return StableForm(both.definitions, Tensor(first.entries.shape, tuple(entries)))


def _together(first: StableForm, second: StableForm) -> StableForm:
    """One form with the entries of both; an intermediate of the second that means something else is renamed."""
    clashes = {s for s, value in second.definitions.items() if first.definitions.get(s, value) != value}
    second = second.renamed({symbol: sp.Symbol(f"{symbol.name}_2", real=True) for symbol in clashes})
    entries = (*first.entries, *second.entries)
    return StableForm({**first.definitions, **second.definitions}, Tensor((len(entries),), entries))


def _with_shared_exponentials(form: StableForm) -> StableForm:
    """The same with fewer exponentials where e^x is there, for a rounding or two more.

    e^(2x) − 1 is s (2 + s) with s = e^x − 1, of which a compiler computes e^x at the same time. e^(2x) is the square of
    e^x, with twice its error, unless a high power of it is taken, to which each square brings as much again.
    """
    halves = {value.args[0]: symbol for symbol, value in form.definitions.items() if isinstance(value, sp.exp)}
    definitions: dict[Symbol, Expr] = {}
    for symbol, value in form.definitions.items():
        shared: dict[Expr, Expr] = {}
        for whole in value.atoms(sp.exp, sp.expm1):
            if (half := whole.args[0] / 2) not in halves:
                continue
            if isinstance(whole, sp.expm1):
                once = sp.Symbol(f"{halves[half].name}_less_one", real=True)
                definitions[once] = sp.expm1(half)
                shared[whole] = once * (2 + once)
            elif _highest_power(symbol, form) <= SQUARED_UP_TO:
                shared[whole] = halves[half] ** 2
        definitions[symbol] = value.xreplace(shared)
    return StableForm(definitions, form.entries, form.arbitrary)


def _highest_power(symbol: Symbol, form: StableForm) -> int:
    expressions = [*form.definitions.values(), *form.entries]
    powers = (power for expression in expressions for power in expression.atoms(sp.Pow) if power.base == symbol)
    return max((int(power.exp) for power in powers if power.exp.is_Integer), default=1)


def _places(name: str, shape: Index) -> list[str]:
    return [f"{name}[..., {', '.join(map(str, index))}]" for index in indices(shape)]
