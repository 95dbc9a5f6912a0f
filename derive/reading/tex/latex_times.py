r"""Times in brackets: x(k) is x, and where a formula speaks of several times, x(k) and x(k-1) are x_{k} and x_{k-1}.

Times that are raised are lowered, x^{k+1} = x^k + v^k: nobody defines a power.

A bracket behind a letter is a factor otherwise: k(k+1) where k is a symbol, or stands elsewhere too.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace

from radartrack.derive.reading.tex.latex_pieces import Piece

_INDEX = r"[kntij](?:[+-]\d+)?"
_TIME = re.compile(rf"{_INDEX}(?:[|/]{_INDEX})?|\d")
_RAISED = re.compile(rf"[^=]*\^\s*(?:\{{\s*\(?\s*{_INDEX.replace('[+-]', '(?: *[+-] *)')}\s*\)?\s*\}}|[knij])\s*")
_LETTERS = frozenset("kntij")
_COUNTS = _LETTERS - {"t"}  # which a bracket behind multiplies: k(k+1)
_PERIODS, _DIFFERENCES = frozenset({"T", "\\tau"}), frozenset({"\\Delta", "\\delta"})
_BARS = frozenset({"\\mid", "\\vert", "|"})
_SUBSCRIBED = frozenset({"letter", "greek", "word", "close", "prime"})


@dataclass(frozen=True)
class _Time:
    """A time in brackets: where these stand, where the letter before them ends, and what is between them."""

    first: int
    last: int
    letter: int
    said: str


def raised_times(defined: Iterable[str]) -> frozenset[str]:
    """The letters that are raised as times where something is defined: k in x^{k+1} = x^k + v^k.

    Args:
        defined: what stands left of the equals signs.
    """
    ends = (left.rsplit("^", 1)[-1] for left in defined if _RAISED.fullmatch(left))
    return frozenset(letter for end in ends for letter in end if letter in _LETTERS)


def with_times(found: list[Piece], names: Collection[str], raised: Collection[str] = ()) -> list[Piece]:
    """The pieces of a formula without times in brackets, and with times below that are raised.

    Args:
        found: the pieces; bars are not told apart yet.
        names: the symbols that are known.
        raised: letters that are times where they are raised.
    """
    found = _lowered(found, raised) if raised else found
    times = [time for index in range(1, len(found)) if (time := _time(found, index))]
    if not times:
        return found
    inside = {at for time in times for at in range(time.first, time.last + 1)}
    inside |= _subscripts(found)
    others = {piece.text for at, piece in enumerate(found) if at not in inside}
    times = [one for one in times if not _LETTERS & set(one.said) & (others | set(names))]
    is_one = len({time.said for time in times}) == 1
    result = list(found)
    for time in reversed(times):
        del result[time.first : time.last + 1]
        if not is_one:
            _lower(result, time.letter, found[time.first + 1 : time.last])
    return result


def _lowered(found: Sequence[Piece], raised: Collection[str]) -> list[Piece]:
    """The pieces with raised times below the letters, with what stands there."""
    result = list(found)
    for at in reversed(range(1, len(found))):
        letter = _letter_before(found, at) if found[at].kind == "raised" else -1
        end = _end_of_argument(found, at)
        time = [piece for piece in found[at + 1 : end] if piece.text not in {"{", "}", "(", ")"}]
        said = "".join(piece.text for piece in time)
        if letter >= 0 and time and time[0].text in raised and _TIME.fullmatch(said) and found[letter].text != "e":
            del result[at:end]
            _lower(result, letter, time)
    return result


def _end_of_argument(found: Sequence[Piece], at: int) -> int:
    """Where what is raised or lowered at this place ends."""
    if at + 1 >= len(found) or found[at + 1].text != "{":
        return at + 2
    return next((end + 1 for end in range(at + 2, len(found)) if _start(found, end) == at + 1), len(found))


def _time(found: Sequence[Piece], index: int) -> _Time | None:
    """The time in the brackets that open here, behind a letter."""
    if found[index].text != "(":
        return None
    last = next((at for at in range(index, len(found)) if found[at].text == ")"), index)
    said = "".join("|" if piece.text in _BARS else piece.text for piece in found[index + 1 : last])
    letter = _letter_before(found, index)
    if letter < 0 or not _TIME.fullmatch(said) or (re.search("[+-]", said) and _is_duration(found, letter)):
        return None
    return _Time(index, last, letter, said)


def _is_duration(found: Sequence[Piece], letter: int) -> bool:
    r"""Whether a letter that ends there is T or \Delta t, of which there are n - 1 in T(n-1); t(n-1) is a time."""
    start = _start(found, letter)
    is_difference = start > 0 and found[start - 1].text in _DIFFERENCES and found[start].text == "t"
    return is_difference or found[start].text in _PERIODS


def _letter_before(found: Sequence[Piece], index: int) -> int:
    """Where the letter ends that stands before this, with what is below it; -1 where there is none."""
    at = index - 1
    while at > 0 and found[at].kind == "prime":
        at -= 1
    at = _before_power(found, at)
    start = _start(found, at)
    if at < 0 or found[at].kind not in {"letter", "greek", "close"}:
        return -1
    taking = found[start - 1].kind if start else ""
    if taking == "lowered":
        base = _before_power(found, start - 2)
        return at if base >= 0 and found[base].kind in _SUBSCRIBED else -1
    is_factor = found[at].kind == "close" or found[at].text in _COUNTS
    return -1 if is_factor and taking not in {"accent", "font"} else at


def _before_power(found: Sequence[Piece], at: int) -> int:
    """Where what is raised to a power ends, if one ends here."""
    start = _start(found, at)
    return start - 2 if start > 0 and found[start - 1].kind == "raised" else at


def _start(found: Sequence[Piece], at: int) -> int:
    """Where the group begins that ends here, or the one piece that stands here."""
    depth = 0
    while at > 0:
        depth += (found[at].text == "}") - (found[at].text == "{")
        if not depth:
            break
        at -= 1
    return at


def _subscripts(found: Sequence[Piece]) -> set[int]:
    """Where pieces stand in subscripts."""
    below: set[int] = set()
    groups: list[bool] = []
    for at, piece in enumerate(found):
        is_first = at > 0 and found[at - 1].kind == "lowered"
        if piece.text == "{":
            groups.append(is_first or any(groups))
        elif piece.text == "}" and groups:
            groups.pop()
        elif is_first or (groups and groups[-1]):
            below.add(at)
    return below


def _lower(result: list[Piece], letter: int, time: Sequence[Piece]) -> None:
    """Put a time below a letter, behind what stands there."""
    span = time[0].span
    comma, opens, closes = Piece("comma", ",", span), Piece("open", "{", span), Piece("close", "}", span)
    start = _start(result, letter)
    if not start or result[start - 1].kind != "lowered":
        result[letter + 1 : letter + 1] = [Piece("lowered", "_", span), opens, *time, closes]
    elif start == letter:
        result[letter : letter + 1] = [opens, replace(result[letter]), comma, *time, closes]
    else:
        result[letter:letter] = [comma, *time]
