"""The formula book: complete, linked, and true to the forms that it typesets."""

import re
from pathlib import Path

import pytest
import sympy

from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.stable.quantity_form import form_of
from radartrack.derive.writing.formula_book import Page, anchor, are_related, book, formula

SHIPPED = (Path(__file__).parents[3] / "docs" / "formulas.md").read_text()
RENDERED_AT_MOST = 512 * 1024  # code hosts show longer files as plain text
a, b = sympy.symbols("a b", real=True)
ANY = catalogue()["polar.map"]


def test_every_quantity_has_its_heading_and_its_error_proved_or_measured() -> None:
    headings = re.findall(r"^### (.+)$", SHIPPED, flags=re.MULTILINE)
    assert headings == list(catalogue())
    stated = re.findall(r"^- in code: (?:measured, not proved: )?at most ", SHIPPED, flags=re.MULTILINE)
    assert len(stated) == len(headings)


def test_every_link_leads_to_a_heading() -> None:
    headings = re.findall(r"^##+ (.+)$", SHIPPED, flags=re.MULTILINE)
    targets = set(re.findall(r"\]\(#([^)]+)\)", SHIPPED))
    assert targets <= {anchor(heading) for heading in headings}


def test_it_is_short_enough_to_be_rendered() -> None:
    assert len(SHIPPED.encode()) < RENDERED_AT_MOST


def test_braces_and_brackets_of_the_formulas_close() -> None:
    blocks = re.findall(r"```math\n(.*?)```", SHIPPED, flags=re.DOTALL)
    assert len(blocks) > 200
    for block in blocks:
        assert block.count("{") == block.count("}")
        assert block.count(r"\left") == block.count(r"\right")


def test_intermediates_come_before_what_they_are_needed_for_and_equal_entries_once() -> None:
    q = sp.Symbol("attenuation_beta", positive=True)
    form = StableForm({q: sp.exp(-(a**2))}, Tensor((2, 2), (q, b, b, sp.Integer(0))))
    lines = formula(ANY, form).splitlines()
    assert lines[2:-2] == [
        r"q_{\beta} &= e^{- a^{2}} \\",
        r"[0,0] &= q_{\beta} \\",
        r"[0,1] = [1,0] &= b \\",
        r"[1,1] &= 0",
    ]


def test_sines_stand_where_they_are_used_and_one_less_an_exponential_is_written_out() -> None:
    wave, shortfall = sp.Symbol("cos_a", real=True), sp.Symbol("shortfall_b", real=True)
    form = StableForm({wave: sp.cos(a), shortfall: -sp.expm1(-b)}, Tensor((), (wave * shortfall,)))
    written = formula(ANY, form)
    assert r"u_{b} &= 1 - e^{- b}" in written
    assert r"u_{b} \cos{\left(a \right)}" in written
    assert "expm1" not in written


def test_a_long_sum_goes_over_several_lines_and_keeps_every_term() -> None:
    total = sp.Add(*(sp.Integer(n + 2) * a**n * b ** (40 - n) for n in range(40)))
    lines = formula(ANY, StableForm({}, Tensor((), (total,)))).splitlines()[2:-2]
    assert len(lines) > 3
    together = " ".join(line.removesuffix(r" \\").replace(r"&\quad ", "") for line in lines)
    assert together == f"f &= {sympy.latex(total)}"


def test_what_is_too_long_is_named_with_the_command_that_prints_it() -> None:
    total = sp.Add(*(sp.Integer(n + 2) * a**n * b ** (400 - n) for n in range(400)))
    assert f"`radartrack show {ANY.name}`" in formula(ANY, StableForm({}, Tensor((), (total,))))


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        ("polar.bias.truth", "spherical.bias.truth", True),
        ("polar.bias.truth", "polar.bias.averaged", True),
        ("polar.bias.truth", "polar.bias.truth", False),
        ("polar.bias.truth", "spherical.bias.averaged", False),
        ("polar.map", "polar.map.inverse", False),
    ],
)
def test_names_that_differ_in_one_part_are_related(first: str, second: str, expected: bool) -> None:
    assert are_related(first, second) == expected


def test_a_chapter_has_each_symbol_once() -> None:
    pages = [
        Page(q, formula(q, form_of(q)), "exact.") for q in map(catalogue().get, ("polar.map", "polar.jacobian")) if q
    ]
    assert book(pages).count("| `beta` |") == 1


def test_the_book_prints_no_guards_of_the_code():
    book = (Path(__file__).parents[3] / "docs" / "formulas.md").read_text()
    assert not [guard for guard in ("ratio", "hypot", "expm1") if f"operatorname{{{guard}}}" in book]
