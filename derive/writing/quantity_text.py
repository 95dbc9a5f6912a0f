"""A quantity for people to read: as text that the formula reader takes back, as LaTeX, and as NumPy code."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from radartrack.derive import symbolic as sp
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index, Tensor, nested
from radartrack.derive.stable.quantity_form import form_of, readable
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.writing.common_subexpressions import with_common_parts
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
    """Name, meaning, definition, conditioning, source, and the symbols with their units."""
    return [
        f"{quantity.name}: {quantity.meaning}",
        f"definition:   {quantity.word}",
        f"conditioning: {quantity.conditioning.value}",
        f"source:       {quantity.source.reference}",
        f"unit:         {quantity.unit_text}",
        *(f"{symbol.name}: {symbol.meaning} [{symbol.unit}]" for symbol in quantity.symbols),
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
    form = form_of(quantity)
    wanted = form.entries if index is None else Tensor((), (form.entries[index],))
    definitions, results = with_common_parts(form.only(wanted).definitions, wanted)
    lines = [f"{symbol.name} = {code(definition)}" for symbol, definition in definitions.items()]
    lines.append(f"result = {nested(Tensor(wanted.shape, tuple(results)).map(code))}")
    helper = helpers("\n".join(lines))
    return "\n".join(["import numpy as np\n", *(["Floats = np.ndarray | float", helper, ""] if helper else []), *lines])


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
