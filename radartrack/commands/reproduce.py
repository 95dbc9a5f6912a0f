"""`radartrack reproduce`: the experiments of the papers again, their figures, and their numbers beside ours."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from enum import StrEnum
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console
from rich.markup import escape
from rich.progress import SpinnerColumn, TextColumn, TimeElapsedColumn
from rich.table import Table

from radartrack._system import output_files, terminal, written_files
from radartrack._system.progress import progress_on_terminals

if TYPE_CHECKING:
    from radartrack._reports.experiment_section import Experiment
    from radartrack.reproduction.papers import Paper
    from radartrack.reproduction.results import Reproduction

PLAIN_WIDTH = 140  # in a file or a pipe
TIMEOUT = 20.0
REPORT = "report.html"
KINDS = {".csv", ".svg", ".png"}
STYLES = {"agrees": "green", "differs": "bold red", "depends": "yellow"}


class PaperName(StrEnum):
    """The papers whose experiments are here."""

    PROSOV = "prosov"
    GAO = "gao"
    GORSHKOV = "gorshkov"


def reproduce(
    papers: Annotated[list[PaperName] | None, typer.Argument(help="Which; without any, all.")] = None,
    out: Annotated[Path, typer.Option(help="Directory for figures, data and report.html.")] = Path("reproduction"),
    fast: Annotated[bool, typer.Option("--fast", help="A tenth of the trials: wider intervals.")] = False,
) -> None:
    """Repeat the experiments of the papers: figures (SVG, PNG), data (CSV), a table of findings, and one report.

    Exit 0 whatever is found, 2 without matplotlib or where the directory cannot be written.
    """
    if find_spec("matplotlib") is None:
        _refuse("reproduce draws figures and needs the extra: pip install radartrack[plots]")
    from radartrack.reproduction.papers import PAPERS

    _make(out)
    names = [str(name) for name in dict.fromkeys(papers or PaperName)]
    if theirs := _in_the_way(out, names):
        _refuse(f"--out: {out / theirs[0]} is in the way: it was not written by this command, or was edited since.")
    output_files.refuse_unwritable({REPORT: out / REPORT})
    console = terminal.console(PLAIN_WIDTH)
    experiments = []
    with _progress() as step:
        for name in names:
            found = PAPERS[name].reproduce(step, fast=fast)
            step(f"{found.title}: figures")
            experiments.append(_written(PAPERS[name], found, out))
            _show(found, console)
    written_files.write(out, REPORT, _report(names, experiments))
    terminal.say(f"\nFigures, data and report.html are in {terminal.one_line(str(out))}")


def _make(out: Path) -> None:
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        _refuse(f"{out}: {error.strerror or error}")


def _in_the_way(out: Path, papers: Sequence[str]) -> list[str]:
    """What is not ours and is called as what will be written."""
    found = written_files.owners(out)
    begins = tuple(f"{paper}_" for paper in papers)
    return sorted(
        name
        for name in found.others | found.edited
        if name in {REPORT, written_files.RECORD} or (name.startswith(begins) and Path(name).suffix in KINDS)
    )


def _refuse(reason: str) -> None:
    terminal.complain(reason)
    raise typer.Exit(2)


def _written(paper: Paper, found: Reproduction, out: Path) -> Experiment:
    """Write tables and figures; what the report shows of them."""
    from radartrack._reports.experiment_section import Experiment, Shown

    for name, table in (*found.tables.items(), ("findings", found.findings_table())):
        written_files.write(out, f"{found.paper}_{name}.csv", table.csv())
    shown = []
    for picture in sorted(paper.pictures(found), key=lambda one: one.name != found.shown_by):
        for name, content in picture.files().items():
            written_files.write(out, name, content)
        shown.append(Shown(picture.svg(), picture.caption, picture.alt))
    return Experiment(found.paper, found.title, [vars(finding) for finding in found.findings], shown, found.found)


def _report(names: Sequence[str], experiments: Sequence[Experiment]) -> str:
    """The experiments and the audit of the same papers on one page."""
    from radartrack._reports import audit_page
    from radartrack.commands.audit import decided
    from radartrack.derive.checking.papers.claims_file import read_claims, shipped

    files = {file.stem: file for file in shipped()}
    claims = [read_claims(files[name]) for name in names]
    audits, _ = decided(claims, TIMEOUT, typeset=True)
    return audit_page.page(audits, experiments)


def _show(found: Reproduction, console: Console) -> None:
    """The findings of one paper, the paper's number first."""
    console.print(f"\n[bold]{_cell(found.title)}[/bold]", highlight=False)
    if found.found:
        console.print(_cell(found.found), highlight=False)
    table = Table(box=None, pad_edge=False)
    for heading, share in (("what", 4), ("the paper", 2), ("ours", 3), ("interval", 2)):
        table.add_column(heading, overflow="fold", ratio=share)
    table.add_column("verdict", no_wrap=True)
    for finding in found.findings:
        cells = map(_cell, (finding.what, finding.printed, finding.ours, finding.interval))
        table.add_row(*cells, f"[{STYLES[finding.verdict]}]{finding.verdict}[/]")
    console.print(table, highlight=False)


def _cell(text: str) -> str:
    return escape(terminal.one_line(text))


@contextmanager
def _progress() -> Iterator[Callable[[str], None]]:
    """What is worked on, on the error stream."""
    columns = (SpinnerColumn(), TimeElapsedColumn(), TextColumn("{task.description}"))
    with progress_on_terminals(*columns) as progress:
        task = progress.add_task("", total=None)
        yield lambda description: progress.update(task, description=description)
