"""The command line."""

from __future__ import annotations

import typer

from radartrack.commands.audit import audit
from radartrack.commands.check import check
from radartrack.commands.list_quantities import list_quantities
from radartrack.commands.regenerate import regenerate
from radartrack.commands.reproduce import reproduce
from radartrack.commands.show import show
from radartrack.commands.verify import verify

app = typer.Typer(
    name="radartrack",
    help="Derive, generate, verify and check the formulas of radar tracking.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
)
app.command()(regenerate)
app.command(name="list")(list_quantities)
app.command()(show)
app.command(context_settings={"ignore_unknown_options": True})(check)  # a formula may begin with a minus sign
app.command()(audit)
app.command()(verify)
app.command()(reproduce)
