"""Prints a tree as it would be typeset, in one line of text: r² σ_β² sin²(β)."""

from __future__ import annotations

from collections.abc import Sequence

from radartrack.derive.formula.functions import SQUARED_BY_NAME
from radartrack.derive.formula.latex_names import GREEK
from radartrack.derive.formula.printing import text_of_place
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Constant,
    Entries,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
)

_LETTERS = dict(
    zip(GREEK.values(), "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΥΦΨΩ", strict=False)
)  # variants of letters come last there
_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def to_typeset(tree: Tree) -> str:
    """The tree for the eye: Greek letters, raised exponents, products without a sign where none is needed."""
    match tree:
        case Number() | Constant() | Name():
            return _leaf(tree)
        case Sum(terms):
            return _sum(terms)
        case Negation(operand):
            return f"−{_in_term(operand)}"
        case Product(factors):
            return _product([_factor(factor) for factor in factors])
        case Quotient(numerator, denominator):
            return f"{_in_term(numerator)}/{_factor(denominator)}"
        case Power(base, exponent):
            return _power(base, exponent)
        case Call(function, arguments):
            return _call(function, arguments)
        case Array(entries):
            return f"[{', '.join(map(to_typeset, entries))}]"
        case Entries(array, places):
            return f"{_factor(array)}[{', '.join(map(text_of_place, places))}]"


def _leaf(tree: Number | Constant | Name) -> str:
    match tree:
        case Number(text):
            return text
        case Constant(name):
            return {"pi": "π", "inf": "∞"}.get(name, name)
        case Name(name):
            return _name(name)


def _sum(terms: Sequence[Tree]) -> str:
    shown = _term(terms[0])
    for term in terms[1:]:
        shown += f" − {_term(term.operand)}" if isinstance(term, Negation) else f" + {_term(term)}"
    return shown


def _call(function: str, arguments: Sequence[Tree]) -> str:
    if function == "transpose":
        return f"{_factor(arguments[0])}ᵀ"
    return f"{'√' if function == 'sqrt' else function}({', '.join(map(to_typeset, arguments))})"


def _name(name: str) -> str:
    return "_".join(_LETTERS.get(part, part) for part in name.split("_"))


def _term(tree: Tree) -> str:
    return f"−{_in_term(tree.operand)}" if isinstance(tree, Negation) else _in_term(tree)


def _in_term(tree: Tree) -> str:
    return f"({to_typeset(tree)})" if isinstance(tree, Sum | Negation) else to_typeset(tree)


def _factor(tree: Tree) -> str:
    return f"({to_typeset(tree)})" if isinstance(tree, Sum | Negation | Product | Quotient) else to_typeset(tree)


def _product(factors: list[str]) -> str:
    shown = factors[0]
    for factor in factors[1:]:
        shown += (" · " if factor[0].isdigit() else " ") + factor
    return shown


def _power(base: Tree, exponent: Tree) -> str:
    raised = _digits(exponent)
    if raised and isinstance(base, Call) and base.function in SQUARED_BY_NAME:
        return f"{base.function}{raised}({', '.join(map(to_typeset, base.arguments))})"
    shown = f"({to_typeset(base)})" if isinstance(base, Power | Quotient | Product | Sum | Negation) else _factor(base)
    return f"{shown}{raised}" if raised else f"{shown}^({to_typeset(exponent)})"


def _digits(exponent: Tree) -> str:
    """A whole exponent, raised."""
    match exponent:
        case Number(text) if text.isdigit():
            return text.translate(_RAISED)
        case Negation(Number(text)) if text.isdigit():
            return f"-{text}".translate(_RAISED)
        case _:
            return ""
