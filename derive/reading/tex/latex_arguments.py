r"""Functions without brackets before several factors: the argument of \cos\beta c may end behind beta, or behind c."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice, product
from math import prod

from lark import Token

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.reading.tex.latex_phases import TURNING, behind_power

MOST_READINGS = 12
_FACTORS = frozenset({"CONSTANT", "FRACTION", "NAME", "NUMBER", "ROOT"})  # with which an argument may begin
_MORE_FACTORS = _FACTORS | {"LPAR"}
_GROUPS = {"FRACTION": 2, "ROOT": 1}  # in braces, behind what they belong to
_OPENING, _CLOSING = frozenset({"LBRACE", "LINDEX", "LPAR"}), frozenset({"RBRACE", "RINDEX", "RPAR"})


class AmbiguousArgument(FormulaError):
    """A formula in which arguments of functions may end at several places.

    Attributes:
        readings: all that it may say, in LaTeX with brackets, the shortest arguments first; nothing of too many.
    """

    def __init__(
        self, message: str, source: str = "", span: Span | None = None, readings: tuple[str, ...] = ()
    ) -> None:
        super().__init__(message, source, span)
        self.args = (message, source, span, readings)  # with all four the error can be pickled
        self.readings = readings

    def at(self, source: str, span: Span | None) -> FormulaError:
        """The same error at a place of this formula."""
        return AmbiguousArgument(self.message, source, span, self.readings)

    def read_as(self, readings: tuple[str, ...]) -> FormulaError:
        """The same error with what the formula may say."""
        return AmbiguousArgument(self.message, self.source, self.span, readings)


@dataclass(frozen=True)
class _Argument:
    """An argument without brackets: the token that it begins with, and those behind which it may end."""

    first: int
    ends: tuple[int, ...]

    def kind(self, tokens: Sequence[Token]) -> tuple[str, ...]:
        r"""Its first factors: where \sin\beta r ends, \cos\beta r does."""
        return tuple(token.value for token in tokens[self.first : self.ends[min(1, len(self.ends) - 1)]])


def before_deviations(tokens: Sequence[Token]) -> list[Token]:
    r"""The tokens with brackets around beta in \cos^2\beta\sigma_r^2: nobody takes the cosine of a deviation."""
    opened, closed = {}, {}
    for argument in _arguments(tokens):
        if len(argument.ends) == 1:
            first, last = tokens[argument.first], tokens[argument.ends[0] - 1]
            opened[argument.first] = Token.new_borrow_pos("LPAR", "(", first)
            closed[argument.ends[0]] = Token.new_borrow_pos("RPAR", ")", last)
    found: list[Token] = []
    for at, token in enumerate(tokens):
        found += [brackets[at] for brackets in (closed, opened) if at in brackets]
        found.append(token)
    return found


def bracketed(text: str, formulas: Mapping[str, Sequence[Token]]) -> tuple[str, ...]:
    """A text with brackets around the arguments that have none, in all ways that are possible, the shortest first.

    Args:
        text: what was read.
        formulas: that are in it, with spaces for all else, and their tokens.
    """
    found = [(formula, tokens, one) for formula, tokens in formulas.items() for one in _arguments(tokens)]
    lengths: dict[tuple[str, ...], int] = {}
    for _, tokens, one in found:
        kind = one.kind(tokens)
        lengths[kind] = max(lengths.get(kind, 0), len(one.ends))
    if not found or prod(lengths.values()) > MOST_READINGS:
        return ()
    readings = []
    for counts in product(*map(range, lengths.values())):
        chosen = dict(zip(lengths, counts, strict=True))
        brackets: list[tuple[int, str]] = []
        for formula, tokens, one in found:
            end = one.ends[min(chosen[one.kind(tokens)], len(one.ends) - 1)]
            brackets += [(_start(tokens, one.first, formula), "("), (_start(tokens, end, formula), ")")]
        readings.append(_with(text, brackets))
    return tuple(readings)


def _arguments(tokens: Sequence[Token]) -> Iterator[_Argument]:
    """The arguments before more factors than a function takes without brackets."""
    for at, token in enumerate(tokens):
        if token.type != "FUNCTION":
            continue
        first = behind_power(tokens, at + 1)
        every = list(islice(_ends(tokens, first), MOST_READINGS))
        if len(every) < 2 or tokens[every[0]].type == "LPAR" or _has_power(tokens, first, every[0]):
            continue
        is_alone = token.value in TURNING and _is_deviation(tokens[every[0]]) and not _is_deviation(tokens[first])
        yield _Argument(first, tuple(every[:1] if is_alone else every))


def _is_deviation(token: Token) -> bool:
    return token.type == "NAME" and token.value.startswith("sigma")


def _has_power(tokens: Sequence[Token], first: int, end: int) -> bool:
    """Whether it is open whose power this is, the function's or its argument's."""
    depth = 0
    for token in tokens[first:end]:
        depth += (token.type in _OPENING) - (token.type in _CLOSING)
        if token.type == "RAISED" and depth == 0:
            return True
    return False


def _ends(tokens: Sequence[Token], first: int) -> Iterator[int]:
    """Where the factors end that begin there; a number is none of its own."""
    if first >= len(tokens) or tokens[first].type not in _FACTORS:
        return
    at = first + (tokens[first].type == "NUMBER")
    while (end := _factor_end(tokens, at)) > at:
        yield end
        at = end


def _factor_end(tokens: Sequence[Token], at: int) -> int:
    """Where the factor ends that begins here, with its power; the same place where none begins."""
    if at >= len(tokens) or tokens[at].type not in _MORE_FACTORS:
        return at
    end = _group_end(tokens, at) if tokens[at].type == "LPAR" else at + 1
    for _ in range(_GROUPS.get(tokens[at].type, 0)):
        end = _group_end(tokens, end)
    return behind_power(tokens, end)


def _group_end(tokens: Sequence[Token], at: int) -> int:
    """Where what is in brackets or braces ends; behind the index of a root, what is below it."""
    depth = 0
    for end in range(at, len(tokens)):
        depth += (tokens[end].type in _OPENING) - (tokens[end].type in _CLOSING)
        if depth == 0 and tokens[end].type != "RINDEX":
            return end + 1
    return len(tokens)


def _start(tokens: Sequence[Token], at: int, formula: str) -> int:
    """Where a token begins; behind the last one, where its formula ends."""
    return tokens[at].start_pos or 0 if at < len(tokens) else len(formula.rstrip())


def _with(text: str, brackets: Sequence[tuple[int, str]]) -> str:
    for place, bracket in sorted(brackets, key=lambda one: one[0], reverse=True):
        text = text[:place] + bracket + text[place:]
    return text
