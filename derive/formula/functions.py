"""The functions and verbs that a formula may use."""

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

# Verbs work on formulas, not on numbers: the fewest and the most arguments of each.
VERBS = MappingProxyType(
    {
        "chi2cdf": (2, 2),
        "chi2inv": (2, 2),
        "det": (1, 1),
        "diag": (1, 12),
        "diff": (2, 6),
        "expectation": (2, 2),
        "expm": (1, 1),
        "eye": (1, 1),
        "hessian": (2, 2),
        "integral": (4, 4),
        "inv": (1, 1),
        "jacobian": (2, 2),
        "kron": (2, 2),
        "limit": (3, 3),
        "norm": (1, 1),
        "outer": (2, 2),
        "sum": (4, 4),
        "taylor": (3, 3),
        "trace": (1, 1),
        "transpose": (1, 1),
    }
)

# The second argument of these is a name of their own: an index, a variable of integration, what goes to a limit.
BINDING = frozenset({"integral", "limit", "sum"})

OTHER_SPELLINGS = MappingProxyType(
    {"arccos": "acos", "arcsin": "asin", "arctan": "atan", "arctan2": "atan2", "ln": "log"}
)

SPELLINGS = MappingProxyType({name: name for name in NUMBER_OF_ARGUMENTS} | dict(OTHER_SPELLINGS))

EXPONENTIAL = frozenset({"cosh", "coth", "exp", "expm1", "sinh", "tanh"})

# \cos^2 x is the square of the cosine by a convention that covers these, and no others.
SQUARED_BY_NAME = frozenset(
    {"acos", "asin", "atan", "cos", "cosh", "cot", "coth", "csc", "log", "sec", "sin", "sinh", "tan", "tanh"}
)
