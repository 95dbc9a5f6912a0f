"""`radartrack list`: the names of all quantities, with shapes, units and sources."""

from __future__ import annotations

from fnmatch import fnmatchcase
from typing import Annotated

import typer
from rich.markup import escape
from rich.table import Table

from radartrack._system import terminal
from radartrack.commands.model_file import ModelFile, all_quantities


def list_quantities(
    pattern: Annotated[str, typer.Argument(help="Part of a name, or a pattern such as 'polar.*.linear'.")] = "*",
    model: ModelFile = None,
) -> None:
    """List the quantities whose name holds PATTERN."""
    wanted = pattern if any(sign in pattern for sign in "*?[") else f"*{pattern}*"
    found = [quantity for quantity in all_quantities(model).values() if fnmatchcase(quantity.name, wanted)]
    if not found:
        terminal.complain(f"No quantity's name holds {pattern!r}.")
        raise typer.Exit(1)
    table = Table(box=None, pad_edge=False)
    for heading in ("name", "shape"):
        table.add_column(heading, no_wrap=True)
    for heading in ("unit", "meaning and source"):
        table.add_column(heading, overflow="fold")
    for quantity in found:
        shape = "×".join(map(str, quantity.shape)) or "scalar"
        meaning = f"{quantity.meaning} ({quantity.source})"
        table.add_row(quantity.name, shape, *map(escape, (quantity.unit_text, meaning)))
    console = terminal.console()
    console.width = max(console.width, terminal.PLAIN_WIDTH)  # names are never cut; a narrower terminal wraps
    console.print(table)
