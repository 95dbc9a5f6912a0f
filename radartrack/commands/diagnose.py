"""`radartrack diagnose`: is this function the derived quantity? `radartrack points`: where to compute it."""

from __future__ import annotations

import codecs
from pathlib import Path
from typing import Annotated, Any

import typer

from radartrack._system import output_files, terminal
from radartrack.commands.model_file import ModelFile, declared, own_quantities
from radartrack.commands.pairs import pairs
from radartrack.commands.seconds import seconds

RIGHT = {"agrees", "loses_digits"}
CANNOT = 2


def diagnose(
    what: Annotated[str, typer.Argument(help="FILE.py:FUNCTION; with --table the name of the quantity.")],
    name: Annotated[str | None, typer.Argument(help="A quantity, or one entry of it: 'polar.jacobian[0,1]'.")] = None,
    argument: Annotated[
        list[str] | None, typer.Option(help="What a parameter takes: px=x, or state=x,y for a vector. May be repeated.")
    ] = None,
    degrees: Annotated[bool, typer.Option("--degrees", help="The function takes degrees.")] = False,
    variances: Annotated[
        bool, typer.Option("--variances", help="The function takes variances, not deviations.")
    ] = False,
    given: Annotated[list[str] | None, typer.Option(help="A symbol that is known: rho=0. May be repeated.")] = None,
    table: Annotated[
        Path | None, typer.Option(help="Values that another language computed at what `radartrack points` wrote.")
    ] = None,
    timeout: Annotated[
        float, typer.Option(help="Seconds that a call of the function may take.", min=0.1, callback=seconds)
    ] = 60.0,
    model: ModelFile = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the diagnosis as JSON.")] = False,
) -> None:
    """Say whether a function is the derived quantity, how exact it is, or which slip it has.

    Exit 0 when it is, 1 when it is not, 2 when it cannot be run.
    """
    from radartrack.testing.function_process import CannotRun

    known = _numbers(given)
    try:
        if table is not None:
            if name is not None:
                raise typer.BadParameter("with --table there is no function, but the name of a quantity alone")
            record = _of_table(what, table, known, model)
        else:
            conventions = {"degrees": degrees, "variances": variances}
            record = _of_function(what, name, argument, known, timeout, model, conventions)
    except CannotRun as error:
        terminal.complain(str(error))
        raise typer.Exit(CANNOT) from None
    text = record.pop("text")
    terminal.say(output_files.json_text(record).rstrip() if as_json else text)
    raise typer.Exit(0 if record["verdict"] in RIGHT else 1)


def points(
    name: Annotated[str, typer.Argument(help="A quantity, or one entry of it.")],
    out: Annotated[Path, typer.Option(help="The file to write, comma-separated values.")],
    given: Annotated[list[str] | None, typer.Option(help="A symbol that is known: rho=0. May be repeated.")] = None,
    model: ModelFile = None,
) -> None:
    """Write the points at which another language computes a quantity, one a line, for `diagnose --table`."""
    from radartrack.testing.value_tables import points_table

    output_files.refuse_unwritable({"--out": out}, kept=[model] if model else ())
    wanted = _wanted(name, _numbers(given), model)
    output_files.write(out, points_table(wanted))
    entries = len(wanted.places)
    terminal.say(
        f"{out}: add {entries} column{'s' * (entries > 1)} with the values, then radartrack diagnose --table {out} "
        f"'{wanted.name}'"
    )


def _of_function(
    what: str,
    name: str | None,
    argument: list[str] | None,
    given: dict[str, float],
    timeout: float,
    model: Path | None,
    conventions: dict[str, bool],
) -> dict[str, Any]:
    from radartrack.testing.function_process import diagnosed

    file, _, function = what.rpartition(":")
    if not file or not function or name is None:
        raise typer.BadParameter("say FILE.py:FUNCTION and the name of a quantity, such as tracker.py:to_xy polar.map")
    if not Path(file).is_file():
        raise typer.BadParameter(f"there is no file {file}")
    _wanted(name, given, model)
    taken = {
        key: value.split(",") if "," in value else value for key, value in pairs(argument or [], "--argument").items()
    }
    options = {**conventions, "given": given, "files": declared(model)}
    return diagnosed({"file": file, "function": function, "name": name, "arguments": taken, **options}, timeout)


def _of_table(name: str, table: Path, given: dict[str, float], model: Path | None) -> dict[str, Any]:
    from radartrack.testing.examination import Examination
    from radartrack.testing.function_conventions import AS_ASKED
    from radartrack.testing.function_process import CannotRun
    from radartrack.testing.reading import CannotDiagnose
    from radartrack.testing.value_tables import tabulated

    wanted = _wanted(name, given, model)
    try:
        function = tabulated(wanted, _text(table))
        taken = {f"argument {place + 1}": symbol.name for place, symbol in enumerate(wanted.symbols)}
        found = Examination(function, wanted, taken, AS_ASKED).diagnosis()
    except CannotDiagnose as error:
        raise CannotRun(f"{table}: {error}") from None
    return {**found.record, "text": str(found)}


def _text(table: Path) -> str:
    """Of a file as other programs write it: in UTF-8, in UTF-16 as Excel's Unicode text, or in one byte a character."""
    data = table.read_bytes()
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return data.decode("utf-16", errors="replace")
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def _wanted(name: str, given: dict[str, float], model: Path | None) -> Any:
    from radartrack.testing.wanted import wanted_by

    own = own_quantities(model).values()
    try:
        return wanted_by(name, given, own)
    except (KeyError, ValueError) as error:
        raise typer.BadParameter(str(error)) from None


def _numbers(given: list[str] | None) -> dict[str, float]:
    """Conditions with a number each."""
    found: dict[str, float] = {}
    for name, value in pairs(given or [], "--given").items():
        try:
            found[name] = float(value)
        except ValueError:
            raise typer.BadParameter(
                f"{name} must be a number, such as 0; given {value!r}", param_hint="--given"
            ) from None
    return found
