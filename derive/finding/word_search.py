"""Finds quantities by words: of their names, meanings, sources and symbols, and by the field's own words for them."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from fnmatch import fnmatchcase
from functools import cache
from pathlib import Path

from radartrack.derive.bibliography import WORKS
from radartrack.derive.checking.question.letters.letter_meanings import means
from radartrack.derive.language.quantity import Quantity

MOST_WORDS = 12
MOST_LETTERS = 60  # of a word
ALIKE = 0.8  # similarity from which a word is one with a slip in it
LONG = 4  # letters from which a word may have a slip, or be the beginning of another
# How much it says that a word is the name of a quantity, a word of the field, an author, and so on down.
NAME, FIELD, SOURCE, SYMBOL, MEANING, PART, SLIP = 8.0, 6.0, 5.0, 4.0, 3.0, 2.0, 0.5
NEAR = 0.25  # of the best score: less is a word of a symbol's meaning with a slip in it beside the name itself
LONGEST_ENDING = 3  # letters that inflect a word: filtering, covariances; sidereal is no side
_LETTER = re.compile(r"[A-Za-z]\w*")
_WORD = re.compile(r"[a-z0-9]+", re.IGNORECASE)
_EMPTY = frozenset({"a", "an", "and", "by", "for", "from", "in", "of", "on", "the", "to", "with", "al", "et"})

Words = tuple[str, ...]


@dataclass(frozen=True)
class FieldWord:
    """A word of the field.

    Attributes:
        spellings: all of them, each as its words.
        patterns: of the names that it means, the best first.
    """

    spellings: tuple[Words, ...]
    patterns: tuple[str, ...]

    def meaning(self, name: str) -> float:
        """How much a quantity is meant, from nothing to one."""
        places = (place for place, pattern in enumerate(self.patterns) if fnmatchcase(name, pattern))
        return 1 - 0.1 * next(places, 10)


@cache
def field_words() -> tuple[FieldWord, ...]:
    """All words of the field."""
    table = tomllib.loads(Path(__file__).with_name("field_words.toml").read_text(encoding="utf-8"))
    return tuple(
        FieldWord(tuple(_words(said) for said in word["said"]), tuple(word["means"])) for word in table["word"]
    )


def by_words(wanted: Sequence[str], quantities: Iterable[Quantity]) -> list[Quantity]:
    """The quantities that words mean, the best first; all of them for no words.

    A pattern, `polar.*.linear`, selects names as it does files; so does what is part of a name. Several words are all
    to be met; where nothing meets all, those come that meet the most.
    """
    known = list(quantities)
    text = " ".join(wanted).strip()
    if any(sign in text for sign in "*?["):
        return [one for one in known if fnmatchcase(one.name, text)]
    if held := [one for one in known if text and _holds(one.name, text)]:
        families = {one.name.partition(".")[0] for one in held}
        return held if len(families) == 1 else sorted(held, key=_plainness)
    parts = _parts(_words(text)[:MOST_WORDS])
    if not parts:
        return [] if text else known
    if len(parts) > 1 and _LETTER.fullmatch(text) and (meant := [one for one in known if means(text, one.symbols)]):
        return meant  # a letter of the field: sigma_theta, delta_t
    scores = [[part.weight(one) for part in parts] for one in known]
    most = max((sum(map(bool, score)) for score in scores), default=0)
    found = [pair for pair in zip(scores, known, strict=True) if most and sum(map(bool, pair[0])) == most]
    best = max((sum(score) for score, _ in found), default=0.0)
    near = [pair for pair in found if sum(pair[0]) >= NEAR * best]
    return [one for _, one in sorted(near, key=lambda pair: (-sum(pair[0]), _plainness(pair[1])))]


def _plainness(quantity: Quantity) -> int:
    """By how many symbols it has: of quantities that are alike otherwise the plainest is meant."""
    return len(quantity.symbols)


def missed(wanted: Sequence[str], found: Sequence[Quantity]) -> list[str]:
    """The words that are said of none of the quantities that were found."""
    text = " ".join(wanted).strip()
    if not found or any(sign in text for sign in "*?[") or any(_holds(one.name, text) for one in found):
        return []
    parts = _parts(_words(text)[:MOST_WORDS])
    return [part.word for part in parts if part.word and not any(map(part.weight, found))]


def _holds(name: str, text: str) -> bool:
    """Whether a text is part of a name: whole parts of it, or long enough to be no chance."""
    text = text.lower()
    lowered = name.lower()
    return text in lowered if len(text) >= LONG else text in re.split(r"[._]", lowered) or text == lowered


@dataclass(frozen=True)
class _Part:
    """A word that is looked for, or several that are one of the field, and the words of the field that they are."""

    words: Words
    field: tuple[FieldWord, ...]

    @property
    def word(self) -> str:
        """The word, if it is one."""
        return self.words[0] if len(self.words) == 1 else ""

    def weight(self, quantity: Quantity) -> float:
        """How well it fits a quantity."""
        by_field = max((FIELD * one.meaning(quantity.name) for one in self.field), default=0.0)
        by_letter = SYMBOL if self.word and means(self.word, quantity.symbols) else 0.0
        said = (weight * min(_alike(word, words) for word in self.words) for weight, words in _said(quantity))
        return max(by_field, by_letter, *(weight if self.word else weight / 2 for weight in said))


def _parts(words: Words) -> list[_Part]:
    """The longest spellings of the field among the words, and the words that are left."""
    found: list[_Part] = []
    place = 0
    while place < len(words):
        length, meant = _field_words_at(words[place:])
        if length > 1:
            found.append(_Part(words[place : place + length], meant))
        elif words[place] not in _EMPTY:
            found.append(_Part(words[place : place + 1], meant))
        place += max(length, 1)
    return found


def _field_words_at(words: Words) -> tuple[int, tuple[FieldWord, ...]]:
    """The longest spelling that the words begin with, and the words of the field that are spelled so."""
    spelled: list[tuple[float, int, FieldWord]] = []
    for one in field_words():
        for spelling in one.spellings:
            length = len(spelling)
            likeness = min(map(_similar, words[:length], spelling)) if len(words) >= length else 0.0
            if likeness:
                spelled.append((likeness, length, one))
    length = max((length for _, length, _ in spelled), default=0)
    longest = [(likeness, one) for likeness, size, one in spelled if size == length]
    best = max((likeness for likeness, _ in longest), default=0.0)
    return length, tuple(one for likeness, one in longest if likeness == best)


@cache
def _said(quantity: Quantity) -> tuple[tuple[float, frozenset[str]], ...]:
    """The words that are said of a quantity, by what they weigh."""
    titles = " ".join(work.title for work in WORKS.values() if work.doi and work.doi in quantity.source.dois)
    symbols = " ".join(symbol.name for symbol in quantity.symbols)
    meanings = " ".join(symbol.meaning for symbol in quantity.symbols)
    return (
        (NAME, frozenset(_words(quantity.name))),
        (SOURCE, frozenset(_words(str(quantity.source)))),
        (SYMBOL, frozenset((*symbols.lower().split(), *_words(symbols)))),
        (MEANING, frozenset(_words(quantity.meaning))),
        (PART, frozenset(_words(f"{titles} {meanings} {quantity.conditioning.value} {quantity.word}"))),
    )


def _alike(word: str, words: Collection[str]) -> float:
    """One for a word that is there, less for the beginning of one and for a slip."""
    if word in words:
        return 1.0
    return max((_similar(word, other) for other in words), default=0.0)


@cache
def _similar(word: str, other: str) -> float:
    """From nothing to one."""
    if word == other:
        return 1.0
    if len(word) < LONG or len(other) < LONG or word[0] != other[0]:
        return 0.0
    if other.startswith(word) or (word.startswith(other) and len(word) <= len(other) + LONGEST_ENDING):
        return 0.75
    matcher = SequenceMatcher(None, word, other)
    if abs(len(word) - len(other)) > 1 or matcher.real_quick_ratio() < ALIKE or matcher.ratio() < ALIKE:
        return 0.0
    return SLIP


def _words(text: str) -> Words:
    return tuple(word[:MOST_LETTERS].lower() for word in _WORD.findall(text))
