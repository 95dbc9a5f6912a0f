from html.parser import HTMLParser
from typing import Any
from xml.etree import ElementTree as ET

import pytest

from radartrack._reports import audit_page, audit_text
from radartrack.derive.checking.papers import audit, mathml
from radartrack.derive.checking.papers.claim import Claim

VOID = {"input", "meta"}


def _record(claim: Claim) -> dict[str, Any]:
    verdict = audit.decide(claim)
    return audit.record(claim, verdict) | mathml.formulas(claim, verdict)


@pytest.fixture(scope="module")
def html() -> str:
    claims = [
        Claim("a.right", "polar.map[0]", formula="r*cos(beta)", page="3"),
        Claim(
            "a.wrong",
            "polar.bias.second_order",
            formula="[r*cos(beta), r*sin(beta)]",
            given={"rho": "0"},
            note="<script>alert(1)</script>",
        ),
        Claim("a.number", "polar.map[0]", value="2.5", unit="km", at={"r": "3000", "beta": "0"}),
        Claim("a.open", undecided="nobody <b>knows</b> & cares"),
    ]
    return audit_page.page([{"paper": "<i>Smith</i> & Co", "file": "x", "claims": list(map(_record, claims))}])


class _Balance(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.links: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.links += [value or "" for name, value in attrs if name in {"src", "href", "action"}]
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def test_every_element_is_closed_and_nothing_is_fetched(html: str) -> None:
    parser = _Balance()
    parser.feed(html)
    assert parser.open == []
    assert parser.links == []
    assert "http" not in html
    assert "url(" not in html
    assert "<script" not in html


def test_what_a_claims_file_says_is_text_not_markup(html: str) -> None:
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in html
    assert "&lt;i&gt;Smith&lt;/i&gt; &amp; Co" in html
    assert "nobody &lt;b&gt;knows&lt;/b&gt; &amp; cares" in html


def test_light_and_dark_phones_and_print_are_provided_for(html: str) -> None:
    for rule in ("prefers-color-scheme: dark", "width=device-width", "@media print", "overflow-x: auto"):
        assert rule in html


def test_what_is_wrong_comes_first_and_can_be_shown_alone(html: str) -> None:
    order = [html.index(f'id="{identity}"') for identity in ("a.wrong", "a.open", "a.right")]
    assert order == sorted(order)
    assert html.index("4 claims: ") < order[0]
    for kind, words in (("all", "all 4"), ("wrong", "2 not equal"), ("undecided", "1 undecided"), ("equal", "1 equal")):
        assert f'id="show-{kind}"' in html
        assert f"> {words}</label>" in html


def test_the_part_that_a_suggestion_changes_stands_out() -> None:
    claim = Claim("a", "polar.unbiased.estimate[0]", formula="r*cos(beta)*(1 - sigma_beta^2/2)", given={"rho": "0"})
    record = _record(claim)
    (wrong,) = _standing_out(record["printed_mathml"])
    (meant,) = _standing_out(record["suggestions_mathml"][0])
    assert wrong == "1−σβ22"
    assert meant == "eσβ22"


def _standing_out(formula: str) -> list[str]:
    root = ET.fromstring(formula)  # noqa: S314 - our own output
    return ["".join(part.itertext()) for part in root.iter("mrow") if part.get("class") == "different"]


def test_formulas_are_typeset_and_verdicts_named(html: str) -> None:
    assert html.count("<math") >= 3
    for words in ("equal", "differs", "undecided", "perhaps meant", "p. 3"):
        assert words in html


@pytest.mark.parametrize(
    "formula",
    [
        "r**2*exp(-2*sigma_beta**2)*(cosh(2*sigma_beta**2) - cosh(sigma_beta**2))",
        "-(a - b)/(c + d)**2 - -x",
        "[[1, T_0], [0, sqrt(1 - u**2)]]",
        "cos(beta)**2*abs(x) + atan2(y, x) + pi + e**x",
        "0.5*x**(1/3)",
    ],
)
def test_mathml_is_well_formed_and_holds_every_symbol(formula: str) -> None:
    root = ET.fromstring(mathml.mathml(formula))  # noqa: S314 - our own output
    assert root.tag == "math"
    assert "".join(root.itertext()).strip()


def test_what_is_no_formula_is_not_typeset() -> None:
    assert mathml.mathml("r +") == ""
    assert mathml.mathml("x" * 5000) == ""


def test_values_are_said_as_people_say_them() -> None:
    assert audit_text.quantity_value(5e4, "m") == "50 km"
    assert audit_text.quantity_value(0.017453292519943295, "rad") == "1°"
    assert audit_text.quantity_value(50.0, "m") == "50 m"
    assert audit_text.quantity_value(0.5, "1") == "0.5"


def test_orders_tell_an_approximation_from_a_misprint() -> None:
    assert "as is the quantity itself" in audit_text.order(2, 2)
    assert "the quantity of order σ^2" in audit_text.order(4, 2)
    assert "only of order σ^2" in audit_text.order(0, 2)
