"""The functions that a formula may use."""

from __future__ import annotations

from types import MappingProxyType

NUMBER_OF_ARGUMENTS = MappingProxyType(
    {
        "abs": 1,
        "acos": 1,
        "asin": 1,
        "atan": 1,
        "atan2": 2,
        "cos": 1,
        "cosh": 1,
        "cot": 1,
        "coth": 1,
        "csc": 1,
        "exp": 1,
        "expm1": 1,
        "hypot": 2,
        "log": 1,
        "sec": 1,
        "sin": 1,
        "sinh": 1,
        "sqrt": 1,
        "tan": 1,
        "tanh": 1,
    }
)

OTHER_SPELLINGS = MappingProxyType({"arccos": "acos", "arcsin": "asin", "arctan": "atan", "ln": "log"})

SPELLINGS = MappingProxyType({name: name for name in NUMBER_OF_ARGUMENTS} | dict(OTHER_SPELLINGS))

EXPONENTIAL = frozenset({"cosh", "coth", "exp", "expm1", "sinh", "tanh"})

# \cos^2 x is the square of the cosine by a convention that covers these, and no others.
SQUARED_BY_NAME = frozenset(
    {"acos", "asin", "atan", "cos", "cosh", "cot", "coth", "csc", "log", "sec", "sin", "sinh", "tan", "tanh"}
)
