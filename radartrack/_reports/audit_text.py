"""What an audit found, in words: one line of reasons and numbers for each record of a claim."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

Record = Mapping[str, Any]

WORDS = {
    "equal": "equal",
    "equal_numerically": "equal, not proved",
    "differs": "differs",
    "wrong_dimensions": "wrong dimensions",
    "undecided": "undecided",
}
WRONG = ("differs", "wrong_dimensions")
HUGE = 1e4


def summary(records: Sequence[Record]) -> str:
    """How many claims there are, and how many of each verdict."""
    counts = Counter(WORDS[record["verdict"]] for record in records)
    claims = "1 claim" if len(records) == 1 else f"{len(records)} claims"
    return f"{claims}: " + ", ".join(f"{count} {words}" for words, count in counts.items())


def headline(record: Record) -> tuple[str, str]:
    """The verdict in words, and what follows them in the same line: conditions or reasons."""
    under = f" when {' and '.join(record['conditions'])}" if record["conditions"] else ""
    match record["verdict"]:
        case "equal":
            return "equal, proved", under
        case "equal_numerically":
            return record["reason"], ""
        case "undecided":
            return "cannot decide", f": {record['reason']}".replace(": cannot decide", "")
        case verdict:
            return WORDS[verdict], f": {record['reason']}"


def explanation(record: Record) -> Iterator[tuple[str, str]]:
    """Pairs of heading and text that explain a record beyond its reason."""
    if record.get("reading"):
        yield "read with", ", ".join(record["reading"])
    if example := record["counterexample"]:
        yield "for example", _example(example)
        if worst := _worst(example):
            yield "at worst", worst
    if record["order"]:
        yield "order", order(*record["order"])
    for remark in record["remarks"]:
        if remark not in record["reason"]:
            yield "but" if remark.startswith("equal ") else "note", remark
    for suggestion in record["suggestions"]:
        yield "perhaps meant", _suggestion(suggestion)
    for one in record.get("terms", ()):
        entry = f"entry {list(one['entry'])}: " if one["entry"] else ""
        yield "differs in", f"{entry}{one['term']}: printed {one['printed']}, derived {one['derived']}"


def conditions(record: Record) -> str:
    """Under which conditions or at which values a claim was decided."""
    values = ", ".join(f"{name} = {value}" for name, value in record.get("at", {}).items())
    return " and ".join(record["conditions"]) or values


def order(difference: int, quantity: int) -> str:
    """What the leading orders tell."""
    if difference <= quantity:
        return (
            f"the difference is of order {_power(difference)}, as is the quantity itself"
            if (difference == quantity)
            else f"the difference is of order {_power(difference)}, the quantity only of order {_power(quantity)}"
        )
    return (
        f"the difference is of order {_power(difference)} in the deviations, the quantity of order {_power(quantity)}"
    )


def quantity_value(value: float, unit: str) -> str:
    """A value for people: angles in degrees, lengths in kilometres where they are long."""
    if unit == "rad":
        return f"{number(math.degrees(value))}°"
    if unit == "m" and abs(value) >= 1000:
        return f"{number(value / 1000)} km"
    return number(value) if unit == "1" else f"{number(value)} {unit}"


def number(value: float) -> str:
    """Six digits."""
    return f"{value:.6g}"


def percent(relative: float) -> str:
    """A relative difference."""
    if relative > HUGE:
        return f"a factor of {relative:.1e}"
    digits = f"{relative * 100:.3g}"
    return f"{float(digits):.0f} %" if "e+" in digits else f"{digits} %"


def _power(exponent: int) -> str:
    return {0: "1", 1: "σ"}.get(exponent, f"σ^{exponent}")


def _example(example: Record) -> str:
    units = example["units"]
    values = [f"{name} = {quantity_value(value, units.get(name, '1'))}" for name, value in example["point"].items()]
    entry = f" entry {list(example['entry'])}:" if example["entry"] else ""
    place = f"at {', '.join(values)}:" if values else ""
    derived = f"derived {number(example['derived'])}"
    if example["printed"] is None:
        return f"{place}{entry} what is printed is not real, {derived}".strip()
    compared = f"{place}{entry} printed {number(example['printed'])}, {derived}".strip()
    relative = example["relative_difference"]  # none beyond the numbers of a machine
    return compared if relative is None else f"{compared}, relative difference {percent(relative)}"


def _worst(example: Record) -> str:
    relative = example["largest_relative_difference"]
    if relative is None or not example["largest_at"]:  # of a number the example says it all
        return ""
    units = example["units"]
    values = (
        f"{name} = {quantity_value(value, units.get(name, '1'))}" for name, value in example["largest_at"].items()
    )
    against = example.get("measured_against") or "the derived value"
    return f"{percent(relative)} of {against}, at {', '.join(values)}"


def _suggestion(suggestion: Record) -> str:
    entry = f"entry {list(suggestion['entry'])}: " if suggestion["entry"] else ""
    if suggestion.get("definition"):
        entry = "--let "
    unproved = "" if suggestion["proved"] else " (equal to 50 digits, not proved)"
    if suggestion["edit"].startswith("this is "):
        return f"{entry}{suggestion['edit']}{unproved}"
    return f"{entry}{suggestion['formula']}   [{suggestion['edit']}]{unproved}"
