"""`radartrack list`: the quantities that words mean, with shapes, units and sources."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Annotated

import typer
from rich.markup import escape
from rich.table import Table

from radartrack._system import terminal
from radartrack.commands.model_file import ModelFile, all_quantities

if TYPE_CHECKING:
    from radartrack.derive.language.quantity import Quantity


def list_quantities(
    words: Annotated[
        list[str] | None,
        typer.Argument(help="Words of the field, part of a name, or a pattern such as 'polar.*.linear'."),
    ] = None,
    model: ModelFile = None,
) -> None:
    """List the quantities that WORDS mean, the best first: by name, meaning, source, symbols and the field's words."""
    from radartrack.derive.finding.word_search import by_words, missed

    found = by_words(words or [], all_quantities(model).values())
    if not found:
        terminal.complain(f"Nothing is called {' '.join(words or [])!r}; `radartrack list` shows all quantities.")
        raise typer.Exit(1)
    if unknown := missed(words or [], found):
        said = " and ".join(map(repr, unknown))
        terminal.complain(f"No quantity is about {said}; these have the other words.")
    console = terminal.console()
    if console.is_terminal:
        console.width = max(console.width, terminal.PLAIN_WIDTH)  # names are never cut; a narrower terminal wraps
        console.print(_table(found))
        return
    for quantity in found:
        terminal.say("  ".join(_facts(quantity)))


def _facts(quantity: Quantity) -> Iterator[str]:
    yield quantity.name
    yield "×".join(map(str, quantity.shape)) or "scalar"
    yield quantity.unit_text
    yield f"{quantity.meaning} ({quantity.source})"


def _table(quantities: Sequence[Quantity]) -> Table:
    table = Table(box=None, pad_edge=False)
    for heading in ("name", "shape"):
        table.add_column(heading, no_wrap=True)
    for heading in ("unit", "meaning and source"):
        table.add_column(heading, overflow="fold")
    for quantity in quantities:
        table.add_row(*map(escape, _facts(quantity)))
    return table
