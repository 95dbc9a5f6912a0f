"""An audit, with experiments where there are any, as one HTML page that needs no network.

Formulas are MathML, which browsers typeset by themselves.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from html import escape
from importlib.resources import files
from typing import Any

from radartrack._reports import audit_text, experiment_section, scoreboard
from radartrack._reports.experiment_section import Experiment
from radartrack._system import harmless_text

STYLE = """
h3 { font-size: 1rem; margin: 0; display: flex; flex-wrap: wrap; gap: .25rem .75rem; align-items: baseline; }
h3 span { min-width: 0; overflow-wrap: anywhere; }
.counts { color: var(--dim); }
article { border-top: 1px solid var(--line); padding: .9rem 0; }
.verdict { font-weight: 600; } .equal .verdict, .equal_numerically .verdict { color: var(--good); }
.differs .verdict, .wrong_dimensions .verdict { color: var(--bad); }
.undecided .verdict, article .elsewhere.verdict { color: var(--open); }
.where { color: var(--dim); font-weight: 400; font-size: .9rem; }
.summary { font-size: 1.1rem; }
.filter { display: flex; flex-wrap: wrap; gap: .35rem 1.2rem; margin: .75rem 0 0; padding: .35rem .8rem .5rem;
  border: 1px solid var(--line); border-radius: .35rem; }
.filter legend { color: var(--dim); font-size: .85rem; padding: 0 .3rem; }
.filter label { cursor: pointer; } .filter input { accent-color: var(--accent); }
body:has(#show-wrong:checked) article:not(.differs, .wrong_dimensions),
body:has(#show-undecided:checked) article:not(.undecided),
body:has(#show-equal:checked) article:not(.equal, .equal_numerically) { display: none; }
dd .different { background: none; color: var(--good); }
nav a { color: inherit; }
@media print { article { break-inside: avoid; } .filter { display: none; } }
"""
KINDS = {
    "wrong": ("differs", "wrong_dimensions"),
    "undecided": ("undecided",),
    "equal": ("equal", "equal_numerically"),
}
"""What can be shown alone, in the order in which claims stand on the page."""
SAID = {"wrong": "not equal"}  # some of these are right in a convention of their own


@cache
def look() -> str:
    """What all pages look like."""
    return files("radartrack._reports").joinpath("look.css").read_text(encoding="utf-8")


def page(audits: Sequence[Mapping[str, Any]], experiments: Sequence[Experiment] = ()) -> str:
    """The whole page for some papers, after any experiments; what comes from files is escaped and made harmless."""
    audits = harmless_text.shown(audits)
    title = "Reproduction of papers" if experiments else "Audit of printed formulas"
    sections = [experiment_section.section(experiment) for experiment in experiments]
    sections += [_paper(audit, number) for number, audit in enumerate(audits)]
    style = look() + STYLE + (experiment_section.STYLE if experiments else "")
    contents = _contents(audits, experiments) if experiments else ""
    is_scoreboard = not experiments and len(audits) > 1
    records = [record for audit in audits for record in audit["claims"]]
    contents += _summary(records, scoreboard.summary(audits) if is_scoreboard else audit_text.summary(records))
    if is_scoreboard:
        style += scoreboard.STYLE
        sections.insert(0, scoreboard.scoreboard(audits))
    body = "\n".join(sections)
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{title}</title>\n"
        f"<style>{style}</style>\n</head>\n<body>\n<h1>{title}</h1>\n{contents}<main>\n{body}\n</main>\n</body>\n</html>\n"
    )


def _contents(audits: Sequence[Mapping[str, Any]], experiments: Sequence[Experiment]) -> str:
    links = [
        (experiment_section.identity(experiment), f"Experiments: {experiment.title}") for experiment in experiments
    ]
    links += [(f"formulas-{number}", f"Formulas: {audit['paper']}") for number, audit in enumerate(audits)]
    items = "\n".join(f'<li><a href="#{target}">{escape(words)}</a></li>' for target, words in links)
    return f'<nav aria-label="Contents">\n<ul>\n{items}\n</ul>\n</nav>\n'


def _summary(records: Sequence[Mapping[str, Any]], told: str) -> str:
    """What is told of all claims, how many are of each kind, and which are shown: a choice that needs no script."""
    counts = {kind: sum(record["verdict"] in verdicts for record in records) for kind, verdicts in KINDS.items()}
    found = [(kind, f"{count} {SAID.get(kind, kind)}") for kind, count in counts.items() if count]
    choices = [("all", f"all {len(records)}"), *found]
    labels = "\n".join(
        f'<label><input type="radio" name="show" id="show-{kind}"{" checked" if kind == "all" else ""}> {words}</label>'
        for kind, words in choices
    )
    return (
        f'<p class="summary">{escape(told)}</p>\n'
        f'<fieldset class="filter">\n<legend>Claims shown</legend>\n{labels}\n</fieldset>\n'
    )


def _rank(record: Mapping[str, Any]) -> int:
    """What is wrong comes first."""
    return next(rank for rank, verdicts in enumerate(KINDS.values()) if record["verdict"] in verdicts)


def _paper(audit: Mapping[str, Any], number: int) -> str:
    records = sorted(audit["claims"], key=_rank)
    articles = "\n".join(map(_claim, records))
    heading = f"<h2>{escape(audit['paper'])}</h2>"
    counted = f'<p class="counts">{escape(audit_text.summary(records))}</p>'
    origin = "".join(f'<p class="where">{escape(line)}</p>' for line in _origin(audit))
    return f'<section id="formulas-{number}">\n{heading}\n{counted}\n{origin}{articles}\n</section>'


def _origin(audit: Mapping[str, Any]) -> Iterator[str]:
    """Where the claims come from."""
    if audit.get("doi"):
        yield f"doi:{audit['doi']}"
    if audit.get("url"):
        commit = f", commit {audit['commit'][:12]}" if audit.get("commit") else ""
        yield f"{audit['url'].removeprefix('https://')}{commit}"
    if audit.get("seen"):
        yield f"Seen: {audit['seen']}"


def _claim(record: Mapping[str, Any]) -> str:
    verdict = record["verdict"]
    parts = [
        _heading(record, scoreboard.place(record)),
        f"<p><code>{escape(record['quantity'])}</code></p>" if record["quantity"] else "",
        _formula(record.get("printed_mathml", ""), record["printed"]),
        f"<p>{escape(record['reason'])}</p>",
        _details(record) if verdict in audit_text.WRONG else "",
        f'<p class="where">{escape(record["note"])}</p>' if record["note"] not in {"", record["printed"]} else "",
        f'<p class="where">Seen: {escape(record["seen"])}</p>' if record.get("seen") else "",
    ]
    identity = escape(record["id"], quote=True)
    return f'<article class="{verdict}" id="{identity}">{"".join(parts)}</article>'


def _heading(record: Mapping[str, Any], where: str) -> str:
    """The verdict beside the name; that of what is right in a convention of its own does not look like a fault."""
    verdict, kind = audit_text.WORDS[record["verdict"]], "verdict"
    if record["verdict"] in audit_text.WRONG and scoreboard.rating(record) is scoreboard.Rating.ELSEWHERE:
        verdict, kind = "right in another way", "verdict elsewhere"
    said = f'<span class="{kind}">{verdict}</span> <span class="where">{escape(where)}</span>'
    return f"<h3><span>{escape(record['id'])}</span> {said}</h3>"


def _formula(mathml: str, text: str) -> str:
    shown = mathml or f"<code>{escape(text)}</code>"
    return f'<div class="formula">{shown}</div>' if text else ""


def _details(record: Mapping[str, Any]) -> str:
    derived = _formula(record.get("derived_mathml", ""), record["derived"])
    items = [f"<dt>derived</dt><dd>{derived}</dd>" if derived else ""]
    for heading, text in audit_text.explanation({**record, "suggestions": []}):
        items.append(f"<dt>{escape(heading)}</dt><dd>{escape(text)}</dd>")
    items += _suggestions(record["suggestions"], record.get("suggestions_mathml", []))
    return f"<dl>{''.join(items)}</dl>"


def _suggestions(suggestions: Iterable[Mapping[str, Any]], typeset: Sequence[str]) -> list[str]:
    items = []
    for place, suggestion in enumerate(suggestions):
        entry = f"entry {list(suggestion['entry'])}: " if suggestion["entry"] else ""
        formula = _formula(typeset[place] if place < len(typeset) else "", suggestion["formula"])
        items.append(f"<dt>perhaps meant</dt><dd>{escape(entry + suggestion['edit'])}{formula}</dd>")
    return items
