"""The arguments of a function in one box of its domain, as the rules of arithmetic take them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any, NamedTuple

from radartrack.verification.rounding.checker.arithmetic import Box
from radartrack.verification.rounding.checker.domain_cases import SMALLEST, Claim
from radartrack.verification.rounding.checker.followed_statements import Run
from radartrack.verification.rounding.checker.known_numbers import DOUBLE, SINGLE, Number, Refused
from radartrack.verification.rounding.checker.sums.ball_ends import Ball

PRECISIONS = {"double": DOUBLE, "single": SINGLE}


class Way(NamedTuple):
    """Of telling errors; `Box` says what each is."""

    in_parts: bool
    rounded_whole: bool = False
    signed_whole: bool = False
    factors_whole: bool = False
    by_argument: bool = False


def with_arguments(claim: Claim, chosen: Mapping[str, str], ends: Mapping[str, tuple[float, float]], way: Way) -> Run:
    """The start of a run: every argument has a value, or is zero."""
    import flint  # noqa: PLC0415

    box = Box(flint, PRECISIONS[claim["precision"]], *way)
    run = Run(box)
    for argument in claim["arguments"]:
        name, choice = argument["name"], chosen[argument["name"]]
        low, high = (box.ball(end) for end in ends.get(name, (0.0, 0.0)))
        if argument.get("at_most"):
            run.names[name] = _share_of(run, argument, low, high)
        elif argument.get("whole"):
            run.names[name] = _whole(box, argument, choice, low, high)
        elif choice == "zero":
            run.names[name] = None
            run.waves["sin", name], run.waves["cos", name] = None, box.constant(1)
        elif argument["kind"] == "angle":
            _turn(run, name, choice, low, high)
            reach = max(abs(argument["low"]), abs(argument["high"]))
            run.names[name] = box.argument(0, box.ball(SMALLEST).log().lower(), box.ball(reach).log().upper())
        else:
            run.names[name] = box.argument({"+": 1, "-": -1, "±": 0}[choice], low, high)
    return run


def _whole(box: Box, argument: Mapping[str, Any], choice: str, low: Ball, high: Ball) -> Number | None:
    """A whole number: the least one, and what it has beyond that."""
    least = box.constant(argument["low"])
    if choice == "zero":
        return least
    beyond = replace(box.argument(1, low, high), grid=0)
    return box.add(least, beyond)


def _share_of(run: Run, argument: Mapping[str, Any], low: Ball, high: Ball) -> Number:
    """A whole number that is at most another: a share of that."""
    box, whole = run.box, run.names[argument["at_most"]]
    if whole is None:
        raise Refused("a share of zero")
    share = box.argument(1, low, high)
    product = box.multiply(whole, share)
    least = max(float(product.low), math.log(argument["low"]) - 1e-9) if product else 0.0
    if product is None:
        raise Refused("a share of zero")
    return replace(
        product, low=box.ball(least), relative=box.ball(0), error={}, tiny=least / math.log(2) - 1e-3, grid=0
    )


def _turn(run: Run, name: str, choice: str, low: Ball, high: Ball) -> None:
    """Sine and cosine of an angle, by its distance from a quarter turn."""
    box, ulps = run.box, run.box.precision.ulps
    small = low.exp().sin().log().lower(), high.exp().sin().log().upper()
    large = high.exp().cos().log().lower(), low.exp().cos().log().upper()
    sine, cosine = (small, large) if choice[2] == "s" else (large, small)
    signs = {"+": 1, "-": -1, "±": 0}
    first = len(box.atoms)
    run.waves["sin", name] = box.argument(signs[choice[1]], *sine, roundings=2.0 * ulps["sin"])
    second = len(box.atoms)
    run.waves["cos", name] = box.argument(signs[choice[0]], *cosine, roundings=2.0 * ulps["cos"])
    box.waves.append((first, second))
