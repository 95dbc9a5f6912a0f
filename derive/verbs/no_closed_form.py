"""What is said when a verb has no closed form that is known here."""

from __future__ import annotations

from radartrack.derive.symbolic import Expr

SHOWN = 60  # characters of the part that was too much


class NoClosedForm(ValueError):
    """A sum, an integral, a limit or the like cannot be decided; the message names the part that was too much."""


def shown(expression: Expr) -> str:
    """A part of a formula in a message."""
    text = str(expression)
    return text if len(text) <= SHOWN else f"{text[: SHOWN - 3]}..."
