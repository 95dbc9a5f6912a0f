"""A quantity for people to read: as text that the formula reader takes back, as LaTeX, as NumPy code, and as C."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from radartrack.derive import symbolic as sp
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index, Tensor, nested
from radartrack.derive.stable.quantity_form import form_of, readable
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.writing.c99 import c_elementary
from radartrack.derive.writing.c99.c_expression import CExpression, in_listing
from radartrack.derive.writing.c99.c_function import listing
from radartrack.derive.writing.common_subexpressions import with_common_parts
from radartrack.derive.writing.computed_statements import Statements, beside, joined
from radartrack.derive.writing.numpy_expression import code
from radartrack.derive.writing.numpy_writer import helpers
from radartrack.derive.writing.short_formula import LONG, plain, printed, short

NOTHING_GIVEN: Mapping[Symbol, Expr] = MappingProxyType({})

LATEX_NAMES = {
    "r": "r",
    "rdot": r"\dot{r}",
    "epsilon": r"\varepsilon",
}


def heading(quantity: Quantity) -> list[str]:
    """Name, meaning, definition, conditioning, source, and the symbols with their units and domains."""
    return [
        f"{quantity.name}: {quantity.meaning}",
        f"definition:   {quantity.word}",
        f"conditioning: {quantity.conditioning.value}",
        f"source:       {quantity.source.reference}",
        f"unit:         {quantity.unit_text}",
        *(f"{s.name}: {s.meaning} [{s.unit}], {s.low:.5g} to {s.high:.5g}" for s in quantity.symbols),
    ]


def text(quantity: Quantity, index: Index | None = None, given: Mapping[Symbol, Expr] = NOTHING_GIVEN) -> str:
    """The formula as the checker reads it; a whole tensor as nested lists."""
    return nested(_wanted(quantity, index, given).map(printed))


def latex(quantity: Quantity, index: Index | None = None, given: Mapping[Symbol, Expr] = NOTHING_GIVEN) -> str:
    """The formula typeset; vectors and matrices as such, higher tensors as a row of matrices."""
    names = {symbol: latex_name(symbol) for symbol in quantity.symbols}
    entries = _wanted(quantity, index, given).map(lambda entry: sp.latex(entry, symbol_names=names))
    return _matrix(entries) if entries.shape else entries.entries[0]


def _wanted(quantity: Quantity, index: Index | None, given: Mapping[Symbol, Expr]) -> Tensor[Expr]:
    """What is to be printed, each entry as short as it is known: a long derivation in the form that code has."""
    derived = quantity.expression
    wanted = derived if index is None else Tensor((), (derived[index],))
    if given:
        return wanted.map(lambda entry: short(entry.xreplace(dict(given))))
    if all(len(printed(plain(entry))) <= LONG for entry in wanted):
        return wanted.map(short)
    form = readable(quantity)
    written = form if index is None else Tensor((), (form[index],))
    pairs = zip(wanted.entries, written.entries, strict=True)
    return Tensor(wanted.shape, tuple(min(short(a), plain(b), key=lambda one: len(printed(one))) for a, b in pairs))


def python(quantity: Quantity, index: Index | None = None) -> str:
    """NumPy statements that run where the symbols have values; the last ones compute the entries asked for."""
    statements, shape = _computed(quantity, index)
    lines = [f"{name} = {code(definition)}" for name, definition in statements.definitions]
    lines.append(f"result = {nested(Tensor(shape, statements.results).map(code))}")
    helper = helpers("\n".join(lines))
    return "\n".join(["import numpy as np\n", *(["Floats = np.ndarray | float", helper, ""] if helper else []), *lines])


def c(quantity: Quantity, index: Index | None = None) -> str:
    """A C99 function over math.h, with the helpers that it calls."""
    statements, shape = _computed(quantity, index)
    name = "_".join([quantity.module, quantity.function, *map(str, index or ())])
    symbols = [symbol.name for symbol in quantity.symbols]
    written = listing(statements, symbols, name, shape, CExpression(name_of=in_listing))
    return (
        "\n".join(["#include <math.h>\n", c_elementary.helpers("", "", written), written])
        .replace("\n\n\n", "\n\n")
        .rstrip()
    )


def _computed(quantity: Quantity, index: Index | None) -> tuple[Statements, Index]:
    """The statements of all entries or of one, and their shape."""
    form = form_of(quantity)
    wanted = form.entries if index is None else Tensor((), (form.entries[index],))
    kept = beside(form.only(wanted), quantity)
    return joined(*with_common_parts(kept.definitions, kept.entries)), wanted.shape


def latex_name(symbol: Symbol) -> str:
    """A symbol as printed in the literature: sigma_r, rdot, predicted_sigma_beta."""
    first, _, rest = symbol.name.partition("_")
    if first == "predicted":
        return f"{latex_name(sp.Symbol(rest))}^{{p}}"
    base = LATEX_NAMES.get(first, sp.latex(sp.Symbol(first)))
    return f"{base}_{{{latex_name(sp.Symbol(rest))}}}" if rest else base


def _matrix(entries: Tensor[str]) -> str:
    """The last axis along the row; leading axes beyond the second as one matrix after another."""
    if len(entries.shape) > 2:
        return " \\quad\n".join(_matrix(part) for part in entries.parts())
    rows = [" & ".join(row.entries) for row in entries.parts()] if len(entries.shape) == 2 else entries.entries
    body = " \\\\\n".join(rows)
    return f"\\begin{{pmatrix}}\n{body}\n\\end{{pmatrix}}"
