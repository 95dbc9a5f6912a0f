"""Mean and covariance of a conversion together, as functions that fill arrays of the caller.

What both need is computed once. The same statements are written twice: over whole arrays for NumPy, and as a loop over
plots for a compiler. The formulas are those of the catalogue.
"""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256
from typing import NamedTuple

from radartrack.derive import symbolic as sp
from radartrack.derive.common import with_common_parts
from radartrack.derive.forms import form_of
from radartrack.derive.quantity import Quantity
from radartrack.derive.stable import StableForm
from radartrack.derive.tensor import Index, Tensor, indices
from radartrack.derive.writer import INDENT, VERSION, WIDTH, assignments


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

ARRAYS = "over arrays; mean, shape (..., n), and covariance, shape (..., n, n), are filled"
LOOPS = "as loops over plots, for a compiler; arguments have shape (plots,), mean (plots, n), covariance (plots, n, n)"


@dataclass(frozen=True)
class ConversionCode:
    """One conversion.

    Attributes:
        name: of the functions: model and method.
        symbols: names of the arguments.
        statements: which fill `mean` and `covariance`, for arrays.
        title: what it converts how.
        meaning: of mean and covariance.
    """

    name: str
    symbols: tuple[str, ...]
    statements: str
    title: str
    meaning: str

    def over_arrays(self) -> str:
        """The function for NumPy."""
        return self._function(self.symbols, self.statements)

    def as_loop(self) -> str:
        """The function for a compiler."""
        loaded = "\n".join(f"{symbol} = all_{symbol}[i]" for symbol in self.symbols)
        inside = f"{loaded}\n{self.statements.replace('[..., ', '[i, ')}"
        loop = f"for i in range(len(mean)):\n{textwrap.indent(inside, INDENT)}"
        return self._function([f"all_{symbol}" for symbol in self.symbols], loop)

    def _function(self, arguments: Sequence[str], body: str) -> str:
        signature = "".join(f"{INDENT}{name}: Floats,\n" for name in (*arguments, "mean", "covariance"))
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
        if all(_find(quantities, model, word) for word in words if word)
    ]


def covariance_of(quantities: Mapping[str, Quantity], model: str, method: str) -> str:
    """The name of the covariance of a conversion."""
    return _find(quantities, model, METHODS[method].covariance)


def conversion_code(quantities: Mapping[str, Quantity], model: str, method: str) -> ConversionCode:
    """Derive one conversion.

    Raises:
        KeyError: a part of it is missing.
    """
    words = METHODS[method]
    estimate, covariance = (quantities[_find(quantities, model, word)] for word in (words.estimate, words.covariance))
    bias = quantities[_find(quantities, model, words.bias)] if words.bias else None
    mean = _less(form_of(estimate), form_of(bias)) if bias else form_of(estimate)
    form = _together(mean, form_of(covariance))
    definitions, results = with_common_parts(form.definitions, form.entries)
    places = [*_places("mean", estimate.shape), *_places("covariance", covariance.shape)]
    lines = assignments((symbol.name, value) for symbol, value in definitions.items())
    lines += assignments(zip(places, results, strict=True))
    symbols = tuple(symbol.name for symbol in covariance.symbols)
    less = f" less the {bias.meaning}" if bias else ""
    meaning = f"Mean: {estimate.meaning}{less}. Covariance: {covariance.meaning}"
    return ConversionCode(f"{model}_{method}", symbols, "\n".join(lines), f"Conversion {model}, {method}", meaning)


def module_text(codes: Sequence[ConversionCode], kind: str) -> str:
    """A module of conversions, over ARRAYS or as LOOPS."""
    functions = [code.over_arrays() if kind == ARRAYS else code.as_loop() for code in codes]
    digest = sha256("".join(functions).encode()).hexdigest()[:16]
    header = (
        f'"""Conversions {kind}.\n\nWritten by radartrack regenerate, generator {VERSION}, derivation {digest}; '
        'not to be edited.\n"""\n'
    )
    imports = "import numpy as np\nimport numpy.typing as npt\n\nFloats = npt.NDArray[np.floating]\n"
    return "\n\n".join([f"{header}\n{imports}", *functions])


def _find(quantities: Mapping[str, Quantity], model: str, word: str) -> str:
    """The name of a word, exact or else to fourth order; empty where there is neither."""
    return next((name for name in (f"{model}.{word}", f"{model}.{word}.fourth_order") if name in quantities), "")


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


def _places(name: str, shape: Index) -> list[str]:
    return [f"{name}[..., {', '.join(map(str, index))}]" for index in indices(shape)]
