"""The characters of a formula: plain ASCII, so that nothing in it looks like something else."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection

from radartrack.derive.formula.error import FormulaError

MAX_CHARACTERS = 20_000

_FOREIGN = re.compile(r"[^\x20-\x7e\t\n\r]")
_SIGNS = {
    **dict.fromkeys("−–—‐‑‒―﹣", "-"),
    **dict.fromkeys("×·⋅∙•∗⨯", "*"),
    **dict.fromkeys("÷∕⁄", "/"),
    "√": "sqrt(...)",
    "∣": "|",
    "′": None,
}
_LOOK_ALIKES = dict(zip("аесорхукіјѕАВЕКМНОРСТХЅІЈ", "aecopxykijsABEKMHOPCTXSIJ", strict=True))
_GREEK = re.compile(
    r"GREEK\b.*\b(ALPHA|BETA|GAMMA|DELTA|EPSILON|ZETA|ETA|THETA|IOTA|KAPPA|LAMDA|MU|NU|XI|OMICRON|PI|RHO|SIGMA|TAU"
    r"|UPSILON|PHI|CHI|PSI|OMEGA)\b"
)


def check_characters(source: str, names: Collection[str]) -> None:
    """Refuse what is too long or empty, and the first character that is not plain ASCII.

    Raises:
        FormulaError: naming the character and saying what to type instead.
    """
    if len(source) > MAX_CHARACTERS:
        raise FormulaError(f"the formula has {len(source)} characters; at most {MAX_CHARACTERS} are read")
    if not source.strip():
        raise FormulaError("the formula is empty")
    if found := _FOREIGN.search(source):
        raise FormulaError(_refusal(found.group(), names), source, found.span())


def _refusal(character: str, names: Collection[str]) -> str:
    code = f"U+{ord(character):04X}"
    name = unicodedata.name(character, "")
    if not name:
        kind = "control character" if unicodedata.category(character) == "Cc" else "character"
        return f"the {kind} {code} has no place in a formula: delete it"
    return f"the character {name} ({code}) is not read: {_instead(character, name, names)}"


def _instead(character: str, name: str, names: Collection[str]) -> str:
    if sign := _SIGNS.get(character):
        return f"type {sign}"
    if letter := _LOOK_ALIKES.get(character):
        return f"type the Latin letter {letter}"
    if greek := _GREEK.search(name):
        return _greek(greek.group(1), name, names)
    if unicodedata.category(character) in {"Cf", "Cs", "Mn"}:
        return "delete it"
    return _compatible(character)


def _greek(letter: str, name: str, names: Collection[str]) -> str:
    word = letter.lower().replace("lamda", "lambda")
    word = word.capitalize() if "CAPITAL" in name else word
    kin = sorted(allowed for allowed in names if word in allowed.split("_") and allowed != word)
    return f"type {word}" + (f", as in {' or '.join(kin)}" if kin and word not in names else "")


def _compatible(character: str) -> str:
    """What to type for a variant of an ASCII character: fullwidth, mathematical, raised or lowered."""
    plain = unicodedata.normalize("NFKC", character)
    if not plain.isascii():
        return "only plain ASCII is read"
    if plain == " ":
        return "type a plain space"
    raised = unicodedata.decomposition(character).startswith("<super>")
    return f"type {'^' if raised else ''}{plain}"
