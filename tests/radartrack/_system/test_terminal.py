"""Whatever a text holds and whatever the terminal is, it can be shown and moves nothing."""

import os
import sys
import unicodedata
from io import BytesIO, TextIOWrapper

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from rich.table import Table

from radartrack._system import terminal

ENCODINGS = ["ascii", "cp1252", "cp437", "latin-1", "cp1251", "koi8-r", "cp037", "shift_jis", "utf-8", "utf-16-le"]
SHOWN_AS_IS = "\n\t\u200c\u200d\u2061\u2062\u2063\u2064"
FORMULA = "δ = −½ σᵣ² × β°, |ρ| ≤ 1 … “μ” – ∞"
ESCAPES = "\x1b[31m \x1b]0;title\x07 \x9b31m \x8d \u202e \u2066 \u200e \u061c \ufeff \u2028 \r \x00 \x7f"


@pytest.mark.parametrize("encoding", ENCODINGS)
@given(text=st.text(st.characters()))
@example(text=FORMULA)
@example(text="\udcff\ud800")
def test_what_an_encoding_lacks_is_spelled_and_the_rest_stays(encoding: str, text: str) -> None:
    shown = text.encode(encoding, terminal.SPELLED).decode(encoding)
    kept = text.encode(encoding, "ignore").decode(encoding)
    rest = iter(shown)
    assert all(sign in rest for sign in kept)  # in this order
    if kept == text:
        assert shown == text


@pytest.mark.parametrize(
    ("text", "spelled"),
    [
        ("−2×σ_β²", "-2xsigma_beta^2"),
        ("Ω Δ ς", "Omega Delta sigma"),
        ("é½…", "e1/2..."),
        ("σᵣ ρᵦ", "sigma_r rho_beta"),
        ("Кузнецов", "????????"),
    ],
)
def test_formulas_stay_readable_in_ascii(text: str, spelled: str) -> None:
    assert text.encode("ascii", terminal.SPELLED).decode() == spelled


@given(text=st.text(st.characters() | st.sampled_from(ESCAPES)))
@example(text=ESCAPES)
def test_nothing_that_is_shown_can_be_obeyed_or_turn_the_direction(text: str) -> None:
    shown = terminal.harmless(text)
    for sign in shown:
        assert sign in SHOWN_AS_IS or unicodedata.category(sign) not in {"Cc", "Cf", "Cs", "Zl", "Zp"}
    assert terminal.harmless(shown) == shown
    if text.isprintable():
        assert shown == text
    assert len((terminal.one_line(text) + "|").splitlines()) == 1


def test_a_record_is_shown_with_every_text_in_it_on_one_line() -> None:
    record = {"a\n\x1b": ["b\r\nc", {"d": "\u202e"}, ("e",)], "f": 1.5, "g": None, "h": True}
    expected = {"a \\x1b": ["b c", {"d": "\\u202e"}, ["e"]], "f": 1.5, "g": None, "h": True}
    assert terminal.shown(record) == expected


WIDTHS = ["", "abc", "0", "-5", "²", "١٢", "1e3", "9" * 5000, "0x50", " 80 ", "80.0", "99999"]


@pytest.mark.parametrize("name", ["COLUMNS", "LINES", "TERMINAL_WIDTH"])
@pytest.mark.parametrize("value", WIDTHS, ids=lambda value: value[:9])
def test_a_width_that_is_no_number_is_none(monkeypatch: pytest.MonkeyPatch, name: str, value: str) -> None:
    for other in ("COLUMNS", "LINES", "TERMINAL_WIDTH"):
        monkeypatch.delenv(other, raising=False)
    monkeypatch.setenv(name, value)
    terminal.prepare()
    assert name not in os.environ
    assert terminal.console().width == terminal.PLAIN_WIDTH


@pytest.mark.parametrize(("value", "width"), [("1", terminal.NARROWEST), ("79", 79), ("200", 200)])
def test_columns_say_the_width_and_nothing_is_laid_out_too_narrow(
    monkeypatch: pytest.MonkeyPatch, value: str, width: int
) -> None:
    monkeypatch.setenv("COLUMNS", value)
    terminal.prepare()
    assert terminal.console().width == width


@pytest.mark.parametrize("no_color", ["", "1"])
def test_no_color_is_heeded_where_colours_would_be(monkeypatch: pytest.MonkeyPatch, no_color: str) -> None:
    for name, value in {"NO_COLOR": no_color, "FORCE_COLOR": "1", "TERM": "xterm-256color"}.items():
        monkeypatch.setenv(name, value)
    for made, stream in ((terminal.console, "stdout"), (terminal.error_console, "stderr")):
        monkeypatch.setattr(sys, stream, TextIOWrapper(BytesIO(), encoding="utf-8"))
        made().print("[bold red]no[/]")
        shown = getattr(sys, stream).buffer.getvalue()
        assert (b"\x1b" in shown) == (not no_color)


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_tables_are_drawn_in_any_encoding(monkeypatch: pytest.MonkeyPatch, encoding: str) -> None:
    output = BytesIO()
    monkeypatch.setattr(sys, "stdout", TextIOWrapper(output, encoding=encoding))
    terminal.prepare()
    table = Table("σ", title="−")
    table.add_row(":smile: ✗ 中文")
    terminal.console().print(table)
    assert ":smile:" in output.getvalue().decode(encoding)
