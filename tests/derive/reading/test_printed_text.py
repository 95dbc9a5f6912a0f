"""Text that was copied from a page: signs and letters of print, and places in it."""

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.reading import FormulaError, read_formula, to_text

KNOWN = ("r", "beta", "epsilon", "rho", "sigma_r", "sigma_beta", "x", "y", "T", "q")
PIECES = (
    *"σβεθρλΔπ²³⁻¹₁₂√·×−÷½′ᵀ()+-*/^_=,. 12rxyTe",
    "sin",
    "cos ",
    "exp(",
    "σβ²",
    "sin²",
    "atan2(",
    "x\u0302",
    "\u200b",
    "а",
    "∫",
    "∑",
    *"■█@&〖〗▒┤{}[];",
    "■(",
)


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("c₁₁ = r²σβ² sin²β + σr² cos²β", "r**2*sigma_beta**2*sin(beta)**2 + sigma_r**2*cos(beta)**2"),
        ("σ_β²·r²", "sigma_beta**2*r**2"),
        ("ρσrσβ", "rho*sigma_r*sigma_beta"),
        ("√(x²+y²)", "sqrt(x**2 + y**2)"),
        ("√2·r − √x y", "sqrt(2)*r - sqrt(x)*y"),
        ("−½ r·cos β", "-1/2*r*cos(beta)"),
        ("rcosβ × sin(β)", "r*cos(beta)*sin(beta)"),
        ("e^(−σβ²/2) + exp(−2σβ²)", "e**(-sigma_beta**2/2) + exp(-2*sigma_beta**2)"),
        ("x⁻¹ + tan⁻¹(y/x)", "x**(-1) + atan(y/x)"),
        ("(x+y)² π", "(x + y)**2*pi"),
        ("x = r cos ε sin β.", "r*cos(epsilon)*sin(beta)"),
        ("σ_r**2·cos(β)**2", "sigma_r**2*cos(beta)**2"),
        ("T³*q/3·r − ½*x", "T**3*q/3*r - 1/2*x"),
        ("√(x² + y²)*σ_β^2", "sqrt(x**2 + y**2)*sigma_beta**2"),
        ("x\u0302² + β′", "x**2 + beta"),
        ("𝜎𝛽² + ϵ", "sigma_beta**2 + epsilon"),
        ("𝑥 = 𝑟 cos(𝛽)", "r*cos(beta)"),
        ("𝒓²𝜎_𝛽² 𝑠𝑖𝑛²𝛽", "r**2*sigma_beta**2*sin(beta)**2"),
        ("𝟐𝗋", "2*r"),
        ("𝑟𝑥 + 𝑟𝑐𝑜𝑠 𝛽", "r*x + r*cos(beta)"),
        ("q[T³, T²/2; T²/2, T]", "q*[[T**3, T**2/2], [T**2/2, T]]"),
        ("e^{−2σβ²} r²", "e**(-2*sigma_beta**2)*r**2"),
    ],
)
def test_reading(text: str, read: str):
    for known in (KNOWN, None):
        reading = read_formula(text, "text", known)
        assert (to_text(reading.tree), reading.notation) == (read, "printed")


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("■(r cos\u2061β@r sin\u2061β)", "[r*cos(beta), r*sin(beta)]"),
        (
            "P=[■(cos\u2061β&-r sin\u2061β@sin\u2061β&r cos\u2061β)]",
            "[[cos(beta), -r*sin(beta)], [sin(beta), r*cos(beta)]]",
        ),
        ("q(■(T^3/3&T^2/2@T^2/2&T))", "q*[[T**3/3, T**2/2], [T**2/2, T]]"),
        ("[■(x/√(x^2+y^2 )&y/√(x^2+y^2 ))]", "[[x/sqrt(x**2 + y**2), y/sqrt(x**2 + y**2)]]"),
        ("█(x=r cos\u2061β@y=r sin\u2061β)", "[r*cos(beta), r*sin(beta)]"),
        ("█(x&=r cos\u2061β@y&=r sin\u2061β)", "[r*cos(beta), r*sin(beta)]"),
        ("{█(x=r cos\u2061β@y=r sin\u2061β)┤", "[r*cos(beta), r*sin(beta)]"),
        (
            "σ_r^2 〖cos〗^2\u2061β+r^2 σ_β^2 〖sin〗^2\u2061β",
            "sigma_r**2*cos(beta)**2 + r**2*sigma_beta**2*sin(beta)**2",
        ),
        ("〖tan〗^(-1)\u2061(y/x)", "atan(y/x)"),
        ("sin\u2061〖2β〗 x", "sin(2*beta)*x"),
        ("x〖r+y〗", "x*(r + y)"),
        ("-∑_(i=0)^(T-1)▒〖i x/r^2 〗", "-sum(i*x/r**2, i, 0, T - 1)"),
        ("∑_(i=1)^T▒〖x+i〗", "sum(x + i, i, 1, T)"),
        ("∫_0^T▒〖q s^2 ds〗", "integral(q*s**2, s, 0, T)"),
        ("√(3&x^2)", "(x**2)**(1/3)"),
    ],
)
def test_words_linear_format(text: str, read: str):
    for known in (KNOWN, None):
        assert to_text(read_formula(text, "text", known, wanted=4).tree) == read


@pytest.mark.parametrize("text", ["■(x@y", "〖x²", "√(3&x", "[x²; y", "x²■(r&y@x)", "■", "〗x"])
def test_a_broken_linear_format_is_refused(text: str):
    with pytest.raises(FormulaError):
        read_formula(text, "text", KNOWN)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("T³/3·q", "what is divided by what is ambiguous after a slash"),
        ("sinβ²", "this may be the power of"),
        ("σβ а", "the character CYRILLIC SMALL LETTER A (U+0430) is not read: type the Latin letter a"),
        ("σβ\u200b", "the character ZERO WIDTH SPACE (U+200B) is not read: delete it"),
        ("λ²", "lambda is not a name here"),
    ],
)
def test_refusals(text: str, message: str):
    with pytest.raises(FormulaError) as caught:
        read_formula(text, "text", KNOWN)
    assert caught.value.message.startswith(message)


def test_a_fault_is_where_it_is_in_the_text():
    with pytest.raises(FormulaError) as caught:
        read_formula("r²σβ² + λ r", "text", KNOWN)
    assert caught.value.source[slice(*caught.value.span or (0, 0))] == "λ"


def test_a_letter_behind_a_sigma_is_a_factor_where_there_is_no_such_deviation():
    assert to_text(read_formula("σβ²", "text", ["sigma", "beta"]).tree) == "sigma*beta**2"


@given(st.one_of(st.text(), st.lists(st.sampled_from(PIECES), max_size=20).map("".join)))
def test_any_text_is_read_or_refused(text: str):
    for known in (None, KNOWN):
        try:
            read = read_formula(text, "printed", known)
        except FormulaError as error:
            assert str(error)  # noqa: PT017
        else:
            assert to_text(read.tree)


@pytest.mark.parametrize(
    ("text", "read"), [("r sin(90°−θ)", "r*sin(90*pi/180 - theta)"), ("r*sin(90°-b)", "r*sin(90*pi/180 - b)")]
)
def test_degrees_of_a_page(text: str, read: str) -> None:
    assert to_text(read_formula(text, "text", None).tree) == read


@pytest.mark.parametrize("character", "𝔼ℝ𝒩𝔉")
def test_letters_that_mean_something_else_are_refused(character: str) -> None:
    with pytest.raises(FormulaError, match="is not read"):
        read_formula(f"{character} + r²", "text", None)


def test_letters_of_a_mathematical_alphabet_are_symbols_each_and_a_fault_is_told_where_it_is() -> None:
    assert to_text(read_formula("ℎ𝑢 + 𝑎𝑏²", "text", None).tree) == "h*u + a*b**2"
    with pytest.raises(FormulaError) as caught:
        read_formula("𝑎𝑏𝑐 + 𝑟 ≠ 2", "text", None)
    assert (caught.value.source, caught.value.span) == ("𝑎𝑏𝑐 + 𝑟 ≠ 2", (8, 9))


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("ṙ = (xẋ + yẏ + zż)/r", "(x*xdot + y*ydot + z*zdot)/r"),
        ("(x ẋ + y ẏ)/√(x² + y²)", "(x*xdot + y*ydot)/sqrt(x**2 + y**2)"),
        ("(x*ẋ + y*ẏ)/sqrt(x^2 + y^2)", "(x*xdot + y*ydot)/sqrt(x**2 + y**2)"),
        ("r̂*cos(θ̂) + ẍ*T", "r*cos(theta) + xddot*T"),
        ("ẑ + x̄ + ŷ", "z + x + y"),
    ],
)
def test_letters_with_dots_of_one_character_are_those_with_dots_behind_them(text: str, read: str):
    for form in ("NFC", "NFD"):
        assert to_text(read_formula(unicodedata.normalize(form, text), "text", None).tree) == read
