"""The command line as a page, from its own help."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import typer.main

from radartrack.cli import app


def command_line() -> str:
    """All commands with their arguments and options."""
    group: Any = typer.main.get_command(app)
    parts = ["# Command line\n", "`radartrack COMMAND --help` says the same on the terminal.\n"]
    for name, command in group.commands.items():
        parts += [*_command(name, command)]
    return "\n".join(parts)


def _command(name: str, command: Any) -> Iterator[str]:
    usage = " ".join(filter(None, ["radartrack", name, *map(_usage, command.params)]))
    yield f"\n## {name}\n\n{command.help or ''}\n\n    {usage}\n"
    if any(one.name != "help" for one in command.params):
        yield "| | |\n|---|---|"
    for one in command.params:
        said = str(getattr(one, "help", "") or "").replace("|", "\\|").replace("\n", " ")
        default = one.default
        has_default = isinstance(default, str | int | float) and default not in {"", False}
        shown = f" By default {default}." if has_default else ""
        yield f"| {_name(one)} | {said}{shown} |"


def _usage(one: Any) -> str:
    if one.param_type_name != "argument":
        return ""
    many = " ..." if one.nargs == -1 else ""
    return f"{_argument(one)}{many}" if one.required else f"[{_argument(one)}{many}]"


def _argument(one: Any) -> str:
    return str(one.metavar or one.name).upper()


def _name(one: Any) -> str:
    if one.param_type_name == "argument":
        return f"`{_argument(one)}`"
    return ", ".join(f"`{name}`" for name in (*one.opts, *one.secondary_opts))
