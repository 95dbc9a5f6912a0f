"""The command line."""

from __future__ import annotations

import traceback
from collections.abc import Iterator
from concurrent.futures import BrokenExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from radartrack._system import terminal, termination
from radartrack.commands.audit import audit
from radartrack.commands.check import check
from radartrack.commands.diagnose import diagnose, points
from radartrack.commands.draft import draft
from radartrack.commands.find import find
from radartrack.commands.list_quantities import list_quantities
from radartrack.commands.regenerate import regenerate
from radartrack.commands.reproduce import reproduce
from radartrack.commands.show import show
from radartrack.commands.tables.convert_plots import convert
from radartrack.commands.verify import verify

CANNOT = 2  # read, write, or go on; 1 says that something was found to be wrong


class Commands(TyperGroup):
    """The commands, on any terminal; what cannot be read or written ends them with one line."""

    def main(self, *args: Any, **kwargs: Any) -> Any:
        """Run a command line."""
        terminal.prepare()
        try:
            with termination.obeyed():
                return super().main(*args, **kwargs)
        except OSError as error:  # where the usage or an error was to be shown
            terminal.report_lost_output(error)
            raise SystemExit(CANNOT) from None

    def make_context(self, *args: Any, **kwargs: Any) -> Any:
        """Read the command line; it may ask for help, which is then shown."""
        with _failing_in_one_line():
            return super().make_context(*args, **kwargs)

    def invoke(self, ctx: Any) -> Any:
        """Run the command."""
        with _failing_in_one_line():
            return super().invoke(ctx)


@contextmanager
def _failing_in_one_line() -> Iterator[None]:
    try:
        yield
    except OSError as error:
        terminal.report_lost_output(error)
    except SystemExit as end:  # Typer, which has shown a completion; or Rich, where a reader of the help went away
        if not end.code:
            raise typer.Exit from None
    except KeyboardInterrupt as interrupt:
        raise typer.Exit(termination.exit_code(interrupt)) from None
    except BrokenExecutor:
        terminal.complain("A process that did a part of the work has ended before its time; is there enough memory?")
    except Exception as error:
        if isinstance(error, typer.Abort) or hasattr(error, "exit_code"):  # of the command line itself
            raise
        terminal.complain(_fault(error))
    else:
        return
    raise typer.Exit(CANNOT)


def _fault(error: Exception) -> str:
    """What a report of the fault needs."""
    place = traceback.extract_tb(error.__traceback__)[-1]
    said = f"{type(error).__name__}: {error}"
    return f"This is a fault of radartrack, please report it: {said} ({Path(place.filename).name}, line {place.lineno})"


app = typer.Typer(
    cls=Commands,
    name="radartrack",
    help="Derive, generate, verify and check the formulas of radar tracking.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
)


def _tell_version(asked: bool) -> None:
    if asked:
        from importlib.metadata import version

        terminal.say(f"radartrack {version('radartrack')}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool, typer.Option("--version", help="Show the version and exit.", callback=_tell_version, is_eager=True)
    ] = False,
) -> None:
    """What belongs to no command."""


app.command()(regenerate)
app.command(name="list")(list_quantities)
app.command()(show)
app.command(context_settings={"ignore_unknown_options": True})(check)  # a formula may begin with a minus sign
app.command(context_settings={"ignore_unknown_options": True})(find)  # likewise
app.command()(diagnose)
app.command()(points)
app.command()(draft)
app.command()(audit)
app.command()(verify)
app.command()(reproduce)
app.command()(convert)
