"""Reads `NAME` or `NAME[i,j]` from the command line."""

from __future__ import annotations

import re
from collections.abc import Iterable

import typer

from radartrack.derive.catalogue import UnknownQuantity
from radartrack.derive.checking.question.world import CATALOGUE
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index

PATTERN = re.compile(r"(?P<name>[\w.]+)(?:\[(?P<index>\s*\d+\s*(?:,\s*\d+\s*)*)\])?")


def read(text: str, own: Iterable[Quantity] = ()) -> tuple[Quantity, Index | None]:
    """The quantity, and the entry that is meant; None for the whole.

    Args:
        text: as it was typed.
        own: quantities beside those of the catalogue.

    Raises:
        typer.BadParameter: when there is no such quantity or no such entry.
    """
    match = PATTERN.fullmatch(text.strip())
    if match is None:
        raise typer.BadParameter(f"{text!r} is no name of a quantity; write polar.map or polar.map[0]")
    try:
        quantity = CATALOGUE.having(own).find(match["name"])
    except UnknownQuantity as error:
        raise typer.BadParameter(str(error)) from None
    if match["index"] is None:
        return quantity, None
    index = tuple(int(number) for number in match["index"].split(","))
    fits = len(index) == len(quantity.shape) and all(i < n for i, n in zip(index, quantity.shape, strict=True))
    if not fits:
        raise typer.BadParameter(f"{text}: {quantity.name} has shape {list(quantity.shape)}, indices count from 0")
    return quantity, index
