r"""A rate and a time behind a sine, \sin\omega T or \sin\omega(t - t_0), are its argument: of a rate there is none."""

from __future__ import annotations

import re
from collections.abc import Sequence

from lark import Token

from radartrack.derive.formula.error import FormulaError

TURNING = frozenset({"cos", "cot", "sin", "tan"})
_RATE = re.compile(r"[oO]mega(?:_\w+)?")
_TIME = re.compile(r"(?:Delta_)?[Tt](?:_\w+)?|(?:Delta_)?tau|dt|h")


def with_phases(tokens: Sequence[Token]) -> list[Token]:
    r"""The tokens with brackets around a phase that stands behind a function without any.

    Raises:
        FormulaError: for \sin\omega(t - t_0)^2, which may be the power of the sine or of its argument.
    """
    found: list[Token] = []
    index = 0
    while index < len(tokens):
        found.append(tokens[index])
        index += 1
        if found[-1].type != "FUNCTION" or found[-1].value not in TURNING:
            continue
        first = behind_power(tokens, index)
        end = _phase_end(tokens, first, found[-1])
        if end:
            opened, closed = tokens[first], tokens[end - 1]
            found += tokens[index:first]
            found.append(Token.new_borrow_pos("LPAR", "(", opened))
            found += tokens[first:end]
            found.append(Token.new_borrow_pos("RPAR", ")", closed))
            index = end
    return found


def power_of_which(function: str) -> str:
    r"""What to say of \sin\theta^2."""
    return (
        f"this may be the power of \\{function} or of its argument: write \\{function}^{{n}} x for the first, "
        f"\\{function}(x^{{n}}) for the second"
    )


def behind_power(tokens: Sequence[Token], at: int) -> int:
    """Where a power ends that begins here; the same place where none does."""
    depth = 0
    for end in range(at + 1, len(tokens)) if at < len(tokens) and tokens[at].type == "RAISED" else ():
        depth += (tokens[end].type == "LBRACE") - (tokens[end].type == "RBRACE")
        if depth == 0:
            return end + 1
    return at


def _phase_end(tokens: Sequence[Token], first: int, function: Token) -> int:
    """Where a rate times a time ends, perhaps with a number before them; 0 where none begins there."""
    rate = first + 1 if first < len(tokens) and tokens[first].type == "NUMBER" else first
    end = _time_end(tokens, rate + 1)
    if not end or tokens[rate].type != "NAME" or not _RATE.fullmatch(tokens[rate].value):
        return 0
    if end < len(tokens) and (tokens[end - 1].type, tokens[end].type) == ("RPAR", "RAISED"):
        span = function.start_pos or 0, tokens[end].end_pos or 0
        raise FormulaError(power_of_which(str(function)), span=span)
    behind = [*(token.type for token in tokens[end : end + 2]), "", ""][:2]
    divides = behind == ["SLASH", "NAME"] and tokens[end + 1].value == tokens[rate].value  # sin ωT/ω
    is_open = tokens[end - 1].type != "RPAR" and not divides
    goes_on = behind[0] in {"RAISED", "TRANSPOSED", *(("SLASH", "NAME", "LPAR") if is_open else ())}
    return 0 if goes_on else end


def _time_end(tokens: Sequence[Token], at: int) -> int:
    """Where a time ends, or a sum of times in brackets; 0 where neither begins there."""
    if at >= len(tokens) or tokens[at].type not in {"NAME", "LPAR"}:
        return 0
    closed = (n + 1 for n in range(at, len(tokens)) if tokens[n].type == "RPAR")
    end = next(closed, 0) if tokens[at].type == "LPAR" else at + 1
    inside = [token for token in tokens[at:end] if token.type not in {"LPAR", "RPAR", "PLUS", "MINUS"}]
    return end if inside and all(token.type == "NAME" and _TIME.fullmatch(token.value) for token in inside) else 0
