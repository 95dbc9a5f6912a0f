"""An audit, with experiments where there are any, as one HTML page that needs no network.

Formulas are MathML, which browsers typeset by themselves.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from html import escape
from typing import Any

from radartrack._reports import audit_text, experiment_section
from radartrack._reports.experiment_section import Experiment
from radartrack._system import harmless_text

STYLE = """
:root { color-scheme: light dark; --ink: #1c1e21; --paper: #fcfcfa; --line: #d8d8d2; --dim: #63666b;
  --good: #1d6b3a; --bad: #a3231f; --open: #7a5a00; --wash: #f2f2ee; }
@media screen and (prefers-color-scheme: dark) { :root { --ink: #e6e6e3; --paper: #17181a; --line: #3a3c40;
  --dim: #a2a5aa; --good: #74c990; --bad: #ff8d86; --open: #e3bd55; --wash: #202225; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 62rem; padding: 1.5rem 1rem 4rem; color: var(--ink); background: var(--paper);
  font: 1rem/1.5 system-ui, sans-serif; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2.5rem; line-height: 1.35; }
h3 { font-size: 1rem; margin: 0; display: flex; flex-wrap: wrap; gap: .25rem .75rem; align-items: baseline; }
.counts { color: var(--dim); }
article { border-top: 1px solid var(--line); padding: .9rem 0; }
.verdict { font-weight: 600; } .equal .verdict, .equal_numerically .verdict { color: var(--good); }
.differs .verdict, .wrong_dimensions .verdict { color: var(--bad); } .undecided .verdict { color: var(--open); }
.where { color: var(--dim); font-weight: 400; font-size: .9rem; }
p { margin: .35rem 0; overflow-wrap: anywhere; } h3 span { min-width: 0; overflow-wrap: anywhere; }
dl { margin: .5rem 0 0; } dt { color: var(--dim); font-size: .85rem; margin-top: .45rem; }
dd { margin: 0; overflow-wrap: anywhere; } code { font: .88rem/1.45 ui-monospace, monospace; }
.formula { overflow-x: auto; overflow-y: hidden; padding: .3rem .6rem; background: var(--wash); border-radius: .3rem;
  margin: .35rem 0; }
math { font-family: "STIX Two Math", "Cambria Math", "Latin Modern Math", math; font-size: 1.15rem; }
math[display=block] { width: max-content; }
.array { border: solid currentColor; border-width: 0 1px; border-radius: .6em; padding: 0 .25em; }
nav a { color: inherit; }
@media print { body { max-width: none; font-size: 10pt; padding: 0; } article { break-inside: avoid; }
  .formula { background: none; border: 1px solid var(--line); overflow: visible; } }
"""


def page(audits: Sequence[Mapping[str, Any]], experiments: Sequence[Experiment] = ()) -> str:
    """The whole page for some papers, after any experiments; what comes from files is escaped and made harmless."""
    audits = harmless_text.shown(audits)
    title = "Reproduction of papers" if experiments else "Audit of printed formulas"
    sections = [experiment_section.section(experiment) for experiment in experiments]
    sections += [_paper(audit, number) for number, audit in enumerate(audits)]
    style = STYLE + experiment_section.STYLE if experiments else STYLE
    contents = _contents(audits, experiments) if experiments else ""
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


def _paper(audit: Mapping[str, Any], number: int) -> str:
    records = audit["claims"]
    articles = "\n".join(map(_claim, records))
    heading = f"<h2>{escape(audit['paper'])}</h2>"
    counted = f'<p class="counts">{escape(audit_text.summary(records))}</p>'
    return f'<section id="formulas-{number}">\n{heading}\n{counted}\n{articles}\n</section>'


def _claim(record: Mapping[str, Any]) -> str:
    verdict = record["verdict"]
    places = [record["equation"], f"p. {record['page']}" if record["page"] else ""]
    where = ", ".join(place for place in places if place)
    parts = [
        _heading(record["id"], audit_text.WORDS[verdict], where),
        f"<p><code>{escape(record['quantity'])}</code></p>" if record["quantity"] else "",
        _formula(record.get("printed_mathml", ""), record["printed"]),
        f"<p>{escape(record['reason'])}</p>",
        _details(record) if verdict in audit_text.WRONG else "",
        f'<p class="where">{escape(record["note"])}</p>' if record["note"] not in {"", record["printed"]} else "",
    ]
    identity = escape(record["id"], quote=True)
    return f'<article class="{verdict}" id="{identity}">{"".join(parts)}</article>'


def _heading(identity: str, verdict: str, where: str) -> str:
    said = f'<span class="verdict">{verdict}</span> <span class="where">{escape(where)}</span>'
    return f"<h3><span>{escape(identity)}</span> {said}</h3>"


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
