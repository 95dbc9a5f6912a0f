"""`radartrack draft`: a claims file drafted from a paper's LaTeX source."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from radartrack._system import output_files, terminal
from radartrack.commands.find import proved, search_over
from radartrack.commands.seconds import seconds

if TYPE_CHECKING:
    from radartrack.derive.checking.papers.deadline import Decider
    from radartrack.derive.finding.paper_draft import Drafted
    from radartrack.derive.finding.paper_readings import Understood
    from radartrack.derive.formula.tree import Tree

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
    from radartrack.derive.finding import paper_draft, paper_equations, paper_readings

    output_files.refuse_unwritable({"--out": out}, kept=[paper])
    try:
        source = paper.read_bytes().decode("utf-8", errors="replace")
        said, displayed = paper_equations.equations_in_text(source), paper_equations.equations(source)
        everything = paper_readings.understood([*said, *displayed])
        known, found = paper_readings.defined(everything), everything[len(said) :]
    except (OSError, ValueError) as error:
        terminal.complain(f"{paper}: {error}")
        raise typer.Exit(CANNOT) from None
    if not found:
        terminal.complain(f"{paper}: no displayed equation was found")
        raise typer.Exit(CANNOT)
    with Decider(timeout) as decider:
        decider.start()
        drafted = _drafted(found, known, decider)
    text = paper_draft.claims(paper_equations.title(source), drafted)
    if out is None:
        terminal.say(text.rstrip())
    else:
        output_files.write(out, text)
    read = sum(one.tree is not None for one in found)
    named = sum(one.candidate is not None for one in drafted)
    counted = f"{read} read, {named} found in the catalogue, {len(found) - named} undecided"
    terminal.complain(f"{terminal.counted(len(found), 'equation')}: {counted}")


def _drafted(found: Sequence[Understood], known: Mapping[str, Tree], decider: Decider) -> list[Drafted]:
    """Each equation as the quantity that it is, by the paper's definitions where it uses any."""
    from radartrack.derive.finding import paper_draft, paper_readings

    search = search_over()
    drafted = []
    for one in found:
        readings = [*paper_readings.readings(one, known, paper_readings.beside(one, found))]
        pairs = (
            (candidate, put_in)
            for tree, put_in in readings
            for candidate, _ in proved(search.candidates(tree), decider)
            if paper_readings.is_credible(candidate, known, put_in)
        )
        candidate, put_in = next(pairs, (None, {}))
        if candidate is None:
            near = next((near for tree, _ in readings for near in search.slipped(tree)), None)
            drafted.append(paper_draft.Drafted(one, near=near))
            continue
        printed = paper_readings.by_definitions(one, put_in, candidate)
        if printed:
            itself = replace(candidate, formula=printed.formula, let=printed.let)
            printed = printed if any(proved([itself], decider)) else None
        drafted.append(paper_draft.Drafted(one, candidate, printed))
    return drafted
