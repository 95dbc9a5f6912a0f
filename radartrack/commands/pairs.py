"""Reads options that set a name: `--given rho=0`, `--let D=sigma_r**2`."""

from __future__ import annotations

import typer


def pairs(given: list[str], option: str, form: str = "name=formula, such as rho=0") -> dict[str, str]:
    """`name=value` as a mapping.

    Raises:
        typer.BadParameter: for what is no such pair, and for a name that is given twice.
    """
    found: dict[str, str] = {}
    for one in given:
        name, sign, value = one.partition("=")
        if not sign or not name.strip() or not value.strip():
            raise typer.BadParameter(f"{one!r} must be {form}", param_hint=option)
        if name.strip() in found:
            raise typer.BadParameter(f"{name.strip()} is given twice", param_hint=option)
        found[name.strip()] = value.strip()
    return found
