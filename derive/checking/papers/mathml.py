"""Formulas as MathML, which browsers typeset by themselves."""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape
from itertools import pairwise
from typing import Any

from radartrack.derive.checking.papers.claims_file import Claim
from radartrack.derive.checking.reporting.verdict import Verdict
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.functions import SPELLINGS
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
from radartrack.derive.reading.text import read_text

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η", "theta": "θ",
    "iota": "ι", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "pi": "π", "rho": "ρ", "sigma": "σ",
    "tau": "τ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω", "Delta": "Δ", "Sigma": "Σ",
    "rdot": "ṙ", "mean": "mean", "predicted": "predicted",
}  # fmt: skip
THIN = '<mspace width="0.167em"/>'  # around functions: sin α cos β
APPLY, TIMES, MINUS = "<mo>&#x2061;</mo>", "<mo>&#x2062;</mo>", "<mo>−</mo>"
SQUARED_BY_NAME = {"sin", "cos", "tan", "sinh", "cosh", "tanh"}
LONGEST = 4000


def formulas(claim: Claim, verdict: Verdict) -> dict[str, Any]:
    """The printed and the derived formula and the suggestions, typeset where they are formulas."""
    return {
        "printed_mathml": mathml(verdict.printed) if claim.is_formula else "",
        "derived_mathml": mathml(verdict.derived) if claim.is_formula else "",
        "suggestions_mathml": [mathml(suggestion.formula) for suggestion in verdict.suggestions],
    }


def mathml(text: str) -> str:
    """A formula as a MathML element; nothing when it is none, or too long to typeset."""
    names = set(re.findall(r"[A-Za-z_]\w*", text)) - SPELLINGS.keys() - {"pi", "e"}
    try:
        tree = read_text(text, names) if len(text) <= LONGEST else None
    except FormulaError:
        return ""
    return f'<math display="block">{element(tree)}</math>' if tree is not None else ""


def element(tree: Tree) -> str:
    """One tree as MathML."""
    match tree:
        case Number() | Constant() | Name():
            return _atom(tree)
        case Sum(terms):
            return _row(*(_term(term, first=not place) for place, term in enumerate(terms)))
        case Product(factors):
            return _product(factors)
        case Quotient(numerator, denominator):
            return f"<mfrac>{element(numerator)}{element(denominator)}</mfrac>"
        case Negation(operand):
            return _row(MINUS, _bracketed(operand) if isinstance(operand, Sum | Negation) else element(operand))
        case Power(base, exponent):
            return _power(base, exponent)
        case Call(function, arguments):
            return _call(function, arguments)
        case Array(entries):
            return _array(entries)
        case Entries(array, places):
            shown = ", ".join(map(text_of_place, places))
            return f"<msub>{_factor(array)}<mrow><mtext>{shown}</mtext></mrow></msub>"


def _atom(tree: Number | Constant | Name) -> str:
    if isinstance(tree, Number):
        return f"<mn>{escape(tree.text)}</mn>"
    if isinstance(tree, Name):
        return _name(tree.name)
    return _CONSTANTS[tree.name]


_CONSTANTS = {"pi": "<mi>π</mi>", "e": '<mi mathvariant="normal">e</mi>', "inf": "<mi>∞</mi>"}


def _row(*parts: str) -> str:
    return f"<mrow>{''.join(parts)}</mrow>"


def _bracketed(tree: Tree) -> str:
    return _row("<mo>(</mo>", element(tree), "<mo>)</mo>")


def _term(term: Tree, *, first: bool) -> str:
    if isinstance(term, Negation):
        operand = term.operand
        return MINUS + (_bracketed(operand) if isinstance(operand, Sum | Negation) else element(operand))
    shown = _bracketed(term) if isinstance(term, Sum) else element(term)
    return shown if first else f"<mo>+</mo>{shown}"


def _product(factors: Sequence[Tree]) -> str:
    parts = [_factor(factors[0])]
    for before, factor in pairwise(factors):
        parts += [TIMES, THIN if _is_named(before) or _is_named(factor) else "", _factor(factor)]
    return _row(*parts)


def _factor(factor: Tree) -> str:
    return _bracketed(factor) if isinstance(factor, Sum | Negation) else element(factor)


def _is_named(tree: Tree) -> bool:
    """Whether it is a function written with its name, or a power of one."""
    call = tree.base if isinstance(tree, Power) else tree
    return isinstance(call, Call) and call.function not in {"sqrt", "abs", "exp"}


def _power(base: Tree, exponent: Tree) -> str:
    match base:
        case Call(function, (argument,)) if function in SQUARED_BY_NAME and isinstance(exponent, Number):
            return _applied(f"<msup><mi>{function}</mi>{element(exponent)}</msup>", argument)
        case Name(name):
            return _name(name, element(exponent))
        case Number() | Constant():
            return f"<msup>{element(base)}{element(exponent)}</msup>"
        case _:
            return f"<msup>{_bracketed(base)}{element(exponent)}</msup>"


def _call(function: str, arguments: tuple[Tree, ...]) -> str:
    if function == "sqrt":
        return f"<msqrt>{element(arguments[0])}</msqrt>"
    if function == "abs":
        return _row("<mo>|</mo>", element(arguments[0]), "<mo>|</mo>")
    if function == "transpose":
        return f"<msup>{_factor(arguments[0])}<mi>T</mi></msup>"
    if function == "exp":
        return f'<msup><mi mathvariant="normal">e</mi>{element(arguments[0])}</msup>'
    if len(arguments) == 1:
        return _applied(f"<mi>{function}</mi>", arguments[0])
    inside = "<mo>,</mo>".join(map(element, arguments))
    return _row(f"<mi>{function}</mi>", APPLY, "<mo>(</mo>", inside, "<mo>)</mo>")


def _applied(function: str, argument: Tree) -> str:
    if isinstance(argument, Name | Number):
        return _row(function, APPLY, THIN, element(argument))
    return _row(function, APPLY, _bracketed(argument))


def _array(entries: tuple[Tree, ...]) -> str:
    rows = [entry.entries if isinstance(entry, Array) else (entry,) for entry in entries]
    cells = ("".join(f"<mtd>{element(cell)}</mtd>" for cell in row) for row in rows)
    table = "".join(f"<mtr>{row}</mtr>" for row in cells)
    return f'<mtable class="array">{table}</mtable>'


def _name(name: str, power: str = "") -> str:
    """A letter with what stands below it, and above; dtheta_1 is a d before θ₁."""
    base, *below = name.split("_")
    if base[0] == "d" and base not in GREEK and (base[1:] in GREEK or len(base) == 2):
        return _row(_letter("d"), _name(name[1:], power))
    letter = _letter(base)
    if not below:
        return f"<msup>{letter}{power}</msup>" if power else letter
    index = _row("<mo>,</mo>".join(map(_letter, below)))
    return f"<msubsup>{letter}{index}{power}</msubsup>" if power else f"<msub>{letter}{index}</msub>"


def _letter(word: str) -> str:
    return f"<mi>{escape(GREEK.get(word, word))}</mi>"
