"""What to write instead of what the grammar of LaTeX does not read."""

from __future__ import annotations

from collections.abc import Sequence

from lark import Token

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.reading.tex.latex_arguments import AmbiguousArgument

_OPENERS = frozenset({"LPAR", "LBRACE", "LBAR", "LINDEX", "BEGIN"})
_CLOSERS = frozenset({"RPAR", "RBRACE", "RBAR", "RINDEX", "END"})
_SEPARATORS = frozenset({"PLUS", "MINUS", "COMMA", "AMPERSAND", "NEWLINE"})
_ENCLOSING = frozenset({"LPAR", "LBAR", "BEGIN", "TIMES"})  # what ends the argument of a function
_BETWEEN = frozenset({"PLUS", "MINUS", "TIMES", "SLASH"})


def refusal(tokens: Sequence[Token], at: int, span: Span) -> FormulaError:
    """What is wrong at the token where the parser stopped, or at the end, and what to write instead."""
    before = tokens[at - 1] if at else None
    now = tokens[at] if at < len(tokens) else None
    if before is not None and before.type == "FUNCTION":
        return FormulaError(f"put the argument of \\{before} in brackets: \\{before}(...)", span=span)
    match _left_open(tokens, at):
        case Token(type="FUNCTION") as function:
            words = f"where the argument of \\{function} ends is ambiguous: put it in brackets, \\{function}(...)"
            return AmbiguousArgument(words, span=span)
        case Token(type="SLASH"):
            words = "what is divided by what is ambiguous after a slash: write \\frac{...}{...} or brackets"
            return FormulaError(words, span=span)
    return FormulaError(_sign(tokens, at) or _other(before, now), span=span)


def _left_open(tokens: Sequence[Token], at: int) -> Token | None:
    """A function or a slash to the left that may go on here, within the same term and brackets."""
    if at >= len(tokens) or tokens[at].type in _SEPARATORS | _CLOSERS:
        return None
    enclosed = False
    for token in _term_before(tokens, at):
        enclosed |= token.type in _ENCLOSING
        if token.type == "SLASH" or (token.type == "FUNCTION" and not enclosed):
            return token
    return None


def _term_before(tokens: Sequence[Token], at: int) -> Sequence[Token]:
    """The tokens of the same term to the left, nearest first, without what is in brackets."""
    found: list[Token] = []
    depth = 0
    for token in reversed(tokens[:at]):
        depth += (token.type in _CLOSERS) - (token.type in _OPENERS)
        if depth < 0 or (depth == 0 and token.type in _SEPARATORS):
            break
        if depth == 0:
            found.append(token)
    return found


def _sign(tokens: Sequence[Token], at: int) -> str | None:
    now = tokens[at].type if at < len(tokens) else ""
    before = tokens[at - 1].type if at else ""
    if now in {"PLUS", "MINUS"} and before in _BETWEEN:
        return "two signs stand side by side: put what follows in brackets"
    if now in _BETWEEN and before not in _OPENERS | _SEPARATORS | _BETWEEN:
        return "braces are not printed: write \\left( ... \\right) around a sum or product"
    if now == "COMMA":
        decimal = before == "NUMBER" or (before == "LBRACE" and tokens[at - 2].type == "NUMBER")
        return "decimals follow a point" if decimal else "a comma stands only between a function's arguments"
    return None


def _other(before: Token | None, now: Token | None) -> str:
    if now is None:
        return "the formula ends too early"
    if now.type == "NUMBER":
        return "a number stands behind a factor: write it before the others, or \\cdot"
    if now.type == "RAISED":
        return "an exponent stands here without a base, or behind another one"
    if now.type in {"AMPERSAND", "NEWLINE"}:
        return "& and \\\\ stand only inside a matrix"
    if before is None or before.type in _OPENERS | _SEPARATORS | _BETWEEN:
        return f"a value is missing before {now}"
    return f"{now} has no meaning here"
