"""The domain of a certificate: the signs and zeros that its arguments may have, and the boxes of each such case."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from radartrack.verification.rounding.checker.known_numbers import Refused

Claim = Mapping[str, Any]
SMALLEST, LARGEST_CORRELATION = 1e-20, 0.99


def cases_of(claim: Claim) -> list[str]:
    """All choices of signs and zeros that the domain of a claim has."""
    found = [""]
    for argument in claim["arguments"]:
        choices = _choices(argument, correlated=claim["correlated"], sides=claim.get("sides") or claim["correlated"])
        found = [f"{head} {argument['name']}:{choice}".strip() for head in found for choice in choices]
    return found


def _choices(argument: Mapping[str, Any], *, correlated: bool, sides: bool) -> list[str]:
    """Signs and zeros that the domain has; of an angle the signs of cosine and sine, and which of them is small."""
    kind, reach = argument["kind"], max(-argument["low"], argument["high"])
    if argument.get("at_most"):
        return ["+"]
    if argument.get("whole"):
        return ["zero", "+"]  # beyond the least one
    if kind == "correlation":
        return ["+", "-"] if correlated else ["zero"]
    if kind == "angle":
        cosine = "+" if reach <= math.pi / 2 else "±"
        octants = [cosine + "±s"] + ([cosine + "±c"] if reach > math.pi / 4 else [])
        if sides:
            of = {"+": "+", "±": "+-"}
            octants = [c + s + o[2] for o in octants for c in of[o[0]] for s in (of[o[1]] if correlated else o[1])]
        return (["zero"] if argument["low"] <= 0 <= argument["high"] else []) + octants
    if kind == "signed":
        return ["zero", "±"] if -argument["low"] == argument["high"] else ["zero", "+", "-"]
    return ["+"] if argument["low"] > 0 else ["zero", "+"]


def boxes_of(claim: Claim, case: str, tree: str) -> Iterator[dict[str, tuple[float, float]]]:
    """The leaves of a tree in preorder; halves meet in one number, so nothing is left out between them."""
    chosen = chosen_in(case)
    present = [argument for argument in claim["arguments"] if chosen[argument["name"]] != "zero"]
    stack = [[_ends(argument, chosen[argument["name"]], claim["arguments"]) for argument in present]]
    for letter in tree:
        if not stack:
            raise Refused("a tree goes on after its end")
        box = stack.pop()
        if letter == ".":
            yield {argument["name"]: ends for argument, ends in zip(present, box, strict=True)}
            continue
        axis = ord(letter) - ord("a")
        if not 0 <= axis < len(box):
            raise Refused(f"a tree splits what is no coordinate: {letter}")
        low, high = box[axis]
        middle = (low + high) / 2
        stack.append([*box[:axis], (middle, high), *box[axis + 1 :]])
        stack.append([*box[:axis], (low, middle), *box[axis + 1 :]])
    if stack:
        raise Refused("a tree ends before its boxes cover the domain")


def _ends(argument: Mapping[str, Any], choice: str, arguments: Sequence[Mapping[str, Any]]) -> tuple[float, float]:
    """Of the logarithm of a size, or of an angle's distance from a quarter turn; a little wider than they need be."""
    reach = {"+": argument["high"], "-": -argument["low"]}.get(choice, max(abs(argument["low"]), abs(argument["high"])))
    low, high = (argument["low"] if argument["low"] > 0 else min(SMALLEST, reach)), reach
    if argument["kind"] == "angle":
        low, high = SMALLEST, min(reach, math.pi / 4 * (1 + 1e-9))
    if argument["kind"] == "correlation":
        low, high = SMALLEST, LARGEST_CORRELATION
    if argument.get("at_most"):
        low, high = argument["low"] / next(a["high"] for a in arguments if a["name"] == argument["at_most"]), 1.0
    elif argument.get("whole"):
        low, high = 1.0, max(argument["high"] - argument["low"], 1.0)
    return math.log(low) - 1e-12, math.log(high) + 1e-12


def chosen_in(case: str) -> dict[str, str]:
    """The choice of each argument."""
    return dict(item.rsplit(":", 1) for item in case.split())
