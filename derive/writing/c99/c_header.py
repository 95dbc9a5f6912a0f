"""C functions as headers: one a family, one over all."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256

from radartrack.derive.language.quantity import Quantity
from radartrack.derive.writing.c99 import c_elementary
from radartrack.derive.writing.c99.c_expression import PREFIX
from radartrack.derive.writing.c99.c_function import CFunction, Output, function, in_comment
from radartrack.derive.writing.conversion_functions import conversion_of
from radartrack.derive.writing.expression_code import NotWritable
from radartrack.derive.writing.numpy_writer import VERSION, Function, documentation, wrapped

ALL = "radartrack.h"
CONVERSIONS = "convert"  # the family of mean and covariance together


@dataclass(frozen=True)
class QuantityInC:
    """A quantity as C.

    Attributes:
        quantity: what it computes.
        numpy: the function of the same statements in NumPy, by whose digest its accuracy is known.
        written: the function.
    """

    quantity: Quantity
    numpy: Function
    written: CFunction

    def text(self, accuracy: Sequence[str]) -> str:
        """With what is known of it as a comment."""
        shape = self.quantity.shape
        size = f"result[{self.written.outputs[0].size}], " if shape else "A number, "
        order = f"{' x '.join(map(str, shape))} in row-major order, " if len(shape) > 1 else ""
        returns = f"{size}{order}unit {self.quantity.unit_text}."
        return self.written.text(documentation(self.quantity, returns, accuracy))


@dataclass(frozen=True)
class ConversionInC:
    """Mean and covariance of a conversion together.

    Attributes:
        title: what it converts how.
        meaning: of mean and covariance.
        written: the function.
    """

    title: str
    meaning: str
    written: CFunction

    def text(self) -> str:
        """With what it is as a comment."""
        said = f"{self.title}.\n\n{wrapped(f'{self.meaning}.')}\n\nArguments and accuracy are those of the covariance."
        return self.written.text(said)


def conversion_in_c(quantities: Mapping[str, Quantity], model: str, method: str) -> ConversionInC:
    """Derive one conversion.

    Raises:
        KeyError: a part of it is missing.
    """
    found = conversion_of(quantities, model, method)
    outputs = [Output(name, shape) for name, shape in zip(("mean", "covariance"), found.shapes, strict=True)]
    name = f"{PREFIX}{CONVERSIONS}_{found.name}"
    return ConversionInC(found.title, found.meaning, function(name, found.symbols, outputs, found.statements))


def headers(
    quantities: Iterable[QuantityInC], conversions: Sequence[ConversionInC], accuracy: Mapping[str, Sequence[str]]
) -> dict[str, str]:
    """All headers by the names of their files.

    Raises:
        NotWritable: two functions would be called the same.
    """
    families: dict[str, list[QuantityInC]] = {}
    for one in quantities:
        families.setdefault(one.quantity.module, []).append(one)
    every = [one.written for family in families.values() for one in family] + [one.written for one in conversions]
    _refuse_same_names(every)
    found = {c_elementary.NAME: c_elementary.header()}
    for family, members in families.items():
        texts = [one.text(accuracy[one.quantity.name]) for one in members]
        title = f"The quantities {family}.* as C99 functions"
        found[header_name(family)] = _header(family, title, texts, [one.written for one in members])
    if conversions:
        title = "Conversions of plots as C99 functions: mean and covariance together"
        texts = [one.text() for one in conversions]
        found[header_name(CONVERSIONS)] = _header(CONVERSIONS, title, texts, [one.written for one in conversions])
    included = "".join(f'#include "{name}"\n' for name in sorted(found))
    return {ALL: _guarded("", "All derived quantities as C99 functions", sorted_digest(every), included), **found}


def header_name(family: str) -> str:
    """The file of a family."""
    return f"{PREFIX}{family}.h"


def sorted_digest(functions: Iterable[CFunction]) -> str:
    """What identifies the code of functions."""
    return sha256("".join(one.digest for one in functions).encode()).hexdigest()[:16]


def _header(family: str, title: str, texts: Sequence[str], functions: Sequence[CFunction]) -> str:
    inside = f'#include "{c_elementary.NAME}"\n\n' + "\n".join(texts)
    return _guarded(family, title, sorted_digest(functions), inside)


def _guarded(family: str, title: str, digest: str, inside: str) -> str:
    guard = f"RADARTRACK_{family}_H" if family else "RADARTRACK_H"
    said = f"{title}.\n\nWritten by radartrack regenerate, generator {VERSION}, derivation {digest}; not to be edited."
    return f"{in_comment(said)}\n#ifndef {guard}\n#define {guard}\n\n{inside}\n#endif\n"


def _refuse_same_names(functions: Iterable[CFunction]) -> None:
    counted = Counter(name for one in functions for name in one.names)
    twice = [name for name, count in counted.items() if count > 1]
    if twice:
        raise NotWritable(f"two functions would be called {twice[0]}; give one of the models another name")
