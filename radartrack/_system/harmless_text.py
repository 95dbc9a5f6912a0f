"""Text of strangers that does nothing where it is shown: no escapes, nothing that reorders it, no lines of its own."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping, Sequence
from typing import Any

_UNSEEN = {"Cc", "Cf", "Cs", "Zl", "Zp"}
_HARMLESS = set("\n\t\u200c\u200d\u2061\u2062\u2063\u2064")  # joiners of letters, and what MathML does not show


def harmless(text: str) -> str:
    """The text with what a terminal would obey, or what would reorder it, written out: ESC is shown as its number."""
    return "".join(_written_out(sign) if _is_unseen(sign) else sign for sign in text)


def one_line(text: str) -> str:
    """Harmless, and without line breaks, so that it cannot pass for another line."""
    return harmless(re.sub(r"\s*[\n\r\t\v\f\x85\u2028\u2029]\s*", " ", text))


def shown(record: Any) -> Any:
    """A record for people: every text in it, keys too, on one harmless line."""
    match record:
        case str():
            return one_line(record)
        case Mapping():
            return {shown(name): shown(value) for name, value in record.items()}
        case Sequence():
            return [shown(value) for value in record]
    return record


def _is_unseen(sign: str) -> bool:
    return not sign.isprintable() and unicodedata.category(sign) in _UNSEEN and sign not in _HARMLESS


def _written_out(sign: str) -> str:
    return sign.encode("ascii", "backslashreplace").decode() if ord(sign) > 127 else f"\\x{ord(sign):02x}"
