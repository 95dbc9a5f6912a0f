"""A formula in letters of which nobody has said what they mean."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from contextlib import suppress

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.latex_names import GREEK
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.shape import NO_SHAPES, Shape
from radartrack.derive.formula.tree import Constant, Name, Number, Power, Tree, children, parts
from radartrack.derive.reading.joined_equations import ALL
from radartrack.derive.reading.notation import LATEX, TEXT, read_formula
from radartrack.derive.reading.printed_text import is_printed
from radartrack.derive.reading.tex.latex import latex_name
from radartrack.derive.reading.tex.latex_arguments import AmbiguousArgument

NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_APPLIED = re.compile(r"(?P<name>[^()]+)\(\s*\\?(?P<argument>[A-Za-z_]\w*)\s*\)")
_LATEX_NAME = re.compile(r"(?!.*\^\s*\{?\s*\d).*[\\{]")  # \lambda, R_{11}; a square is no name
_EULER = Constant("e")


def read_loosely(
    formula: str,
    names: Collection[str] = (),
    notation: str = TEXT,
    function: str = "",
    shapes: Mapping[str, Shape] = NO_SHAPES,
    wanted: int = 1,
) -> Tree:
    """A formula in which other names than the known ones may occur, whatever they mean.

    Args:
        formula: as it stands.
        names: those that are known.
        notation: in which it is.
        function: of code, the function that is meant.
        shapes: of the names that stand for arrays.
        wanted: how many numbers it is to be.

    Raises:
        FormulaError: when it cannot be read whatever they mean.
    """
    read = read_formula(formula, notation, names, shapes, strangers=True, function=function, wanted=wanted)
    return _with_letter_e(read.tree, formula)


def possible_trees(formula: str, names: Collection[str] = (), notation: str = TEXT, function: str = "") -> list[Tree]:
    """What a formula may say, the likeliest first, where print leaves open where the arguments of functions end.

    Of several equations or assignments the last three or two may be meant, all on which no other rests, or the last.

    Args:
        formula: as it stands.
        names: those that are known.
        notation: in which it is.
        function: of code, the function that is meant.

    Raises:
        FormulaError: when it cannot be read in any way.
    """
    try:
        last, *others = [read_loosely(formula, names, notation, function, wanted=count) for count in (1, 3, 2, ALL)]
        return [*dict.fromkeys(tree for tree in others if tree != last), last]  # which may be a part of what is meant
    except AmbiguousArgument as error:
        found = []
        for reading in error.readings:
            with suppress(FormulaError):
                found.append(read_loosely(reading, names, LATEX))
        if not found:
            raise
        return found


def plain_formulas(printed: Mapping[str, str]) -> dict[str, str]:
    r"""Formulas by name, all as they are typed: λ and \lambda are lambda, σθ² is sigma_theta**2, and F(t) = t is F.

    What cannot be read stays as it is.
    """
    bare = {name: _without_argument(name, text) for name, text in printed.items()}
    names = {name: (latex_name(one) or one) if _LATEX_NAME.match(one) else _plain(one) for name, one in bare.items()}
    return {names[name]: _plain(text, names.values()) for name, text in printed.items()}


def _without_argument(name: str, text: str) -> str:
    """What stands before a letter in brackets, if the formula is one in this letter."""
    found = _APPLIED.fullmatch(name)
    return found["name"] if found and re.search(rf"(?<![\w.]){found['argument']}(?!\w)", text) else name


def without_variants(formulas: Mapping[str, str]) -> dict[str, str]:
    r"""Typed formulas beside LaTeX, where \varphi is phi: varphi is phi in them too."""
    variants = {name.removeprefix("\\"): other for name, other in GREEK.items() if name.startswith("\\var")}
    word = re.compile(rf"(?<![\w.])(?:{'|'.join(variants)})(?![A-Za-z0-9])")

    def turned(text: str) -> str:
        return word.sub(lambda found: variants[found.group()], text)

    return {turned(name): turned(text) for name, text in formulas.items()}


def _plain(text: str, names: Collection[str] = ()) -> str:
    is_latex = "\\" in text
    if not (is_latex or is_printed(text)):
        return text
    try:
        known = [name for name in names if NAME.fullmatch(name)] if is_latex else ()
        return to_text(read_loosely(text, known, LATEX if is_latex else TEXT))
    except FormulaError:
        return text


def _with_letter_e(tree: Tree, source: str) -> Tree:
    """The tree with the letter e for the constant, where any stands as a letter would, not as the base of a power."""
    if tree != _EULER and not any(_has_letter_e(node) for node in parts(tree)):
        return tree
    return rebuild(tree, lambda node: Name(_spelled(node, source), span=node.span) if node == _EULER else node)


def _has_letter_e(node: Tree) -> bool:
    """Whether the constant stands below a node, other than as the base of a power that is no plain number."""
    if isinstance(node, Power) and not isinstance(node.exponent, Number):
        return node.exponent == _EULER
    return _EULER in children(node)


def _spelled(node: Tree, source: str) -> str:
    printed = source[slice(*node.span)] if node.span else ""
    return printed if printed == "E" else "e"
