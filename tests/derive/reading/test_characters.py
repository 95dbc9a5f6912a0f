"""Characters that look like others, or like nothing at all."""

from collections.abc import Callable

import pytest

from radartrack.derive.reading import FormulaError, Tree, read_latex, read_text

NAMES = ("r", "beta", "sigma_r", "sigma_beta", "C")


@pytest.mark.parametrize(
    ("formula", "message"),
    [
        ("σ**2", "GREEK SMALL LETTER SIGMA (U+03C3) is not read: type sigma, as in sigma_beta or sigma_r"),
        ("β", "GREEK SMALL LETTER BETA (U+03B2) is not read: type beta"),
        ("2*Σ", "GREEK CAPITAL LETTER SIGMA (U+03A3) is not read: type Sigma"),
        ("ϵ", "GREEK LUNATE EPSILON SYMBOL (U+03F5) is not read: type epsilon"),
        ("λ", "GREEK SMALL LETTER LAMDA (U+03BB) is not read: type lambda"),
        ("ς", "GREEK SMALL LETTER FINAL SIGMA (U+03C2) is not read: type sigma, as in sigma_beta or sigma_r"),
        ("а", "CYRILLIC SMALL LETTER A (U+0430) is not read: type the Latin letter a"),
        ("С", "CYRILLIC CAPITAL LETTER ES (U+0421) is not read: type the Latin letter C"),
        ("ж", "CYRILLIC SMALL LETTER ZHE (U+0436) is not read: only plain ASCII is read"),
        ("２", "FULLWIDTH DIGIT TWO (U+FF12) is not read: type 2"),
        ("ｒ", "FULLWIDTH LATIN SMALL LETTER R (U+FF52) is not read: type r"),
        ("𝑟", "MATHEMATICAL ITALIC SMALL R (U+1D45F) is not read: type r"),
        (
            "𝜎",
            "MATHEMATICAL ITALIC SMALL SIGMA (U+1D70E) is not read: type sigma, as in sigma_beta or sigma_r",
        ),
        ("r²", "SUPERSCRIPT TWO (U+00B2) is not read: type ^2"),
        ("r₁", "SUBSCRIPT ONE (U+2081) is not read: type _1"),
        ("r − 1", "MINUS SIGN (U+2212) is not read: type -"),
        ("r – 1", "EN DASH (U+2013) is not read: type -"),
        ("r·2", "MIDDLE DOT (U+00B7) is not read: type *"),
        ("r×2", "MULTIPLICATION SIGN (U+00D7) is not read: type *"),
        ("√r", "SQUARE ROOT (U+221A) is not read: type sqrt"),
        ("r ÷ 2", "DIVISION SIGN (U+00F7) is not read: type /"),
        ("r\u00a0+ 1", "NO-BREAK SPACE (U+00A0) is not read: type a plain space"),
        ("r\u200b", "ZERO WIDTH SPACE (U+200B) is not read: delete it"),
        ("r\u202e", "RIGHT-TO-LEFT OVERRIDE (U+202E) is not read: delete it"),
        ("r\u0307", "COMBINING DOT ABOVE (U+0307) is not read: delete it"),
        ("\ufeffr", "ZERO WIDTH NO-BREAK SPACE (U+FEFF) is not read: delete it"),
        ("½", "VULGAR FRACTION ONE HALF (U+00BD) is not read: type 1/2"),
        ("半", "CJK UNIFIED IDEOGRAPH-534A (U+534A) is not read: only plain ASCII is read"),
    ],
    ids=ascii,
)
def test_look_alikes_are_named_with_what_to_type_instead(formula: str, message: str):
    with pytest.raises(FormulaError) as caught:
        read_text(formula, NAMES)
    assert caught.value.message == f"the character {message}"


@pytest.mark.parametrize(
    ("formula", "message"),
    [
        ("\\frac{σ}{2}", "GREEK SMALL LETTER SIGMA (U+03C3) is not read: type \\sigma"),
        ("r²", "SUPERSCRIPT TWO (U+00B2) is not read: type ^2"),
        ("а", "CYRILLIC SMALL LETTER A (U+0430) is not read: type the Latin letter a"),
    ],
    ids=ascii,
)
def test_latex_has_commands_for_greek_letters(formula: str, message: str):
    with pytest.raises(FormulaError) as caught:
        read_latex(formula, NAMES)
    assert caught.value.message == f"the character {message}"


@pytest.mark.parametrize(
    ("formula", "message"),
    [
        ("r\0", "the control character U+0000 has no place in a formula: delete it"),
        ("r\x1b[31m", "the control character U+001B has no place in a formula: delete it"),
        ("r\x7f", "the control character U+007F has no place in a formula: delete it"),
        ("r\x0b+ 1", "the control character U+000B has no place in a formula: delete it"),
        ("\ud800", "the character U+D800 has no place in a formula: delete it"),
        ("\U0010ffff", "the character U+10FFFF has no place in a formula: delete it"),
    ],
    ids=ascii,
)
@pytest.mark.parametrize("reader", [read_text, read_latex])
def test_characters_without_a_name_are_refused(reader: Callable[..., Tree], formula: str, message: str):
    with pytest.raises(FormulaError) as caught:
        reader(formula, NAMES)
    assert caught.value.message == message


@pytest.mark.parametrize("formula", ["r\x1b[2J", "r\u202e+ 2", "e\u0301", "\u534a + r", "r\t\0"], ids=ascii)
def test_an_excerpt_sends_nothing_odd_to_the_terminal(formula: str):
    with pytest.raises(FormulaError) as caught:
        read_text(formula, NAMES)
    above, below = caught.value.excerpt.splitlines()
    assert above.isascii()
    assert above.isprintable()
    assert above[below.index("^")] == "?"
