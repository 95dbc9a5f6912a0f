"""The experiments of a paper as a part of an HTML page: what was found, and figures that the page holds itself."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping, Sequence
from html import escape
from typing import NamedTuple

STYLE = """
table.findings { border-collapse: collapse; width: 100%; font-size: .92rem; margin: .75rem 0; }
.findings th, .findings td { text-align: left; vertical-align: top; padding: .35rem .6rem .35rem 0;
  border-top: 1px solid var(--line); }
.findings th { font-weight: 400; } .findings thead th { color: var(--dim); } .findings td { overflow-wrap: break-word; }
.agrees { color: var(--good); font-weight: 600; } .disagrees { color: var(--bad); font-weight: 600; }
.depends { color: var(--open); font-weight: 600; }
.found { font-size: 1.1rem; max-width: 46rem; }
.remark { display: block; color: var(--dim); font-size: .85rem; }
figure { margin: 1.5rem 0; } figcaption { font-size: .9rem; margin-top: .4rem; }
figure img { display: block; width: 100%; max-width: 46rem; height: auto; background: #fff; border-radius: .3rem; }
nav ul { padding-left: 1.2rem; }
:focus-visible { outline: 2px solid currentColor; outline-offset: 2px; }
@media (max-width: 44rem) { .findings thead { position: absolute; left: -100vw; }
  .findings tr { display: block; border-top: 1px solid var(--line); padding: .5rem 0; }
  .findings td, .findings th[scope=row] { display: block; border: 0; padding: .1rem 0; color: inherit; }
  .findings td::before { content: attr(data-label) ": "; color: var(--dim); font-weight: 400; }
  .findings td:empty { display: none; } .scroll { overflow-x: auto; } figure img { min-width: 36rem; } }
@media print { figure, tr { break-inside: avoid; } figure img { max-width: 100%; min-width: 0; } }
"""
CLASSES = {"agrees": "agrees", "differs": "disagrees", "depends": "depends"}
HEADINGS = {"printed": "the paper", "ours": "ours", "interval": "interval", "verdict": "verdict"}
NOTE = (
    "Intervals are of 95 % confidence if nothing else is said. “Depends”: the paper does not say what would decide it."
)


class Shown(NamedTuple):
    """A figure on the page: SVG, a caption, and what it shows in words."""

    svg: bytes
    caption: str
    alt: str


class Experiment(NamedTuple):
    """What is shown of one paper.

    Attributes:
        paper: the short name, as the claims file is called.
        title: the heading.
        findings: with the keys what, printed, ours, interval, verdict and remark.
        figures: in the order in which they are read, the one that shows what was found first.
        found: what was found, in a sentence or two.

    """

    paper: str
    title: str
    findings: Sequence[Mapping[str, str]]
    figures: Sequence[Shown]
    found: str = ""


def section(experiment: Experiment) -> str:
    """The experiments of one paper."""
    rows = "\n".join(map(_row, experiment.findings))
    headings = "".join(f'<th scope="col" role="columnheader">{h}</th>' for h in ("what", *HEADINGS.values()))
    figures = "\n".join(map(_figure, experiment.figures))
    found = f'<p class="found">{escape(experiment.found)}</p>\n' if experiment.found else ""
    return (
        f'<section id="{identity(experiment)}">\n<h2>{escape(experiment.title)}</h2>\n{found}{figures}\n'
        f'<h3>The paper’s numbers beside ours</h3>\n<p class="counts">{NOTE}</p>\n'
        f'<table class="findings" role="table">\n<thead role="rowgroup"><tr role="row">{headings}</tr></thead>\n'
        f'<tbody role="rowgroup">\n{rows}\n</tbody>\n</table>\n</section>'
    )


def identity(experiment: Experiment) -> str:
    """What links to the section name."""
    return f"experiments-{escape(experiment.paper, quote=True)}"


def _row(finding: Mapping[str, str]) -> str:
    remark = f'<span class="remark">{escape(finding["remark"])}</span>' if finding["remark"] else ""
    cells = "".join(
        f'<td role="cell" data-label="{HEADINGS[name]}">{escape(finding[name])}</td>'
        for name in HEADINGS
        if name != "verdict"
    )
    verdict = finding["verdict"]
    said = f'<td role="cell" data-label="verdict"><span class="{CLASSES[verdict]}">{verdict}</span></td>'
    return f'<tr role="row"><th scope="row" role="rowheader">{escape(finding["what"])}{remark}</th>{cells}{said}</tr>'


def _figure(shown: Shown) -> str:
    source = f"data:image/svg+xml;base64,{b64encode(shown.svg).decode('ascii')}"
    image = f'<img src="{source}" alt="{escape(shown.alt, quote=True)}">'
    label = escape(shown.caption.partition(":")[0].partition(".")[0], quote=True)
    framed = f'<div class="scroll" role="group" tabindex="0" aria-label="{label}">{image}</div>'
    return f"<figure>\n{framed}\n<figcaption>{escape(shown.caption)}</figcaption>\n</figure>"
