"""The formula book: every quantity typeset, in Markdown that code hosts render."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain, groupby

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import WORKS, Work
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.source import Source
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.stable.quantity_form import legible
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.writing.quantity_text import latex_name
from radartrack.derive.writing.short_formula import plain

LONGEST = 1500  # characters of a quantity; the whole book is rendered up to half a megabyte
LINE = 220
NEW_LINE = " \\\\\n"
LETTERS = {"attenuation": "q", "shortfall": "u"}
INTRODUCTION = """\
# Formula book

Every quantity of the catalogue, in the form in which it is computed: the terms are arranged so that they do not cancel
in floating point. `radartrack show NAME --format latex` prints any of them, whole or one entry, in its own symbols.

For an error covariance $`K`$, $`L = \\tfrac12 \\sum_{ij} K_{ij}\\, \\partial_i \\partial_j`$ is the operator whose
exponential takes the expectation over the errors, $`e^{L} h(\\theta) = \\mathrm{E}\\, h(\\theta + w)`$; $`h`$ is the
map, $`J`$ its Jacobian and $`G`$ its Hessian, and $`C = e^{L}(h h^T) - (e^{L} h)(e^{L} h)^T`$. In the formulas $`q`$ is
an attenuation, $`u = 1 - q`$ its shortfall, and $`a_1, a_2, \\dots`$ are parts that occur more than once.
What is said of a formula *in code* is how far rounding takes the generated function from it.
"""


@dataclass(frozen=True)
class Page:
    """One quantity in the book.

    Attributes:
        quantity: what is typeset.
        formula: the formula in Markdown.
        accuracy: a sentence on the measured error of its generated function.
    """

    quantity: Quantity
    formula: str
    accuracy: str


def book(pages: Sequence[Page]) -> str:
    """All chapters, one a module, with their symbols."""
    names = [page.quantity.name for page in pages]
    chapters = [(module, list(group)) for module, group in groupby(pages, key=lambda page: page.quantity.module)]
    contents = [f"- [{module}](#{module}): {len(group)} quantities" for module, group in chapters]
    texts = [_chapter(module, group, names) for module, group in chapters]
    return "\n".join([INTRODUCTION, *contents, "- [sources](#sources)", *texts, _sources()])


def formula(quantity: Quantity, form: StableForm) -> str:
    """The formula typeset over its intermediates, equal entries once; a long one is only named."""
    definitions, entries = _without_waves(legible(quantity, form))
    names = {symbol: latex_name(symbol) for symbol in quantity.symbols} | _letters(definitions)
    equations = chain(((names[symbol], value) for symbol, value in definitions.items()), _places(entries))
    body = _aligned(equations, names)
    if len(body) > LONGEST:
        return f"Too long to print here: `radartrack show {quantity.name}` does."
    return f"```math\n\\begin{{aligned}}\n{body}\n\\end{{aligned}}\n```"


def _aligned(equations: Iterable[tuple[str, Expr]], names: Mapping[Symbol, str]) -> str:
    """The lines of an aligned block; where it is too long only its beginning, as typesetting takes long."""
    body = ""
    for left, right in equations:
        body += f"{NEW_LINE if body else ''}{left} &= "
        for piece in _pieces(right, names):
            body += piece
            if len(body) > LONGEST:
                return body
    return body


def _letters(definitions: Iterable[Symbol]) -> dict[Symbol, str]:
    """Short names of intermediates: q and u for attenuations and shortfalls, a bar for a complement, else numbered."""
    found: dict[Symbol, str] = {}
    for symbol in definitions:
        kind, _, rest = symbol.name.partition("_")
        if kind in LETTERS:
            found[symbol] = f"{LETTERS[kind]}_{{{' '.join(map(_greek, rest.split('_')))}}}"
        elif kind == "complement":
            found[symbol] = f"\\bar{{{_greek(rest.removeprefix('of_'))}}}"
        else:
            found[symbol] = f"a_{{{sum(name.startswith('a_') for name in found.values()) + 1}}}"
    return found


def _greek(name: str) -> str:
    return latex_name(sp.Symbol(name))


def _without_waves(form: StableForm) -> tuple[dict[Symbol, Expr], Tensor[Expr]]:
    """With sines and cosines where they are used, expm1 as a difference, and no guards."""
    waves = {s: value for s, value in form.definitions.items() if isinstance(value, sp.sin | sp.cos)}
    definitions = {
        symbol: plain(value).xreplace(waves) for symbol, value in form.definitions.items() if symbol not in waves
    }
    return definitions, form.entries.map(lambda entry: plain(entry).xreplace(waves))


def _places(entries: Tensor[Expr]) -> Iterator[tuple[str, Expr]]:
    """Each different entry with the indices at which it stands."""
    places: dict[Expr, list[str]] = {}
    for index, entry in entries.items():
        places.setdefault(entry, []).append(f"[{','.join(map(str, index))}]" if index else "f")
    for entry, where in places.items():
        yield " = ".join(where) if len(where) < 4 or entry != 0 else "\\text{else}", entry


def _pieces(expression: Expr, names: Mapping[Symbol, str]) -> Iterator[str]:
    """An expression in pieces; a long sum goes over several lines."""
    terms = expression.as_ordered_terms() if expression.is_Add else [expression]
    length = 0
    for number, term in enumerate(terms):
        typeset = sp.latex(term, symbol_names=names)
        if number:
            typeset = f"- {typeset[1:].lstrip()}" if typeset.startswith("-") else f"+ {typeset}"
        if length and length + len(typeset) > LINE:
            yield f"{NEW_LINE}&\\quad "
            length = 0
        elif number:
            typeset = f" {typeset}"
        yield typeset
        length += len(typeset)


def _chapter(module: str, pages: Sequence[Page], names: Sequence[str]) -> str:
    symbols = {symbol.name: symbol for page in pages for symbol in page.quantity.symbols}
    table = ["| symbol | | meaning | unit |", "|---|---|---|---|", *map(_row, symbols.values())]
    return "\n".join([f"\n## {module}\n", *table, *(_page(page, names) for page in pages)])


def _sources() -> str:
    """The bibliography, in the order of its keys."""
    return "\n".join(["\n## sources\n", *(f"- {_work(work)}" for work in WORKS.values()), ""])


def _work(work: Work) -> str:
    parts = [f"{work.author} {work.year or ''}".rstrip(), f"*{work.title}*", work.published, _link(work.doi)]
    return ", ".join(part for part in parts if part)


def _link(doi: str) -> str:
    return f"[doi:{doi}](https://doi.org/{doi})" if doi else ""


def _cited(source: Source) -> str:
    """A source, with links to what has a DOI."""
    return ", ".join([str(source), *map(_link, source.dois)])


def _row(symbol: Variable) -> str:
    return f"| `{symbol.name}` | $`{latex_name(symbol)}`$ | {symbol.meaning} | {symbol.unit} |"


def _page(page: Page, names: Sequence[str]) -> str:
    quantity = page.quantity
    shape = f", shape {list(quantity.shape)}" if quantity.shape else ""
    symbols = ", ".join(f"`{symbol.name}`" for symbol in quantity.symbols) or "none"
    related = ", ".join(f"[{name}](#{anchor(name)})" for name in names if are_related(name, quantity.name))
    facts = [
        f"- definition: `{quantity.word}`",
        f"- conditioning: {quantity.conditioning.value}",
        f"- symbols: {symbols}; unit {quantity.unit_text}{shape}",
        f"- source: {_cited(quantity.source)}",
        f"- in code: {page.accuracy}",
        *([f"- related: {related}"] if related else []),
    ]
    title = f"\n### {quantity.name}\n\n{quantity.meaning[0].upper()}{quantity.meaning[1:]}.\n"
    return "\n".join([title, page.formula, "", *facts])


def anchor(name: str) -> str:
    """The anchor that code hosts give a heading: its letters, digits and underscores."""
    return name.replace(".", "")


def are_related(first: str, second: str) -> bool:
    """Whether two names differ in one part: the same quantity of another model, or of another kind."""
    pairs = list(zip(first.split("."), second.split("."), strict=False))
    return first.count(".") == second.count(".") and sum(a != b for a, b in pairs) == 1
