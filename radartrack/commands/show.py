"""`radartrack show`: one formula, its symbols, its source."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

import typer

from radartrack._system import terminal
from radartrack.commands.model_file import ModelFile, own_quantities
from radartrack.commands.pairs import pairs


class Format(StrEnum):
    """How a formula is printed."""

    TEXT = "text"
    LATEX = "latex"
    PYTHON = "python"
    C = "c"


COMMENT = {Format.TEXT: "", Format.LATEX: "% ", Format.PYTHON: "# ", Format.C: "// "}
CODE = {Format.PYTHON, Format.C}


def show(
    name: Annotated[str, typer.Argument(help="A quantity, or one entry of it: 'polar.covariance.averaged[0,0]'.")],
    format: Annotated[Format, typer.Option(help="How to print it.")] = Format.TEXT,
    given: Annotated[list[str] | None, typer.Option(help="A condition: rho=0. May be repeated.")] = None,
    model: ModelFile = None,
) -> None:
    """Show one formula, its symbols, its conditioning and its source; what it prints, `check` reads."""
    from radartrack.commands import quantity_name
    from radartrack.derive.checking.question.compared_quantity import refer_to
    from radartrack.derive.checking.question.printed_formula import conditions_for
    from radartrack.derive.formula.error import FormulaError
    from radartrack.derive.writing import quantity_text

    quantity, index = quantity_name.read(name, own_quantities(model).values())
    if given and format in CODE:
        raise typer.BadParameter(f"code is that of the whole formula; leave --given or --format {format} out")
    try:
        conditions = conditions_for(refer_to(quantity), pairs(given or [], "--given"))
    except FormulaError as error:
        raise typer.BadParameter(error.message, param_hint="--given") from None
    for line in quantity_text.heading(quantity):
        terminal.say(f"{COMMENT[format]}{line}")
    if conditions:
        terminal.say(
            f"{COMMENT[format]}given:        {', '.join(f'{one} = {value}' for one, value in conditions.items())}"
        )
    if format in CODE:
        code = quantity_text.python if format is Format.PYTHON else quantity_text.c
        terminal.say(f"\n{code(quantity, index)}")
        return
    formula = {Format.TEXT: quantity_text.text, Format.LATEX: quantity_text.latex}[format]
    terminal.say(f"\n{formula(quantity, index, conditions)}")
