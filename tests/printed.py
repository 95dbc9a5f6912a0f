"""What two runs print, compared as a reader would: another processor may round the last digit otherwise."""

import re
from decimal import Decimal

NUMBER = re.compile(r"[-+−]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
COUNTED = 4  # a whole number of fewer digits may be counted, not measured, and has no last digit to round


def say_the_same(printed: str, written: str) -> bool:
    """Whether the words are equal, and measured numbers to one unit of the last place that is written."""
    if NUMBER.split(printed) != NUMBER.split(written):
        return False
    pairs = zip(NUMBER.findall(printed), NUMBER.findall(written), strict=True)
    return all(one == other or _nearly(one, other) for one, other in pairs)


def _nearly(one: str, other: str) -> bool:
    if not (_measured(one) and _measured(other)):
        return False
    first, second = _decimal(one), _decimal(other)
    places = max(int(value.as_tuple().exponent) for value in (first, second))
    return abs(first - second) <= Decimal(10) ** places


def _measured(number: str) -> bool:
    return not number.lstrip("-+−").isdigit() or len(number.lstrip("-+−")) >= COUNTED


def _decimal(number: str) -> Decimal:
    return Decimal(number.replace("−", "-"))
