r"""An angular rate and a time behind a sine, \sin\omega T, are its argument: of a rate alone there is no sine."""

from __future__ import annotations

import re
from collections.abc import Sequence

from lark import Token

TURNING = frozenset({"cos", "cot", "sin", "tan"})
_RATE = re.compile(r"[oO]mega(?:_\w+)?")
_TIME = re.compile(r"(?:Delta_)?[Tt](?:_\w+)?|(?:Delta_)?tau|dt|h")


def with_phases(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with brackets around a phase that stands behind a function without any."""
    found: list[Token] = []
    index = 0
    while index < len(tokens):
        found.append(tokens[index])
        index += 1
        if found[-1].type != "FUNCTION" or found[-1].value not in TURNING:
            continue
        first = behind_power(tokens, index)
        end = _phase_end(tokens, first)
        if end:
            opened, closed = tokens[first], tokens[end - 1]
            found += tokens[index:first]
            found.append(Token.new_borrow_pos("LPAR", "(", opened))
            found += tokens[first:end]
            found.append(Token.new_borrow_pos("RPAR", ")", closed))
            index = end
    return found


def behind_power(tokens: Sequence[Token], at: int) -> int:
    """Where a power ends that begins here; the same place where none does."""
    depth = 0
    for end in range(at + 1, len(tokens)) if at < len(tokens) and tokens[at].type == "RAISED" else ():
        depth += (tokens[end].type == "LBRACE") - (tokens[end].type == "RBRACE")
        if depth == 0:
            return end + 1
    return at


def _phase_end(tokens: Sequence[Token], first: int) -> int:
    """Where a rate times a time ends, perhaps with a number before them; 0 where none begins there."""
    rate = first + 1 if first < len(tokens) and tokens[first].type == "NUMBER" else first
    end = rate + 2
    one, other = [*(token.value if token.type == "NAME" else "" for token in tokens[rate:end]), "", ""][:2]
    is_phase = _RATE.fullmatch(one) and _TIME.fullmatch(other)
    behind = [*(token.type for token in tokens[end : end + 2]), "", ""][:2]
    divides = behind == ["SLASH", "NAME"] and tokens[end + 1].value == one  # sin ωT/ω
    goes_on = behind[0] in {"RAISED", "SLASH", "NAME", "LPAR", "TRANSPOSED"} and not divides
    return 0 if not is_phase or goes_on else end
