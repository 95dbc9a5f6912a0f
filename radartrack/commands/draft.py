"""`radartrack draft`: a claims file drafted from a paper's LaTeX source."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from radartrack._system import output_files, terminal
from radartrack.commands.find import proved, search_over
from radartrack.commands.seconds import seconds

if TYPE_CHECKING:
    from radartrack.derive.checking.papers.deadline import Decider
    from radartrack.derive.finding.paper_draft import Drafted, Understood

CANNOT = 2


def draft(
    paper: Annotated[Path, typer.Argument(help="The LaTeX source of a paper.")],
    out: Annotated[Path | None, typer.Option(help="Write the claims file here instead of showing it.")] = None,
    timeout: Annotated[
        float, typer.Option(help="Seconds after which one proof is given up.", min=0.1, callback=seconds)
    ] = 10.0,
) -> None:
    """Draft a claims file: each equation of PAPER with its number, found in the catalogue or left undecided.

    Exit 2 when the source cannot be read or holds no displayed equation.
    """
    from radartrack.derive.checking.papers.deadline import Decider
    from radartrack.derive.finding import paper_draft

    output_files.refuse_unwritable({"--out": out})
    try:
        source = paper.read_bytes().decode("utf-8", errors="replace")
        found = paper_draft.understood(paper_draft.equations(source))
    except (OSError, ValueError) as error:
        terminal.complain(f"{paper}: {error}")
        raise typer.Exit(CANNOT) from None
    if not found:
        terminal.complain(f"{paper}: no displayed equation was found")
        raise typer.Exit(CANNOT)
    with Decider(timeout) as decider:
        decider.start()
        drafted = _drafted(found, paper_draft.definitions_in_text(source), decider)
    text = paper_draft.claims(paper_draft.title(source), drafted)
    if out is None:
        terminal.say(text.rstrip())
    else:
        output_files.write(out, text)
    read = sum(one.tree is not None for one in found)
    named = sum(one.candidate is not None for one in drafted)
    counted = f"{read} read, {named} found in the catalogue, {len(found) - named} undecided"
    terminal.complain(f"{len(found)} equations: {counted}")


def _drafted(found: Sequence[Understood], in_text: Sequence[Understood], decider: Decider) -> list[Drafted]:
    """Each equation as the quantity that it is, by the paper's definitions, displayed or in its text."""
    from radartrack.derive.finding import paper_draft

    search, known = search_over(), paper_draft.defined([*in_text, *found])
    drafted = []
    for one in found:
        trees = (paper_draft.with_definitions(one, known), one.tree)  # by the paper's definitions, else as printed
        pairs = (pair for tree in trees if tree is not None for pair in proved(search.candidates(tree), decider))
        candidate = next((candidate for candidate, _ in pairs), None)
        printed = paper_draft.by_definitions(one, known, candidate) if candidate else None
        if candidate and printed:
            itself = replace(candidate, formula=printed.formula, let=printed.let)
            printed = printed if any(proved([itself], decider)) else None
        drafted.append(paper_draft.Drafted(one, candidate, printed))
    return drafted
