"""`radartrack audit`: decide every claim of claims files and show a table of verdicts."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

if TYPE_CHECKING:
    from radartrack.derive.checking.papers.claims_file import Claim, ClaimsFile

PROCESSES = 2
PLAIN_WIDTH = 120  # in a file or a pipe


def audit(
    files: Annotated[
        list[Path] | None, typer.Argument(help="Claims files; without any, the papers that are shipped.")
    ] = None,
    json_out: Annotated[Path | None, typer.Option("--json", help="Write the verdicts here as JSON.")] = None,
    html_out: Annotated[Path | None, typer.Option("--html", help="Write a page with typeset formulas here.")] = None,
    timeout: Annotated[float, typer.Option(help="Seconds after which a claim is given up.", min=0.1)] = 20.0,
) -> None:
    """Check every formula and number of a paper; a verdict that is not `equal` is no failure of the command.

    Exit 0, or 2 when a file or a claim in it cannot be read.
    """
    from radartrack._reports import audit_page, audit_table
    from radartrack.derive.checking.papers.claims_file import ClaimsError, read_claims, shipped

    try:
        papers = [read_claims(path, keep_unreadable=True) for path in files or shipped()]
    except ClaimsError as error:
        typer.echo(str(error), err=True)
        raise typer.Exit(2) from None
    audits, problems = decided(papers, timeout, typeset=html_out is not None)
    console = Console() if sys.stdout.isatty() else Console(width=PLAIN_WIDTH)
    for paper in audits:
        audit_table.show(paper, console)
    if json_out is not None:
        _write(json_out, json.dumps({"papers": audits}, indent=2, ensure_ascii=False) + "\n")
    if html_out is not None:
        _write(html_out, audit_page.page(audits))
    for problem in problems:
        typer.echo(problem, err=True)
    if problems:
        raise typer.Exit(2)


def decided(papers: list[ClaimsFile], timeout: float, *, typeset: bool) -> tuple[list[dict[str, Any]], list[str]]:
    """The verdicts on each paper, and what is wrong with claims that cannot be read."""
    claims = [claim for paper in papers for claim in paper.claims]
    records, errors = _decided(claims, timeout, typeset=typeset)
    rest = iter(records)
    audits = [{"paper": p.paper, "file": p.name, "claims": [next(rest) for _ in p.claims]} for p in papers]
    places = [f"{paper.name}: " for paper in papers for _ in paper.claims]
    return audits, [place + error for place, error in zip(places, errors, strict=True) if error]


def _decided(claims: list[Claim], timeout: float, *, typeset: bool) -> tuple[list[dict[str, Any]], list[str]]:
    """A record for each claim, and what is wrong with it where it cannot be read."""
    from radartrack.derive.checking.papers.claims_file import UnreadableClaim
    from radartrack.derive.checking.papers.deadline import decide_all, undecided

    processes = max(1, min(PROCESSES, os.cpu_count() or 1))
    with _progress(len(claims)) as step:
        answers = decide_all(claims, timeout, processes, step, typeset=typeset)
    errors = [str(answer) if isinstance(answer, UnreadableClaim) else "" for answer in answers]
    records = [
        undecided(claim, str(answer)) if isinstance(answer, UnreadableClaim) else answer
        for claim, answer in zip(claims, answers, strict=True)
    ]
    return records, errors


def _write(path: Path, text: str) -> None:
    try:
        path.write_text(text, encoding="utf-8")
    except OSError as error:
        typer.echo(f"{path}: {error.strerror or error}", err=True)
        raise typer.Exit(2) from None


@contextmanager
def _progress(total: int) -> Iterator[Callable[[], None]]:
    """A bar on the error stream."""
    columns = (TextColumn("auditing"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("", total=total)
        yield lambda: progress.update(task, advance=1)
