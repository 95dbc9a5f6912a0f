r"""Kronecker products: F \otimes I_2 is kron(F, eye(2)), whatever stands around it."""

from __future__ import annotations

import re

_WORD = r"[A-Za-z]{1,40}"  # more in a row would be gone through again from each of them
_LETTER = rf"(?:\\{_WORD}\s*\{{\s*\\?{_WORD}\s*\}}|\\?{_WORD})(?:\s*_\s*(?:\{{[^{{}}]*\}}|\w))?"
_MATRIX = (
    r"(?:\\left\s*[\[(]\s*)?\\begin\s*\{(?:[bpvBV]?(?:small)?matrix|array)\}(?:(?!\\(?:begin|end)\s*\{).)*"
    r"\\end\s*\{\w+\}(?:\s*\\right\s*[\])])?"
)
_GROUP = r"(?:\\left\s*)?\([^()]*\)"
_IDENTITY = r"(?:\\[A-Za-z]{1,40}\s*\{\s*I\s*\}|I)\s*_\s*(?:\{\s*(?P<%s>\d)(?:\s*\\times\s*\d)?\s*\}|(?P<%s_>\d))"
_OPERAND = rf"(?:{_MATRIX}|{_GROUP}|{_LETTER})(?:\s*\^\s*(?:\{{[^{{}}]*\}}|\\?\w{{1,40}}))?"
_PRODUCT = re.compile(
    rf"(?:{_IDENTITY % ('n', 'n')}|(?P<first>{_OPERAND}))\s*\\otimes(?![A-Za-z])\s*"
    rf"(?:{_IDENTITY % ('m', 'm')}|(?P<second>{_OPERAND}(?:\s*{_OPERAND})*))",
    re.DOTALL,
)


def with_kronecker(text: str) -> str:
    """The text with the products as functions."""
    if "\\otimes" not in text:
        return text
    return _PRODUCT.sub(_as_function, text)


def _as_function(found: re.Match[str]) -> str:
    """The product; I_2 is the identity of two rows."""
    first = found["first"] or rf"\operatorname{{eye}}({found['n'] or found['n_']})"
    second = found["second"] or rf"\operatorname{{eye}}({found['m'] or found['m_']})"
    return rf"\operatorname{{kron}}({first}, {second})"
