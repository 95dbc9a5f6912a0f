"""Reads a formula as one types it: `r**2*exp(-2*sigma_beta**2)*(cosh(sigma_beta**2) - 1)`."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import cache
from typing import cast

from lark import Lark, Token, UnexpectedInput, UnexpectedToken

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.functions import SPELLINGS
from radartrack.derive.formula.limits import check_brackets, check_count
from radartrack.derive.formula.shape import NO_SHAPES, Shape, shape
from radartrack.derive.formula.tree import Call, Constant, Name, Power, Tree, bound_names, parts
from radartrack.derive.formula.unknown_names import check_names, constants, unknown_function, unknown_name
from radartrack.derive.reading.algebra_systems import with_plain_functions, with_plain_letters
from radartrack.derive.reading.characters import check_characters
from radartrack.derive.reading.grammar import Part, TreeBuilder, call, check_decimals, finished, place, trees
from radartrack.derive.reading.joined_equations import Definition, combined
from radartrack.derive.reading.tex.latex_equations import MAX_EQUATIONS
from radartrack.derive.reading.text_hints import hint

_BRACKETS = {"(": ")", "[": "]", "{": "}"}
# P[0,1] = …, f(x) = …
_LEFT_SIDE = re.compile(r"\s*(?P<name>[A-Za-z_]\w*)\s*(?:\[(?P<places>[\w\s,:]*)\]\s*|\([\w\s,]*\)\s*)?=(?!=)")
_PARTING = re.compile(r"(?P<open>[(\[{])|(?P<close>[)\]}])|(?P<comma>[,;])|(?P<line>\n|\b(?:where|with|and)\s)")
_OPERAND = re.compile(r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|(?P<word>[A-Za-z_]\w*(?:\.(?!T\b)[A-Za-z_]\w*)*)")


def read_text(
    text: str,
    names: Collection[str] | None,
    shapes: Mapping[str, Shape] = NO_SHAPES,
    *,
    strangers: bool = False,
    wanted: int = 1,
) -> Tree:
    """Read a formula in these symbols, and `pi`, `e` and `E` where they are not among them.

    Of an equation the right side is read; of several, the ones that the others define. Formulas side by side are a
    vector, with or without brackets.

    Args:
        text: the formula.
        names: the symbols; None where none are known, and every name is let through.
        shapes: of those that stand for arrays.
        strangers: whether names that are not known are let through.
        wanted: of how many numbers it is to be.

    Raises:
        FormulaError: when it is no such formula, or too large.
        ValueError: when one of the names is a function's.
    """
    allowed = check_names(names or ())
    strangers = strangers or names is None
    check_characters(text, allowed)
    whole = text
    try:
        text = with_plain_letters(text)
        brackets = [(found.group(), found.span()) for found in re.finditer(r"[()\[\]{}]", text)]
        text = with_plain_functions(text, brackets, check_brackets(brackets, _BRACKETS), allowed)
        check_count(sum(1 for _ in _OPERAND.finditer(text)) + text.count("|") // 2)
        equations = _equations(text)
        known = None if strangers else allowed | {name for name, _ in equations if name}
        tree = combined([Definition(name, _parse(right, known)) for name, right in equations], wanted)
        tree = _with_transposes(tree, shapes)
        known = allowed | bound_names(tree)
        return finished(tree, lambda node: _resolved(node, known, strangers=strangers), shapes, strangers=strangers)
    except FormulaError as error:
        raise error.within(whole) from None


class _TextBuilder(TreeBuilder):
    def call(self, parts: Sequence[Part]) -> Tree:
        """A function and its arguments in brackets."""
        return call(SPELLINGS[str(parts[0])], trees(parts), place(parts))

    def array(self, parts: Sequence[Part]) -> Tree:
        """Entries of a vector, or rows, in any brackets or none; without square ones 0,5 may be a half."""
        if parts[0] != "[":
            check_decimals(parts)
        return super().array(parts)


@cache
def _parser() -> Lark:
    return Lark.open(
        "text.lark",
        rel_to=__file__,
        parser="lalr",
        lexer="contextual",
        transformer=_TextBuilder(),
        lexer_callbacks={"NAME": _function_or_name},
    )


def _equations(text: str) -> list[tuple[str, str]]:
    """The right sides, each where it stands in the text, with the names left of them; a formula alone has none.

    Commas and the like part formulas only where one of these is an equation: else they part the entries of a vector.

    Raises:
        FormulaError: for more than are read together.
    """
    pieces = [(start, end, _LEFT_SIDE.match(text, start, end)) for start, end in _parted(text)]
    if not any(said for _, _, said in pieces):
        return [("", text.rstrip().rstrip(",;"))]
    found = []
    for start, end, said in pieces:
        begin = said.end() if said else start
        found.append((_left_name(said) if said else "", " " * begin + text[begin:end]))
    if len(found) > MAX_EQUATIONS:
        raise FormulaError(f"at most {MAX_EQUATIONS} equations are read together")
    return found


def _parted(text: str) -> Iterator[Span]:
    """From where to where the formulas go side by side, or on lines or behind words where an equation begins."""
    start = depth = 0
    for sign in _PARTING.finditer(text):
        depth += (sign.lastgroup == "open") - (sign.lastgroup == "close")
        parts = sign.lastgroup == "comma" or (sign.lastgroup == "line" and _LEFT_SIDE.match(text, sign.end()))
        if depth == 0 and parts:
            if text[start : sign.start()].strip():
                yield start, sign.start()
            start = sign.end()
    if text[start:].strip():
        yield start, len(text)


def _left_name(said: re.Match[str]) -> str:
    """The name of what stands left of an equals sign: P[0,1] is P_01."""
    places = [place.strip() for place in (said["places"] or "").split(",")]
    return f"{said['name']}_{''.join(places)}" if len(places) == 2 and all(map(str.isdigit, places)) else said["name"]


def _function_or_name(token: Token) -> Token:
    return token.update(type="FUNCTION") if token in SPELLINGS else token


def _parse(text: str, names: Collection[str] | None) -> Tree:
    try:
        tree: Tree = _parser().parse(text)  # type: ignore[assignment]  # the transformer makes trees of ours
    except UnexpectedInput as error:
        start, end = _fault(error, text)
        if names is not None:
            _check_words(text[:end], text[end:], names)
        raise FormulaError(hint(text[:start], text[start:end], text[end:]), span=(start, end)) from None
    return tree


def _check_words(text: str, after: str, names: Collection[str]) -> None:
    """Refuse the first unknown word of a formula that does not parse: it tells more than the fault."""
    known = {*names, *constants(names)}
    for found in _OPERAND.finditer(text):
        word = found.group("word")
        if word and word not in known | SPELLINGS.keys():
            applied = (text[found.end() :] + after).lstrip().startswith("(")
            raise FormulaError(unknown_function(word) if applied else unknown_name(word, names), span=found.span())


def _fault(error: UnexpectedInput, text: str) -> Span:
    """Where a parser stopped."""
    if not isinstance(error, UnexpectedToken):
        start = cast("int", error.pos_in_stream)
        return start, start + 1
    if error.token.type == "$END":
        return len(text), len(text)
    return place([error.token])


def _with_transposes(tree: Tree, shapes: Mapping[str, Shape]) -> Tree:
    """The tree where a T above an array is no exponent, whatever else T is called."""

    def changed(node: Tree) -> Tree:
        match node:
            case Power(base, Name("T")) if _is_array(base, shapes):
                return Call("transpose", (base,), span=node.span)
        return node

    return rebuild(tree, changed) if any(isinstance(node, Power) for node in parts(tree)) else tree


def _is_array(tree: Tree, shapes: Mapping[str, Shape]) -> bool:
    try:
        return bool(shape(tree, shapes))
    except FormulaError:  # is told when the whole formula is looked at
        return False


def _resolved(node: Tree, names: Collection[str], *, strangers: bool) -> Tree:
    """A name as the symbol or the constant that it means."""
    if not isinstance(node, Name) or node.name in names:
        return node
    if constant := constants(names).get(node.name):
        return Constant(constant, span=node.span)
    if "." in node.name and not any("." in name for name in names):  # names of quantities are not read here
        at = (node.span or (0, 0))[0] + node.name.index(".")
        raise FormulaError(hint(node.name, ".", ""), span=(at, at + 1))
    if strangers:
        return node
    raise FormulaError(unknown_name(node.name, names), span=node.span)
