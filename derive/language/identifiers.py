"""Names that modules, functions and arguments of generated code can carry."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable
from keyword import iskeyword

RESERVED = frozenset(
    {"Filled", "Floats", "arguments", "covariance", "i", "len", "math", "mean", "np", "npt", "range", "result"}
)
"""What generated functions use themselves."""
MODULES = frozenset({"conversions", "convert", "elementary", "loops"})
"""Generated modules and headers that belong to no model."""


def require_names(what: str, names: Iterable[str]) -> None:
    """Check names that a user chose.

    Raises:
        ValueError: when one is no Python identifier, is a keyword, begins with an underscore, is used by generated
            code itself, or occurs twice.
    """
    names = list(names)
    for name in names:
        if not name.isidentifier() or iskeyword(name) or unicodedata.normalize("NFKC", name) != name:
            raise ValueError(f"{what} must be an identifier of Python and no keyword; given {name!r}")
        if name in RESERVED or name.startswith("_"):
            used = ", ".join(sorted(RESERVED))
            raise ValueError(f"{what} must not begin with _ nor be {used}, which generated code uses; given {name!r}")
    if len(set(names)) != len(names):
        raise ValueError(f"{what} must occur once; given {', '.join(names)}")


def require_text(what: str, text: object) -> None:
    """Check text that is written into documentation: one line of it.

    Raises:
        ValueError: it is empty, or holds line breaks or other characters that cannot be printed.
    """
    if not isinstance(text, str) or not text.strip() or not text.isprintable():
        raise ValueError(f"{what} must be one line of printable text; given {text!r}")
