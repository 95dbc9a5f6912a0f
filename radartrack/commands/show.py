"""`radartrack show`: one formula, its symbols, its source."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

import typer

from radartrack._system import terminal
from radartrack.commands.model_file import ModelFile, own_quantities


class Format(StrEnum):
    """How a formula is printed."""

    TEXT = "text"
    LATEX = "latex"
    PYTHON = "python"


COMMENT = {Format.TEXT: "", Format.LATEX: "% ", Format.PYTHON: "# "}


def show(
    name: Annotated[str, typer.Argument(help="A quantity, or one entry of it: 'polar.covariance.averaged[0,0]'.")],
    format: Annotated[Format, typer.Option(help="How to print it.")] = Format.TEXT,
    model: ModelFile = None,
) -> None:
    """Show one formula, its symbols, its conditioning and its source."""
    from radartrack.commands import quantity_name
    from radartrack.derive.writing import quantity_text

    quantity, index = quantity_name.read(name, own_quantities(model).values())
    for line in quantity_text.heading(quantity):
        terminal.say(f"{COMMENT[format]}{line}")
    formula = {Format.TEXT: quantity_text.text, Format.LATEX: quantity_text.latex, Format.PYTHON: quantity_text.python}[
        format
    ]
    terminal.say(f"\n{formula(quantity, index)}")
