"""The site has a page for every quantity of the formula book, made of the book and of the generated code."""

import re
import sys
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from radartrack.derive.catalogue import catalogue

BUILD = Path(__file__).parents[2] / "web" / "build"


@pytest.fixture(scope="module")
def modules() -> Any:
    sys.path.insert(0, str(BUILD))
    try:
        yield import_module("book_sections"), import_module("quantity_pages")
    finally:
        sys.path.remove(str(BUILD))


def test_every_quantity_has_a_page_with_formula_source_code_and_a_way_to_the_checker(modules: Any) -> None:
    book, pages = modules
    found = {section.name: section for section in book.sections()}
    assert found.keys() <= catalogue().keys()
    assert len(found) > 300
    texts = {name: pages.quantity_page(section) for name, section in found.items()}
    for name, text in texts.items():
        assert f"../../check/#quantity={name}" in text
        assert "- source: " in text
        assert "## In Python" in text
        assert set(re.findall(r"\]\(([\w.]+)\.md\)", text)) <= found.keys()
    assert "def map(" in texts["polar.map"]
    assert "r \\cos" in texts["polar.map"]
    assert "| `beta` |" in texts["polar.map"]


def test_a_formula_that_is_too_long_for_the_book_stands_on_its_page_by_entries(modules: Any) -> None:
    book, pages = modules
    long = import_module("long_formulas").long_formula
    sections = {section.name: section for section in book.sections()}
    covariance = pages.quantity_page(sections["polar.unbiased.covariance"], long("polar.unbiased.covariance"))
    assert "Without correlation" in covariance
    assert "[0,1] = [1,0] &= " in covariance
    assert "Too long" not in covariance
    hessian = long("observe.spherical.hessian")
    assert "Without correlation" not in hessian
    assert "The other entries are 0." in hessian
    assert long("bistatic.covariance.truth.fourth_order") == ""


def test_the_book_is_taken_apart_without_a_rest(modules: Any) -> None:
    book, _ = modules
    text = book.BOOK.read_text(encoding="utf-8")
    assert len(book.sections()) == text.count("\n### ")
    assert sum(bool(section.latex) for section in book.sections()) == text.count("\n```math\n")
    assert "operator" in book.introduction()
    assert "doi.org" in book.bibliography()
