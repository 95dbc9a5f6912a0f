"""Formulas as MathML, which browsers typeset by themselves."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence
from html import escape
from itertools import pairwise
from typing import Any

from radartrack.derive.checking.papers.claim import Claim
from radartrack.derive.checking.reporting.verdict import Suggestion, Verdict
from radartrack.derive.formula.differing_parts import differing_parts
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
    Path,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    children,
    subtree,
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
DIFFERENT = "different"  # the class of a part in which a formula differs from another one
LONGEST = 4000


def formulas(claim: Claim, verdict: Verdict) -> dict[str, Any]:
    """The printed and the derived formula and the suggestions, typeset where they are formulas.

    In what is printed, that part stands out which the first suggestion changes; in each suggestion, what it changes.
    """
    if not claim.is_formula:
        return {"printed_mathml": "", "derived_mathml": "", "suggestions_mathml": [""] * len(verdict.suggestions)}
    printed = tree_of(verdict.printed)
    typeset = [_suggested(printed, suggestion) for suggestion in verdict.suggestions]
    wrong = typeset[0][1] if typeset else ()
    return {
        "printed_mathml": block(printed, wrong) if printed is not None else "",
        "derived_mathml": mathml(verdict.derived),
        "suggestions_mathml": [shown for shown, _ in typeset],
    }


def _suggested(printed: Tree | None, suggestion: Suggestion) -> tuple[str, frozenset[Path]]:
    """A suggestion typeset, and the paths of what it changes in what is printed."""
    tree = tree_of(suggestion.formula)
    if tree is None or isinstance(tree, Name):  # the name of another quantity has no formula beside the printed one
        return (block(tree) if tree is not None else ""), frozenset()
    if printed is None or suggestion.definition:
        return block(tree), frozenset()
    entry = suggestion.entry
    try:
        before = subtree(printed, entry)
    except IndexError:  # a vector printed as a matrix of one column, and the like
        return block(tree), frozenset()
    theirs, ours = differing_parts(before, tree)
    return block(tree, ours), frozenset((*entry, *path) for path in theirs)


def mathml(text: str, differing: Iterable[Path] = ()) -> str:
    """A formula as a MathML element; nothing when it is none, or too long to typeset.

    Args:
        text: as it was read.
        differing: the paths of parts of its tree that stand out.
    """
    tree = tree_of(text)
    return block(tree, differing) if tree is not None else ""


def block(tree: Tree, differing: Iterable[Path] = ()) -> str:
    """A tree as a MathML element of its own."""
    return f'<math display="block">{element(tree, differing)}</math>'


def tree_of(text: str) -> Tree | None:
    """The tree of a formula that was read before; None when it is none, or too long to typeset."""
    if len(text) > LONGEST:
        return None
    names = set(re.findall(r"[A-Za-z_]\w*", text)) - SPELLINGS.keys() - {"pi", "e"}
    try:
        return read_text(text, names)
    except FormulaError:
        return None


def element(tree: Tree, differing: Iterable[Path] = ()) -> str:
    """One tree as MathML."""
    return _Typesetting(frozenset(differing)).element(tree, ())


class _Typesetting:
    """How a tree is typeset, some parts of which stand out.

    Args:
        differing: the paths of these parts.
    """

    def __init__(self, differing: Collection[Path]) -> None:
        self._differing = differing

    def element(self, tree: Tree, path: Path) -> str:
        """One part."""
        shown = self._plain(tree, path)
        return f'<mrow class="{DIFFERENT}">{shown}</mrow>' if path in self._differing else shown

    def _plain(self, tree: Tree, path: Path) -> str:
        match tree:
            case Number() | Constant() | Name():
                return _atom(tree)
            case Sum(terms):
                return _row(*(self._term(term, (*path, place)) for place, term in enumerate(terms)))
            case Product(factors):
                return self._product(factors, path)
            case Quotient():
                return f"<mfrac>{''.join(self._below(tree, path))}</mfrac>"
            case Negation(operand):
                return _row(MINUS, self._factor(operand, (*path, 0)))
            case Power(base, exponent):
                return self._power(base, exponent, path)
            case Call(function):
                return self._call(function, tree, path)
            case Array(entries):
                return self._array(entries, path)
            case Entries(array, places):
                shown = ", ".join(map(text_of_place, places))
                return f"<msub>{self._factor(array, (*path, 0))}<mrow><mtext>{shown}</mtext></mrow></msub>"

    def _below(self, tree: Tree, path: Path) -> list[str]:
        return [self.element(child, (*path, place)) for place, child in enumerate(children(tree))]

    def _bracketed(self, tree: Tree, path: Path) -> str:
        return _row("<mo>(</mo>", self.element(tree, path), "<mo>)</mo>")

    def _term(self, term: Tree, path: Path) -> str:
        """A term with its sign, which stands out with it."""
        if isinstance(term, Negation):
            shown = MINUS + self._factor(term.operand, (*path, 0))
        else:
            shown = self._bracketed(term, path) if isinstance(term, Sum) else self._plain(term, path)
            shown = shown if path[-1] == 0 else f"<mo>+</mo>{shown}"
        return f'<mrow class="{DIFFERENT}">{shown}</mrow>' if path in self._differing else shown

    def _product(self, factors: Sequence[Tree], path: Path) -> str:
        parts = [self._factor(factors[0], (*path, 0))]
        for place, (before, factor) in enumerate(pairwise(factors), start=1):
            thin = THIN if _is_named(before) or _is_named(factor) else ""
            parts += [TIMES, thin, self._factor(factor, (*path, place))]
        return _row(*parts)

    def _factor(self, factor: Tree, path: Path) -> str:
        return self._bracketed(factor, path) if isinstance(factor, Sum | Negation) else self.element(factor, path)

    def _power(self, base: Tree, exponent: Tree, path: Path) -> str:
        above = self.element(exponent, (*path, 1))
        stands_out = (*path, 0) in self._differing
        match base:
            case Call(function, (argument,)) if (
                function in SQUARED_BY_NAME and isinstance(exponent, Number) and not stands_out
            ):
                return self._applied(f"<msup><mi>{function}</mi>{above}</msup>", argument, (*path, 0, 0))
            case Name(name) if not stands_out:
                return _name(name, above)
            case Number() | Constant() | Name():
                return f"<msup>{self.element(base, (*path, 0))}{above}</msup>"
            case _:
                return f"<msup>{self._bracketed(base, (*path, 0))}{above}</msup>"

    def _call(self, function: str, call: Tree, path: Path) -> str:
        arguments = self._below(call, path)
        match function:
            case "sqrt":
                return f"<msqrt>{arguments[0]}</msqrt>"
            case "abs":
                return _row("<mo>|</mo>", arguments[0], "<mo>|</mo>")
            case "transpose":
                return f"<msup>{self._factor(children(call)[0], (*path, 0))}<mi>T</mi></msup>"
            case "exp":
                return f'<msup><mi mathvariant="normal">e</mi>{arguments[0]}</msup>'
        if len(arguments) == 1:
            return self._applied(f"<mi>{function}</mi>", children(call)[0], (*path, 0))
        return _row(f"<mi>{function}</mi>", APPLY, "<mo>(</mo>", "<mo>,</mo>".join(arguments), "<mo>)</mo>")

    def _applied(self, function: str, argument: Tree, path: Path) -> str:
        if isinstance(argument, Name | Number):
            return _row(function, APPLY, THIN, self.element(argument, path))
        return _row(function, APPLY, self._bracketed(argument, path))

    def _array(self, entries: tuple[Tree, ...], path: Path) -> str:
        rows = (
            self._below(entry, (*path, place)) if isinstance(entry, Array) else [self.element(entry, (*path, place))]
            for place, entry in enumerate(entries)
        )
        table = "".join(f"<mtr>{''.join(f'<mtd>{cell}</mtd>' for cell in row)}</mtr>" for row in rows)
        return f'<mtable class="array">{table}</mtable>'


def _atom(tree: Number | Constant | Name) -> str:
    if isinstance(tree, Number):
        return f"<mn>{escape(tree.text)}</mn>"
    if isinstance(tree, Name):
        return _name(tree.name)
    return _CONSTANTS[tree.name]


_CONSTANTS = {"pi": "<mi>π</mi>", "e": '<mi mathvariant="normal">e</mi>', "inf": "<mi>∞</mi>"}


def _row(*parts: str) -> str:
    return f"<mrow>{''.join(parts)}</mrow>"


def _is_named(tree: Tree) -> bool:
    """Whether it is a function written with its name, or a power of one."""
    call = tree.base if isinstance(tree, Power) else tree
    return isinstance(call, Call) and call.function not in {"sqrt", "abs", "exp"}


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
