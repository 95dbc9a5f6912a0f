"""What audits found, at a glance: how many claims of each paper and library are right, and what is wrong."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from enum import StrEnum
from html import escape
from typing import Any

from radartrack._reports import audit_text

Record = Mapping[str, Any]


class Rating(StrEnum):
    """What a reader wants to know of a claim."""

    RIGHT = "right"
    ELSEWHERE = "right under a condition or in another convention"
    WRONG = "wrong"
    OPEN = "undecided"


SECTIONS = {"paper": "Papers and books", "library": "Libraries"}
HEADS = {Rating.RIGHT: "right", Rating.ELSEWHERE: "right, if", Rating.WRONG: "wrong", Rating.OPEN: "open"}
EXPLAINED = (
    '<p class="where">Right is what is equal as it stands. Right, if: to an order, in a limit, or with another axis, '
    "order of the state or unit. Wrong is what differs and is right in none of these; open, what cannot be decided.</p>"
)
STYLE = """
table { border-collapse: collapse; width: 100%; margin: .8rem 0 1.6rem; font-variant-numeric: tabular-nums; }
th, td { border-top: 1px solid var(--line); padding: .35rem .6rem; text-align: right; vertical-align: top; }
th:first-child, td:first-child { text-align: left; padding-left: 0; }
th { color: var(--dim); font-weight: 600; font-size: .85rem; white-space: nowrap; }
td:last-child, th:last-child { padding-right: 0; }
td a { display: -webkit-box; -webkit-box-orient: vertical; -webkit-line-clamp: 2; overflow: hidden; }
td.wrong { color: var(--bad); font-weight: 600; } td a { color: inherit; }
tfoot td { font-weight: 600; } .finding h3 { margin-bottom: .3rem; }
.finding h3 a { color: inherit; min-width: 0; overflow-wrap: anywhere; }
.finding p a { color: inherit; }
@media (max-width: 40rem) {
  tr { display: grid; grid-template-columns: repeat(5, 1fr); } tr > :first-child { grid-column: 1 / -1; }
  td:not(:first-child) { border-top: 0; padding-top: 0; } th:first-child { display: none; }
  td, th { padding-left: 0; padding-right: 0; text-align: left; } thead tr { border-top: 0; }
}
.finding { border-left: 3px solid var(--bad); padding: .2rem 0 .2rem .9rem; margin: 1.1rem 0; border-top: 0; }
"""


def rating(record: Record) -> Rating:
    """Whether a claim is right, right in a way of its own, wrong, or open.

    Conditions that a claims file gives are what the paper speaks of, such as independent errors; what was found beside
    them, an order and a limit are ways of its own.
    """
    if record["verdict"] in audit_text.WRONG:
        return Rating.ELSEWHERE if any(one.startswith("equal ") for one in record["remarks"]) else Rating.WRONG
    if record["verdict"] == "undecided":
        return Rating.OPEN
    return Rating.ELSEWHERE if record.get("sense") else Rating.RIGHT


def summary(audits: Sequence[Mapping[str, Any]]) -> str:
    """How many claims there are, and how many of each rating."""
    ratings = [rating(record) for audit in audits for record in audit["claims"]]
    counts = Counter(ratings)
    return f"{len(ratings)} claims: " + ", ".join(f"{counts[one]} {one}" for one in Rating if counts[one])


def scoreboard(audits: Sequence[Mapping[str, Any]]) -> str:
    """A table for papers, one for libraries, and what is wrong in words; links lead to the sections of the page."""
    numbered = list(enumerate(audits))
    parts = [
        _table(heading, [(number, audit) for number, audit in numbered if audit.get("kind", "paper") == kind])
        for kind, heading in SECTIONS.items()
    ]
    wrong = [(audit, record) for audit in audits for record in audit["claims"] if rating(record) is Rating.WRONG]
    findings = "\n".join(_finding(audit, record) for audit, record in wrong)
    told = f'<section id="wrong">\n<h2>What is wrong</h2>\n{findings}\n</section>' if wrong else ""
    leads = '<p><a href="#wrong">What is wrong, and what a radar sees of it</a></p>' if wrong else ""
    return "\n".join([EXPLAINED, leads, *parts, told])


def _table(heading: str, audits: Sequence[tuple[int, Mapping[str, Any]]]) -> str:
    if not audits:
        return ""
    counts = [Counter(map(rating, audit["claims"])) for _, audit in audits]
    rows = [
        _row(f'<a href="#formulas-{number}">{escape(audit["paper"])}</a>', count)
        for (number, audit), count in zip(audits, counts, strict=True)
    ]
    heads = "".join(f"<th>{head}</th>" for head in ["", "claims", *HEADS.values()])
    total = _row("all", Counter(rating(record) for _, audit in audits for record in audit["claims"]))
    return (
        f"<section>\n<h2>{heading}</h2>\n<table>\n<thead><tr>{heads}</tr></thead>\n"
        f"<tbody>\n{chr(10).join(rows)}\n</tbody>\n<tfoot>{total}</tfoot>\n</table>\n</section>"
    )


def _row(name: str, count: Mapping[Rating, int]) -> str:
    cells = [f"<td>{sum(count.values())}</td>"]
    for one in Rating:
        number = count.get(one, 0)
        kind = ' class="wrong"' if one is Rating.WRONG and number else ""
        cells.append(f"<td{kind}>{number or '–'}</td>")
    return f"<tr><td>{name}</td>{''.join(cells)}</tr>"


def _finding(audit: Mapping[str, Any], record: Record) -> str:
    identity = escape(record["id"], quote=True)
    parts = [
        f'<h3><a href="#{identity}">{escape(record["id"])}</a> <span class="where">{escape(place(record))}</span></h3>',
        f"<p>{escape(audit['paper'])}</p>",
        *(f"<p>{text}</p>" for text in _told(record)),
    ]
    return f'<article class="finding {record["verdict"]}">{"".join(parts)}</article>'


def _told(record: Record) -> Iterator[str]:
    if record.get("matters"):
        yield escape(record["matters"])
    explained = dict(reversed(list(audit_text.explanation(record))))  # the first of each heading
    if not record.get("repair") and "perhaps meant" in explained:
        yield f"Right would be <code>{escape(explained['perhaps meant'])}</code>"
    if record.get("repair"):
        yield f"Right would be <code>{escape(record['repair'])}</code>"
    if "for example" in explained and record["derived"]:  # of equations it tells what they leave over
        yield f'<span class="where">For example {escape(explained["for example"])}.</span>'
    if record.get("finding"):
        name = escape(record["finding"], quote=True)
        yield f'<a href="findings/{name}.md">How to see it, and what to change</a>'


def place(record: Record) -> str:
    """Where a claim stands: an equation and page of a paper, a file and lines of a library."""
    lines = f", lines {record['lines']}" if record.get("lines") else ""
    page = f"p. {record['page']}" if record["page"] else ""
    file = f"{record['file'].rsplit('/', 1)[-1]}{lines}" if record.get("file") else ""
    return ", ".join(part for part in (record["equation"], page, file) if part)
