"""The characters of a formula: plain ASCII, so that nothing in it looks like something else."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection

from radartrack.derive.formula.error import FormulaError

MAX_CHARACTERS = 80_000  # the longest matrix that is derived has 57 000
MAX_PRINTED = 20_000  # of LaTeX

_FOREIGN = re.compile(r"[^\x20-\x7e\t\n\r]")
_INSTEAD = {
    **dict.fromkeys("−–—‐‒―", "-"),
    **dict.fromkeys("×·⋅∙•∗⨯", "*"),
    **dict.fromkeys("÷∕", "/"),
    "√": "sqrt",
    "∣": "|",
    **{
        cyrillic: f"the Latin letter {latin}"
        for cyrillic, latin in zip("аесорхукіјѕАВЕКМНОРСТХЅІЈ", "aecopxykijsABEKMHOPCTXSIJ", strict=True)
    },
}
_GREEK = re.compile(
    r"GREEK (?P<case>SMALL|CAPITAL)?\b.*\b(?P<letter>ALPHA|BETA|GAMMA|DELTA|EPSILON|ZETA|ETA|THETA|IOTA"
    r"|KAPPA|LAMDA|MU|NU|XI|OMICRON|PI|RHO|SIGMA|TAU|UPSILON|PHI|CHI|PSI|OMEGA)\b"
)


_WITH_A_MEANING = re.compile("SCRIPT|FRAKTUR|DOUBLE-STRUCK")  # an expectation, the real numbers
_MATHEMATICAL = {
    code: plain
    for code in (0x210E, *range(0x1D400, 0x1D800))
    if len(plain := unicodedata.normalize("NFKC", chr(code))) == 1
    and ord(plain) != code
    and not _WITH_A_MEANING.search(unicodedata.name(chr(code), ""))
}
LATIN = "".join(chr(code) for code, plain in _MATHEMATICAL.items() if plain.isascii() and plain.isalpha())


def is_mathematical(character: str) -> bool:
    """Whether a character is of a mathematical alphabet, bold or italic, in which Word and PDFs write formulas."""
    return ord(character) in _MATHEMATICAL


def without_alphabets(source: str) -> str:
    """A text, as long, with plain letters and digits for those of mathematical alphabets."""
    return source if source.isascii() else source.translate(_MATHEMATICAL)


def check_characters(source: str, names: Collection[str], *, latex: bool = False) -> None:
    """Refuse what is too long or empty, and the first character that is not plain ASCII.

    Raises:
        FormulaError: naming the character and saying what to type instead.
    """
    most = MAX_PRINTED if latex else MAX_CHARACTERS
    if len(source) > most:
        raise FormulaError(f"the formula has {len(source)} characters; at most {most} are read")
    if not source.strip():
        raise FormulaError("the formula is empty")
    if found := _FOREIGN.search(source):
        raise FormulaError(_refusal(found.group(), names, latex=latex), source, found.span())


def _refusal(character: str, names: Collection[str], *, latex: bool) -> str:
    code = f"U+{ord(character):04X}"
    name = unicodedata.name(character, "")
    if not name:
        kind = "control character" if unicodedata.category(character) == "Cc" else "character"
        return f"the {kind} {code} has no place in a formula: delete it"
    return f"the character {name} ({code}) is not read: {_instead(character, names, latex=latex)}"


def _instead(character: str, names: Collection[str], *, latex: bool) -> str:
    """What to type for a character, or a variant of it: fullwidth, mathematical, raised or lowered."""
    plain = unicodedata.normalize("NFKC", character).replace("\N{FRACTION SLASH}", "/")
    if greek := _GREEK.search(unicodedata.name(plain, "") if len(plain) == 1 else ""):
        word = _word(greek)
        return f"type \\{word}" if latex else f"type {word}{_kin(word, names)}"
    if plain in _INSTEAD:
        return f"type {_INSTEAD[plain]}"
    if unicodedata.category(character) in {"Cf", "Mn"}:
        return "delete it"
    if plain == " ":
        return "type a plain space"
    how = unicodedata.decomposition(character)
    place = "^" if how.startswith("<super>") else "_" if how.startswith("<sub>") else ""
    return f"type {place}{plain}" if plain.isascii() else "only plain ASCII is read"


def _word(greek: re.Match[str]) -> str:
    word = greek["letter"].lower().replace("lamda", "lambda")
    return word.capitalize() if greek["case"] == "CAPITAL" else word


def _kin(word: str, names: Collection[str]) -> str:
    """Names that a Greek letter is part of, when it is none itself."""
    kin = sorted(name for name in names if word in name.split("_"))
    return f", as in {' or '.join(kin)}" if kin and word not in names else ""
