"""Which symbols the letters of a formula may stand for, one to one, the likeliest first.

A name that carries a meaning binds; only letters without one are free. Numbered letters keep their order: P1 and P2 are
never the deviations of the second and the first, nor z_k and z_{k-1} the first and the second plot. A letter may stand
for the square of a deviation, where it is a variance, for the root of a variance, where it is a deviation, or for the
inverse of a rate, where it is a time constant.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import permutations
from typing import Generic, TypeVar

from radartrack.derive.checking.question.letters.letter_meanings import (
    Known,
    Role,
    is_variance,
    meaning_of,
    meanings,
    means,
)

STRONG, WEAK, LIKE, ANY = 0, 1, 2, 4  # ranks: how far-fetched a meaning is
PER_SECOND = "1/s"
TIME_CONSTANT = "tau"  # which a period is called as well
HALF = Fraction(1, 2)
_NUMBERED = re.compile(r"(?P<stem>\D*)(?P<number>\d{1,9})")
_OF_TIME = re.compile(r"(?P<stem>\w*_[kntij])(?:(?P<sign>[mp])(?P<shift>\d{1,9}))?")  # z_k, z_km1
_ORDINALS = {"first": 1, "second": 2, "third": 3}

Symbol = TypeVar("Symbol", bound=Known)


@dataclass(frozen=True)
class Choice(Generic[Symbol]):
    """What a letter may stand for: a symbol, raised to a power, and how far-fetched that is."""

    symbol: Symbol
    power: Fraction | int = 1
    rank: int = 0

    @property
    def key(self) -> tuple[str, Fraction | int]:
        """What no other letter stands for then."""
        return self.symbol.name, self.power

    def __str__(self) -> str:
        name = self.symbol.name
        return {1: name, -1: f"1/{name}", HALF: f"sqrt({name})"}.get(self.power, f"{name}**{self.power}")


Taken = frozenset[tuple[str, Fraction | int]]


def choices(name: str, symbols: Sequence[Symbol]) -> list[Choice[Symbol]]:
    """What a letter may stand for, the likeliest first: what it means, or anything where it means nothing."""
    if strong := means(name, symbols):
        return [Choice(symbol, power, STRONG) for symbol, power in strong]
    return free_choices(name, symbols)


def free_choices(name: str, symbols: Sequence[Symbol]) -> list[Choice[Symbol]]:
    """What a letter without a meaning may stand for."""
    role = meanings(name).role
    weak = {symbol for symbol, _ in means(name, symbols, weak=True)}
    power = 2 if role is Role.VARIANCE else 1
    playing = [one for one in symbols if _may_play(role, one)] or (symbols if len(name) == 1 else [])
    found = [Choice(one, power, _rank(name, one, weak=one in weak)) for one in playing]
    return sorted(found, key=lambda choice: choice.rank)


def farther_choices(
    name: str, known: Mapping[str, Sequence[Choice[Symbol]]], symbols: Sequence[Symbol]
) -> list[Choice[Symbol]]:
    """Also a time constant, a variance, the root of one, and anything where another letter means the same: tau by dt.

    Args:
        name: the letter.
        known: the choices of all letters.
        symbols: that letters may stand for.
    """
    own = list(known[name])
    binds = bool(own) and own[0].rank == STRONG
    shared = sum(1 for others in known.values() if list(others) == own) > 1
    constants = [Choice(one, -1, ANY) for one in symbols if str(one.unit) == PER_SECOND]
    if binds and not shared:
        return [*own, *(constants if name.startswith(TIME_CONSTANT) else ())]
    found = [*own, *(free_choices(name, symbols) if shared else ())]
    if meanings(name).role is None:
        found += constants
        found += [Choice(one, 2, ANY) for one in symbols if meaning_of(one).role is Role.DEVIATION]
    if meanings(name).role is Role.DEVIATION:
        found += [Choice(one, HALF, ANY) for one in symbols if is_variance(one)]
    return list(dict.fromkeys(found))


def assignments(
    candidates: Mapping[str, Sequence[Choice[Symbol]]], taken: Taken = frozenset()
) -> Iterator[dict[str, Choice[Symbol]]]:
    """Every way to give the letters different meanings; those with the fewest choices come first."""
    order = sorted(candidates, key=lambda name: len(candidates[name]))
    yield from filter(keeps_numbers, _distinct(order, candidates, taken))


def stem(name: str) -> str:
    """What a numbered letter is without its number; nothing of others."""
    found = _NUMBERED.fullmatch(name)
    return found["stem"] if found else ""


def keeps_numbers(assigned: Mapping[str, Choice[Symbol]]) -> bool:
    """Whether letters that differ by a number stand in the order of the symbols that they mean."""
    numbered = {letter: found for letter in assigned if (found := _numbered(letter))}
    order = {letter: found for letter in numbered if (found := _numbered(assigned[letter].symbol.name))}
    return not any(
        numbered[one][0] == numbered[other][0]
        and order[one][0] == order[other][0]
        and numbered[one][1] < numbered[other][1]
        and order[one][1] > order[other][1]
        for one, other in permutations(order, 2)
    )


def _numbered(name: str) -> tuple[str, int] | None:
    """What a name numbers, and the number: of sigma_2 and of second_covariance."""
    if found := _OF_TIME.fullmatch(name):
        shift = int(found["shift"] or 0)
        return found["stem"], -shift if found["sign"] == "m" else shift
    if found := _NUMBERED.fullmatch(name):
        return found["stem"], int(found["number"])
    ordinal, _, rest = name.partition("_")
    return (rest, _ORDINALS[ordinal]) if ordinal in _ORDINALS else None


def _distinct(
    order: Sequence[str], candidates: Mapping[str, Sequence[Choice[Symbol]]], taken: Taken
) -> Iterator[dict[str, Choice[Symbol]]]:
    if not order:
        yield {}
        return
    for choice in candidates[order[0]]:
        if choice.key not in taken:
            for rest in _distinct(order[1:], candidates, taken | {choice.key}):
                yield {order[0]: choice} | rest


def _may_play(role: Role | None, symbol: Known) -> bool:
    own = meaning_of(symbol).role
    if role in {Role.DEVIATION, Role.VARIANCE}:
        return own is Role.DEVIATION
    return own is Role.CORRELATION if role is Role.CORRELATION else True


def _rank(name: str, symbol: Known, *, weak: bool) -> int:
    if weak:
        return WEAK
    if name[0].lower() == symbol.name[0].lower():
        return LIKE
    return ANY + (meaning_of(symbol).role is not Role.VALUE)
