"""`radartrack find`: which quantity a formula is, whatever its letters are."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from importlib.resources import files
from typing import TYPE_CHECKING, Annotated

import typer

from radartrack._system import terminal
from radartrack.commands.seconds import seconds

if TYPE_CHECKING:
    from radartrack.derive.checking.papers.deadline import Decider
    from radartrack.derive.finding.formula_search import Candidate, FormulaSearch

PROVED = 6  # candidates that are proved, of those that are worth the same
FOUND, ONLY_NEAR, UNREADABLE = 0, 1, 2


def find(
    formula: Annotated[str, typer.Argument(help="The printed formula, in any letters; arrays as nested lists.")],
    latex: Annotated[bool, typer.Option("--latex", help="The formula is LaTeX.")] = False,
    timeout: Annotated[
        float, typer.Option(help="Seconds after which a proof is given up.", min=0.1, callback=seconds)
    ] = 20.0,
) -> None:
    """Say which quantity a formula is, under which condition and in which convention.

    Exit 0 when it is one, 1 when one is only near or none is, 2 when it cannot be read.
    """
    from radartrack.derive.checking.papers.deadline import Decider
    from radartrack.derive.finding.free_letters import read_free
    from radartrack.derive.formula.error import FormulaError

    try:
        tree = read_free(formula, latex=latex)
    except FormulaError as error:
        terminal.complain(str(error))
        raise typer.Exit(UNREADABLE) from None
    with Decider(timeout) as decider:
        decider.start()
        search = catalogue_search()
        found = list(proved(search.candidates(tree), decider))
    for candidate, proof in found:
        _tell(candidate, proof)
    if found:
        raise typer.Exit(FOUND)
    near = search.near(tree)
    for candidate in near:
        _tell(candidate, f"near: at most {candidate.difference * 100:.2g} % apart at three points")
    if not near:
        terminal.complain("No quantity of the catalogue is this formula, nor near it.")
    raise typer.Exit(ONLY_NEAR)


def catalogue_search() -> FormulaSearch:
    """The search over the catalogue, by the values that `radartrack regenerate` wrote."""
    from radartrack.derive.finding.formula_search import FormulaSearch

    text = files("radartrack.generated").joinpath("screening.json").read_text(encoding="utf-8")
    return FormulaSearch(json.loads(text))


def proved(candidates: Sequence[Candidate], decider: Decider) -> Iterator[tuple[Candidate, str]]:
    """Those that a formula is proved to be, or is to many digits, and which of the two."""
    from radartrack.derive.checking.papers.claims_file import Claim, UnreadableClaim

    for candidate in candidates[:PROVED]:
        claim = Claim("formula", candidate.quantity, candidate.formula, given=candidate.given, let=candidate.let)
        try:
            record = decider.decide(claim)
        except UnreadableClaim:
            continue  # an entry that the quantity of today does not have
        if record["verdict"] in {"equal", "equal_numerically"}:
            yield candidate, "proved" if record["verdict"] == "equal" else record["reason"]


def _tell(candidate: Candidate, proof: str) -> None:
    conditions = [f"{name} = {value}" for name, value in candidate.given.items()]
    when = f" when {' and '.join(conditions)}" if conditions else ""
    convention = f" {candidate.convention}" if candidate.convention else ""
    read = ", ".join(f"{letter} for {symbol}" for letter, symbol in candidate.read.items())
    terminal.say(f"{candidate.quantity}{when}{convention}: {proof}" + (f", with {read}" if read else ""))
    terminal.say(f"    {candidate.meaning}")
