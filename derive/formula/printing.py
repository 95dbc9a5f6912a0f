"""Prints a tree, as text or as LaTeX, so that reading it again gives the same tree."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from decimal import Decimal
from itertools import pairwise
from types import MappingProxyType

from radartrack.derive.formula.functions import SQUARED_BY_NAME
from radartrack.derive.formula.latex_names import latex_name
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Constant,
    Entries,
    Name,
    Negation,
    Number,
    Place,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    children,
)

_LATEX_FUNCTIONS = MappingProxyType(
    {"acos": "\\arccos", "asin": "\\arcsin", "atan": "\\arctan", "log": "\\ln"}
    | {name: f"\\{name}" for name in ("cos", "cosh", "cot", "coth", "csc", "exp", "sec", "sin", "sinh", "tan", "tanh")}
)


def to_text(tree: Tree) -> str:
    """The tree as `read_text` reads it."""
    match tree:
        case Number(text) | Constant(text) | Name(text):
            return text
        case Sum(terms):
            return _signed_terms(terms, _text_of_term)
        case Negation(operand):
            return f"-{_text_of_term(operand)}"
        case Product(factors):
            first, *others = factors
            shown = to_text(first) if isinstance(first, Quotient) else _text_of_factor(first)
            return "*".join([shown, *map(_text_of_factor, others)])
        case Quotient(numerator, denominator):
            return f"{_text_of_term(numerator)}/{_text_of_factor(denominator)}"
        case Power(base, exponent):
            shown = f"({to_text(base)})" if isinstance(base, Power) else _text_of_factor(base)
            return f"{shown}**{_text_of_factor(exponent)}"
        case Call():
            return _text_of_call(tree)
        case Array(parts):
            return f"[{_listed(parts)}]"
        case Entries(array, places):
            return f"{_text_of_operand(array)}[{', '.join(map(text_of_place, places))}]"


def _text_of_call(tree: Call) -> str:
    match tree:
        case Call("transpose", (operand,)):
            return f"{_text_of_operand(operand)}.T"
        case Call("expectation", (function, Array(pairs))):
            return f"expectation({to_text(function)}, {{{', '.join(map(_text_of_pair, pairs))}}})"
        case Call(function, parts):
            return f"{function}({_listed(parts)})"


def _listed(trees: Sequence[Tree]) -> str:
    return ", ".join(map(to_text, trees))


def _text_of_operand(tree: Tree) -> str:
    """What a transpose or an index follows."""
    return to_text(tree) if isinstance(tree, Name | Call | Array | Entries) else f"({to_text(tree)})"


def _text_of_pair(pair: Tree) -> str:
    name, value = children(pair)
    return f"{to_text(name)}: {to_text(value)}"


def text_of_place(place: Place) -> str:
    """How entries are picked along one axis."""
    return str(place) if isinstance(place, int) else ":".join("" if end is None else str(end) for end in place)


def _text_of_term(tree: Tree) -> str:
    return f"({to_text(tree)})" if isinstance(tree, Sum | Negation) else to_text(tree)


def _text_of_factor(tree: Tree) -> str:
    return f"({to_text(tree)})" if isinstance(tree, Sum | Negation | Product | Quotient) else to_text(tree)


def to_latex(tree: Tree) -> str:
    r"""The tree as `read_latex` reads it; a column of \(n\) rows of one entry is printed as a vector."""
    match tree:
        case Number() | Constant() | Name():
            return _latex_of_leaf(tree)
        case Sum(terms):
            return _signed_terms(terms, _latex_of_term)
        case Negation(operand):
            return f"-{_latex_of_term(operand)}"
        case Product(factors):
            return _latex_of_product(factors)
        case Quotient(numerator, denominator):
            return f"\\frac{{{to_latex(numerator)}}}{{{to_latex(denominator)}}}"
        case Power(base, exponent):
            return _latex_of_power(base, exponent)
        case Call(function, arguments):
            return _latex_of_call(function, arguments)
        case Array(entries):
            return _latex_of_array(entries)
        case Entries(array, places):
            return f"{_latex_of_factor(array)}_{{{', '.join(map(text_of_place, places))}}}"


def _latex_of_leaf(tree: Number | Constant | Name) -> str:
    match tree:
        case Number(text):
            return _decimal(text)
        case Constant(name):
            return {"pi": "\\pi", "inf": "\\infty"}.get(name, "\\mathrm{e}")
        case Name(name):
            return latex_name(name)


def _latex_of_term(tree: Tree) -> str:
    return _in_brackets(tree) if isinstance(tree, Sum | Negation) else to_latex(tree)


def _latex_of_factor(tree: Tree) -> str:
    return _in_brackets(tree) if isinstance(tree, Sum | Negation | Product) else to_latex(tree)


def _latex_of_product(factors: Sequence[Tree]) -> str:
    shown = _latex_of_factor(factors[0])
    for left, right in pairwise(factors):
        latex = _latex_of_factor(right)
        mixed = isinstance(left, Number) and latex.startswith("\\frac")
        shown += (" \\cdot " if mixed or latex[0].isdigit() else " ") + latex
    return shown


def _latex_of_power(base: Tree, exponent: Tree) -> str:
    match base, exponent:
        case Call(function, arguments), Number(text) if function in SQUARED_BY_NAME and text.isdigit():
            return _latex_of_call(function, arguments, raised=f"^{{{text}}}")
    shown = to_latex(base) if isinstance(base, Number | Constant | Name | Call) else _in_brackets(base)
    return f"{shown}^{{{to_latex(exponent)}}}"


def _latex_of_call(function: str, arguments: Sequence[Tree], raised: str = "") -> str:
    listed = ", ".join(map(to_latex, arguments))
    if function == "sqrt":
        return f"\\sqrt{{{listed}}}"
    if function == "abs":
        return f"\\left|{listed}\\right|"
    if function == "transpose":
        return f"{_latex_of_factor(arguments[0])}^{{\\mathsf{{T}}}}"
    command = _LATEX_FUNCTIONS.get(function, f"\\operatorname{{{function}}}")
    return f"{command}{raised}\\left({listed}\\right)"


def _latex_of_array(entries: Sequence[Tree]) -> str:
    rows = [" & ".join(map(to_latex, row.entries)) if isinstance(row, Array) else to_latex(row) for row in entries]
    return "\\begin{pmatrix} " + " \\\\ ".join(rows) + " \\end{pmatrix}"


def _in_brackets(tree: Tree) -> str:
    return f"\\left({to_latex(tree)}\\right)"


def _signed_terms(terms: Sequence[Tree], show: Callable[[Tree], str]) -> str:
    """Terms with their signs between them, the first one's before it."""
    first, *others = terms
    shown = f"-{show(first.operand)}" if isinstance(first, Negation) else show(first)
    for term in others:
        shown += f" - {show(term.operand)}" if isinstance(term, Negation) else f" + {show(term)}"
    return shown


def _decimal(text: str) -> str:
    """A number without a decimal exponent, which LaTeX would read as a product with e."""
    return (
        text if text.replace(".", "0").isdigit() and text[0] != "." and text[-1] != "." else format(Decimal(text), "f")
    )
