"""`radartrack check`: compare a printed formula with the derived one."""

from __future__ import annotations

from typing import Annotated, Literal

import typer
from rich.text import Text

from radartrack._system import output_files, terminal
from radartrack.commands.code_argument import code_argument
from radartrack.commands.model_file import ModelFile, declared
from radartrack.commands.pairs import pairs
from radartrack.commands.seconds import seconds

EXIT = {"equal": 0, "equal_numerically": 0, "differs": 1, "wrong_dimensions": 1, "undecided": 3}
COLOURS = {"equal": "green", "equal_numerically": "green", "differs": "red", "wrong_dimensions": "red"}


def check(
    name: Annotated[str, typer.Argument(help="A quantity, one entry of it, or an expression over quantities.")],
    formula: Annotated[str, typer.Argument(help="The printed formula; arrays as nested lists.")],
    latex: Annotated[bool, typer.Option("--latex", help="The formula is LaTeX.")] = False,
    code: Annotated[
        Literal["python", "c", "cpp", "matlab"] | None,
        typer.Option(help="The formula is code, or FILE:function, or FILE:first-last."),
    ] = None,
    given: Annotated[list[str] | None, typer.Option(help="A condition: rho=0. May be repeated.")] = None,
    let: Annotated[
        list[str] | None, typer.Option(help="The paper's own name: D_beta=sigma_beta**2. May be repeated.")
    ] = None,
    timeout: Annotated[
        float, typer.Option(help="Seconds of computing after which the check is given up.", min=0.1, callback=seconds)
    ] = 20.0,
    model: ModelFile = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the verdict as JSON.")] = False,
) -> None:
    """Say whether a printed formula is right, where it is wrong, and what was probably meant.

    Exit 0 when it is equal, 1 when it differs, 2 when it cannot be read, 3 when nothing can be decided in time.
    """
    from radartrack.derive.checking.papers.claim import Claim, UnreadableClaim
    from radartrack.derive.checking.papers.deadline import Decider

    if latex and code:
        raise typer.BadParameter("a formula is LaTeX or code, not both", param_hint="--code")
    if not formula.strip():
        terminal.complain("the formula is empty")
        raise typer.Exit(2)
    source, function = code_argument(formula) if code else ("", "")
    claim = Claim(
        id="formula",
        quantity=name,
        formula="" if latex or code else formula,
        code=source,
        language=code or "",
        function=function,
        latex=formula if latex else "",
        given=pairs(given or [], "--given"),
        let=pairs(let or [], "--let"),
    )
    files = declared(model)
    try:
        with Decider(timeout) as decider:
            record = decider.decide(claim, files)
    except UnreadableClaim as error:
        terminal.complain(str(error).removeprefix("claim 'formula': "))
        raise typer.Exit(2) from None
    if as_json:
        terminal.say(output_files.json_text(record).rstrip())
    else:
        _tell(terminal.shown(record), echo=bool(latex or code or not formula.isascii()))
    raise typer.Exit(EXIT[record["verdict"]])


def _tell(record: dict[str, object], *, echo: bool) -> None:
    from radartrack._reports import audit_text

    verdict = str(record["verdict"])
    if echo:
        terminal.say(f"read as: {_typeset(str(record['printed']))}")
    words, rest = audit_text.headline(record)
    terminal.console().print(Text.assemble((words, f"bold {COLOURS.get(verdict, '')}"), rest), soft_wrap=True)
    if verdict != "equal" and record["derived"]:
        terminal.say(f"derived: {record['derived']}")
    for heading, text in audit_text.explanation(record):
        terminal.say(f"{heading}: {text}")


def _typeset(formula: str) -> str:
    """A formula for the eye, where it is one."""
    from radartrack.derive.formula.typeset import to_typeset
    from radartrack.derive.reading import FormulaError, read_text

    try:
        return to_typeset(read_text(formula, None))
    except FormulaError:
        return formula
