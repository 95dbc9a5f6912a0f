from html.parser import HTMLParser
from typing import Any

import pytest

from radartrack._reports import audit_page
from radartrack._reports.scoreboard import Rating, place, rating
from radartrack.derive.checking.papers.audit import decide, record
from radartrack.derive.checking.papers.claim import Claim
from radartrack.derive.checking.papers.claims_file import ClaimsFile


def told(claim: Claim) -> dict[str, Any]:
    return record(claim, decide(claim))


INDEPENDENT = {"rho": "0"}
RIGHT = Claim("a.right", "polar.map[0]", formula="r*cos(beta)")
GIVEN = Claim("a.given", "polar.bias.second_order[0]", formula="-r*cos(beta)*sigma_beta^2/2", given=INDEPENDENT)
ORDER = Claim("a.order", "polar.bias.truth[0]", formula="-r*cos(beta)*sigma_beta^2/2", given=INDEPENDENT, to_order=2)
OTHER_AXIS = Claim("a.axis", "polar.map", formula="[r*sin(beta), r*cos(beta)]")
OPEN = Claim("a.open", undecided="nobody knows")
WRONG = Claim(
    "b.wrong",
    "polar.map[0]",
    formula="r*cos(beta)/2",
    file="src/<b>map.m",
    lines="3-4",
    matters="Targets at 100 km are <i>seen</i> at 50 km.",
    finding="half_the_range",
)


@pytest.mark.parametrize(
    ("claim", "expected"),
    [
        (RIGHT, Rating.RIGHT),
        (GIVEN, Rating.RIGHT),
        (ORDER, Rating.ELSEWHERE),
        (OTHER_AXIS, Rating.ELSEWHERE),
        (OPEN, Rating.OPEN),
        (WRONG, Rating.WRONG),
    ],
    ids=lambda value: value.id if isinstance(value, Claim) else "",
)
def test_what_a_claim_is_rated(claim: Claim, expected: Rating) -> None:
    assert rating(told(claim)) is expected


@pytest.fixture(scope="module")
def html() -> str:
    paper = ClaimsFile("a.toml", "Smith 2001", (RIGHT, ORDER, OPEN), seen="on page 3")
    library = ClaimsFile(
        "b.toml", "A <library>", (WRONG,), kind="library", url="https://example.org/b", commit="c" * 40
    )
    audits = [{**one.told, "claims": [told(claim) for claim in one.claims]} for one in (paper, library)]
    return audit_page.page(audits)


class Page(HTMLParser):
    """The links of a page, what is open, and the cells of its tables."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.open: list[str] = []
        self.cells: list[str] = []
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.links += [value or "" for name, value in attrs if name in {"href", "src"}]
        if tag == "td":
            self.cells.append("")
        if tag not in {"meta", "input"}:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if "td" in self.open:
            self.cells[-1] += data


def test_papers_and_libraries_are_counted(html: str) -> None:
    assert Page(html).cells == [
        *["Smith 2001", "3", "1", "1", "–", "1"],
        *["all", "3", "1", "1", "–", "1"],
        *["A <library>", "1", "–", "–", "1", "–"],
        *["all", "1", "–", "–", "1", "–"],
    ]


def test_links_lead_to_the_page_itself_and_to_findings(html: str) -> None:
    page = Page(html)
    assert page.open == []
    assert page.links == ["#wrong", "#formulas-0", "#formulas-1", "#b.wrong", "findings/half_the_range.md"]
    for link in page.links[:4]:
        assert f'id="{link[1:]}"' in html


def test_all_are_counted_at_the_top_and_what_is_right_in_another_way_is_no_fault(html: str) -> None:
    ways = "right under a condition or in another convention"
    assert f'<p class="summary">4 claims: 1 right, 1 {ways}, 1 wrong, 1 undecided</p>' in html
    paper = ClaimsFile("a.toml", "Smith 2001", (OTHER_AXIS, WRONG))
    page = audit_page.page([{**paper.told, "claims": [told(claim) for claim in paper.claims]}])
    assert page.count('<span class="verdict elsewhere">right in another way</span>') == 1
    assert page.count('<span class="verdict">differs</span>') == 1


def test_what_is_wrong_is_told_in_words_where_it_stands_and_made_harmless(html: str) -> None:
    assert "Targets at 100 km are &lt;i&gt;seen&lt;/i&gt; at 50 km." in html
    assert "What is wrong" in html
    assert place(told(WRONG)) == "<b>map.m, lines 3-4"
    assert "<b>" not in html
    for words in ("example.org/b, commit cccccccccccc", "Seen: on page 3"):
        assert words in html
