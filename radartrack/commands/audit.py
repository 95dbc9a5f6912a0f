"""`radartrack audit`: decide every claim of claims files and show a table of verdicts."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeElapsedColumn

from radartrack._system import output_files, terminal
from radartrack._system.progress import progress_on_terminals
from radartrack.commands.model_file import ModelFile, declared
from radartrack.commands.seconds import seconds

if TYPE_CHECKING:
    from radartrack.derive.checking.papers.claim import Claim
    from radartrack.derive.checking.papers.claims_file import ClaimsFile
    from radartrack.derive.checking.papers.deadline import Files

PROCESSES = 2


def audit(
    files: Annotated[
        list[Path] | None,
        typer.Argument(help="Claims files, or what is shipped by its name: papers, literature, libraries, prosov."),
    ] = None,
    json_out: Annotated[Path | None, typer.Option("--json", help="Write the verdicts here as JSON.")] = None,
    html_out: Annotated[Path | None, typer.Option("--html", help="Write a page with typeset formulas here.")] = None,
    timeout: Annotated[
        float, typer.Option(help="Seconds of computing after which a claim is given up.", min=0.1, callback=seconds)
    ] = 20.0,
    model: ModelFile = None,
) -> None:
    """Check every formula and number of a paper; a verdict that is not `equal` is no failure of the command.

    Exit 0, or 2 when a file or a claim in it cannot be read, or a result cannot be written.
    """
    from radartrack._reports import audit_page, audit_table
    from radartrack.derive.checking.papers.claim import ClaimsError
    from radartrack.derive.checking.papers.claims_file import read_claims

    try:
        claims = chosen(files)
        output_files.refuse_unwritable({"--json": json_out, "--html": html_out}, [*claims, *([model] if model else ())])
        beside = declared(model)
        papers = [read_claims(path, keep_unreadable=True) for path in claims]
    except ClaimsError as error:
        terminal.complain(str(error))
        raise typer.Exit(2) from None
    audits, problems = decided(papers, timeout, beside, typeset=html_out is not None)
    try:
        if json_out is not None:
            output_files.write(json_out, output_files.json_text({"papers": audits}))
        if html_out is not None:
            output_files.write(html_out, audit_page.page(audits))
    finally:  # what was decided is told in any case
        console = terminal.console()
        for paper in audits:
            audit_table.show(paper, console)
        for problem in problems:
            terminal.complain(problem)
    if problems:
        raise typer.Exit(2)


def chosen(files: list[Path] | None) -> list[Path]:
    """The claims files that are meant: a path is itself, a name that is no path the files shipped under it.

    Without any, the three papers whose experiments are repeated.

    Raises:
        ClaimsError: where there is neither.
    """
    from radartrack.derive.checking.papers.claim import ClaimsError
    from radartrack.derive.checking.papers.claims_file import shipped, shipped_names

    paths: list[Path] = []
    for one in files or [Path("papers")]:
        found = [one] if one.exists() or one.suffix else shipped(str(one))
        if not found:
            raise ClaimsError(
                f"{one}: no such file, and no claims are shipped by this name: {', '.join(shipped_names())}"
            )
        paths += found
    return paths


def decided(
    papers: list[ClaimsFile], timeout: float, beside: Files = (), *, typeset: bool
) -> tuple[list[dict[str, Any]], list[str]]:
    """The verdicts on each paper, and what is wrong with claims that cannot be read.

    Args:
        papers: whose claims are decided.
        timeout: seconds for each claim.
        beside: what is declared for all papers, beside what each declares itself.
        typeset: whether the verdicts hold formulas as MathML.
    """
    claims = [claim for paper in papers for claim in paper.claims]
    worlds: list[Files] = []
    for paper in papers:
        declared_for_it = (*paper.declared, *(one for one in beside if one not in paper.declared))
        worlds += [declared_for_it] * len(paper.claims)
    records, errors = _decided(claims, worlds, timeout, typeset=typeset)
    rest = iter(records)
    audits = [{**paper.told, "claims": [next(rest) for _ in paper.claims]} for paper in papers]
    places = [f"{paper.name}: " for paper in papers for _ in paper.claims]
    return audits, [place + error for place, error in zip(places, errors, strict=True) if error]


def _decided(
    claims: list[Claim], worlds: Sequence[Files], timeout: float, *, typeset: bool
) -> tuple[list[dict[str, Any]], list[str]]:
    """A record for each claim, and what is wrong with it where it cannot be read."""
    from radartrack.derive.checking.papers.claim import UnreadableClaim
    from radartrack.derive.checking.papers.deadline import decide_all, undecided

    processes = max(1, min(PROCESSES, os.cpu_count() or 1))
    with _progress(len(claims)) as step:
        answers = decide_all(claims, timeout, processes, step, worlds=worlds, typeset=typeset)
    errors = [str(answer) if isinstance(answer, UnreadableClaim) else "" for answer in answers]
    records = [
        undecided(claim, str(answer)) if isinstance(answer, UnreadableClaim) else answer
        for claim, answer in zip(claims, answers, strict=True)
    ]
    return records, errors


@contextmanager
def _progress(total: int) -> Iterator[Callable[[], None]]:
    """A bar on the error stream."""
    columns = (TextColumn("auditing"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with progress_on_terminals(*columns) as progress:
        task = progress.add_task("", total=total)
        yield lambda: progress.update(task, advance=1)
