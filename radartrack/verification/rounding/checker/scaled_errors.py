"""Errors of entries, in units of rounding of what they are measured against."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from radartrack.verification.rounding.checker.arithmetic import Box
from radartrack.verification.rounding.checker.domain_cases import Claim
from radartrack.verification.rounding.checker.followed_statements import Entry, Run, entries_of, parsed
from radartrack.verification.rounding.checker.known_numbers import Number, Refused
from radartrack.verification.rounding.checker.sums.ball_ends import Ball
from radartrack.verification.rounding.checker.sums.products_of_powers import Polynomial, Signed, plus, times, total
from radartrack.verification.rounding.checker.sums.shares import paired, share


def largest_error(function: ast.FunctionDef, claim: Claim, run: Run) -> float:
    """Of the entries in one box."""
    indices = _indices(tuple(claim["shape"]))
    entries = entries_of(function, run, indices)
    others = [
        entries_of(function, _moved(run, claim, end), indices) for end in ("low", "high") if claim["scale"] == "ends"
    ]
    positions = [n for n, number in enumerate(entries) if number is not None and not number.is_exact]
    if claim["scale"] == "stated":
        (stated,) = (node for node in parsed(claim["stated"]).body if isinstance(node, ast.FunctionDef))
        scales = entries_of(stated, _anew(run, claim), indices)
        wrong = ((n, number) for n, number in enumerate(entries) if number is not None and not number.is_exact)
        return max((_error_by_stated(run.box, claim, number, scales, n) for n, number in wrong), default=0.0)
    return max((_error(run.box, claim, entries, others, n) for n in positions), default=0.0)


def _anew(run: Run, claim: Claim, **others: Number | None) -> Run:
    """The arguments alone, some of them others."""
    given = {argument["name"]: run.names[argument["name"]] for argument in claim["arguments"]}
    return Run(run.box, {**given, **others}, run.waves)


def _moved(run: Run, claim: Claim, end: str) -> Run:
    """The same with the argument that is bounded by another at an end of where it goes."""
    argument = next(a for a in claim["arguments"] if a.get("at_most"))
    at = run.box.constant(argument["low"]) if end == "low" else run.names[argument["at_most"]]
    return _anew(run, claim, **{argument["name"]: at})


def _indices(shape: Entry) -> list[Entry]:
    found: list[Entry] = [()]
    for length in shape:
        found = [(*head, i) for head in found for i in range(length)]
    return found


def _error(
    box: Box, claim: Claim, numbers: Sequence[Number | None], others: Sequence[Sequence[Number | None]], position: int
) -> float:
    """Of one entry against its scale."""
    number = numbers[position]
    if number is None:
        return 0.0
    bounds: list[Ball | None] = [number.relative]
    if claim["scale"] == "covariance":
        row, column = divmod(position, claim["shape"][-1])
        first, second = (numbers[i * claim["shape"][-1] + i] for i in (row, column))
        if first and second:
            forms = [[one.exactly, box.plain(one.value)] for one in (first, second)]
            bounds += [paired(box, number.error, i, j) for i, j in zip(*forms, strict=True) if i and j]
    elif claim["scale"] == "terms":
        bounds.append(share(box, number.error, number.terms))
    elif claim["scale"] == "ends":
        bounds += _by_norm(box, number, [entries[position] for entries in others])
    else:
        bounds += _by_norm(box, number, [numbers[i] for i in claim["groups"][position]])
    return _smallest(bounds, position)


def _error_by_stated(box: Box, claim: Claim, number: Number, scales: Sequence[Number | None], position: int) -> float:
    """Of one entry against a scale that is a formula of its own, or against two by their geometric mean."""
    across = claim["shape"][-1] if claim["paired"] else 1
    row, column = divmod(position, across)
    first, second = (
        (scales[row * (across + 1)], scales[column * (across + 1)]) if claim["paired"] else [scales[position]] * 2
    )
    if first is None or second is None:
        raise Refused(f"the scale of entry {position} is zero")
    bounds = [paired(box, number.error, first.exactly, second.exactly)]
    if first is second:
        bounds.append(share(box, number.error, first.exactly))
    bounds.append((box.bounds(number.error)[1] - (first.low + second.low) / 2).exp().upper())
    return _smallest(bounds, position)


def _smallest(bounds: Sequence[Ball | None], position: int) -> float:
    finite = [float(bound.upper()) for bound in bounds if bound is not None and bound.is_finite()]
    if not finite:
        raise Refused(f"no bound of entry {position}")
    return min(finite) * (1 + 2.0**-40)


def _by_norm(box: Box, number: Number, peers: Sequence[Number | None]) -> list[Ball | None]:
    """An error by the length of a vector: by one entry, by the least length, or by the square of the length."""
    there = [peer for peer in peers if peer is not None]
    bounds = [share(box, number.error, peer.exactly) for peer in there]
    sizes = [(2 * peer.low).exp() for peer in there if peer.low.is_finite()]
    if sizes:
        bounds.append((box.bounds(number.error)[1] - sum(sizes, box.ball(0)).log() / 2).exp().upper())
    if len(there) == 1 and bounds[0] is not None:
        return bounds
    squares = plus(*(times(peer.exactly, peer.exactly) for peer in there))
    if len(squares) <= 40:
        bounds.append(paired(box, number.error, squares, {(): box.one}))
    whole = _squared_length(box, there)
    if whole is not None and len(whole) <= 40:
        bounds.append(paired(box, number.error, whole, {(): box.one}))
    return bounds


def _squared_length(box: Box, peers: Sequence[Number]) -> Polynomial | None:
    sum_: Signed = {}
    for peer in peers:
        square = box.product(peer.value, peer.value)
        if square is None:
            return None
        sum_ = total(sum_, square)
    found = box.signs.of_one_sign(sum_)
    return found[1] if found and found[0] > 0 else None
