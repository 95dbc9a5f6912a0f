"""Formulas as MathML, which browsers typeset by themselves."""

from __future__ import annotations

import re
from html import escape
from typing import Any

from radartrack.derive.checking.claims import Claim
from radartrack.derive.checking.verdict import Verdict
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.functions import SPELLINGS
from radartrack.derive.formula.text import read_text
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Constant,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
)

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η", "theta": "θ",
    "iota": "ι", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "pi": "π", "rho": "ρ", "sigma": "σ",
    "tau": "τ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω", "Delta": "Δ", "Sigma": "Σ",
    "rdot": "ṙ", "mean": "mean", "predicted": "predicted",
}  # fmt: skip
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
            return _row(TIMES.join(map(_factor, factors)))
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


def _atom(tree: Number | Constant | Name) -> str:
    if isinstance(tree, Number):
        return f"<mn>{escape(tree.text)}</mn>"
    if isinstance(tree, Name):
        return _name(tree.name)
    return "<mi>π</mi>" if tree.name == "pi" else '<mi mathvariant="normal">e</mi>'


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


def _factor(factor: Tree) -> str:
    return _bracketed(factor) if isinstance(factor, Sum | Negation) else element(factor)


def _power(base: Tree, exponent: Tree) -> str:
    if isinstance(base, Call) and base.function in SQUARED_BY_NAME and isinstance(exponent, Number):
        raised = f"<msup><mi>{base.function}</mi>{element(exponent)}</msup>"
        return _row(raised, APPLY, _argument(base.arguments[0]))
    simple = isinstance(base, Name | Number | Constant)
    return f"<msup>{element(base) if simple else _bracketed(base)}{element(exponent)}</msup>"


def _call(function: str, arguments: tuple[Tree, ...]) -> str:
    if function == "sqrt":
        return f"<msqrt>{element(arguments[0])}</msqrt>"
    if function == "abs":
        return _row("<mo>|</mo>", element(arguments[0]), "<mo>|</mo>")
    if function == "exp":
        return f'<msup><mi mathvariant="normal">e</mi>{element(arguments[0])}</msup>'
    if len(arguments) == 1:
        return _row(f"<mi>{function}</mi>", APPLY, _argument(arguments[0]))
    inside = "<mo>,</mo>".join(map(element, arguments))
    return _row(f"<mi>{function}</mi>", APPLY, "<mo>(</mo>", inside, "<mo>)</mo>")


def _argument(tree: Tree) -> str:
    return element(tree) if isinstance(tree, Name | Number) else _bracketed(tree)


def _array(entries: tuple[Tree, ...]) -> str:
    rows = [entry.entries if isinstance(entry, Array) else (entry,) for entry in entries]
    cells = ("".join(f"<mtd>{element(cell)}</mtd>" for cell in row) for row in rows)
    table = "".join(f"<mtr>{row}</mtr>" for row in cells)
    return _row("<mo>(</mo>", f"<mtable>{table}</mtable>", "<mo>)</mo>")


def _name(name: str) -> str:
    base, *below = name.split("_")
    letter = _letter(base)
    if not below:
        return letter
    return f"<msub>{letter}{_row('<mo>,</mo>'.join(map(_letter, below)))}</msub>"


def _letter(word: str) -> str:
    return f"<mi>{escape(GREEK.get(word, word))}</mi>"
