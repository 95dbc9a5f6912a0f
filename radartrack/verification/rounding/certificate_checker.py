"""Checks certificates of rounding errors: in every box the claimed bound is derived again, in ball arithmetic.

It shares no code with the search by enclosures; what it knows of numbers is in `checked_numbers`. So what it confirms
is proved, given the assumptions: the standard model of floating point, and the `ulps` of the elementary functions.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any, NamedTuple

from radartrack.verification.rounding.checked_helpers import KNOWN, helped
from radartrack.verification.rounding.checked_numbers import (
    DOUBLE,
    FUNCTIONS,
    SINGLE,
    Ball,
    Box,
    Number,
    Polynomial,
    Refused,
    Signed,
    Undefined,
    times,
)

Entry = tuple[int, ...]
Claim = Mapping[str, Any]

SMALLEST, LARGEST_CORRELATION = 1e-20, 0.99
BITS = 53  # of balls
GOOD = 16.0  # a bound that no second way of telling errors is tried for
PRECISIONS = {"double": DOUBLE, "single": SINGLE}


class Way(NamedTuple):
    """Of telling errors; `Box` says what each is."""

    in_parts: bool
    rounded_whole: bool = False
    signed_whole: bool = False
    factors_whole: bool = False
    by_argument: bool = False


WAYS = (
    Way(in_parts=True),
    Way(in_parts=False),
    Way(in_parts=True, rounded_whole=True),
    Way(in_parts=True, signed_whole=True),
    Way(in_parts=True, factors_whole=True),
    Way(in_parts=True, factors_whole=True, by_argument=True),
)


@dataclass
class Run:
    """The arguments in one box, and what the statements made of them so far; None is zero.

    Attributes:
        box: where the arguments lie.
        names: what has a name.
        waves: sines and cosines of arguments.
        entries: of the result.
        helpers: the functions that the module brings along.
        outcomes: what is taken for the answers of questions that the box leaves open.
    """

    box: Box
    names: dict[str, Number | None] = field(default_factory=dict)
    waves: dict[tuple[str, str], Number | None] = field(default_factory=dict)
    entries: dict[Entry, Number | None] = field(default_factory=dict)
    helpers: Mapping[str, ast.FunctionDef] = field(default_factory=dict)
    outcomes: Mapping[str, bool] = field(default_factory=dict)

    def answer(self, question: str) -> bool:
        """One of the two, where the box leaves it open."""
        if question not in self.outcomes:
            raise Open(question)
        return self.outcomes[question]


class Open(Exception):
    """A question of which a box has either answer: both are followed."""


def confirmed(source: str, claim: Claim) -> float:
    """The bound that a certificate proves, in ulp of the scale.

    Args:
        source: the text of the generated module.
        claim: with `function`, `arguments` (name, low, high, kind, and of whole numbers `whole` and `at_most`),
            `shape`, `scale`, `groups`, `correlated`, `precision`, and `trees`, of every case how its box is split.
            Where the scale is a formula of its own, `stated` is a function that computes it, written like the module's,
            and `paired` whether that of every entry is the geometric mean of its row's and its column's. With `sides`
            the signs of an angle's cosine are cases of their own, as they are with correlations. `ways` may name those
            of `WAYS` that suffice, by number.

    Raises:
        Refused: the boxes do not cover the domain, or a statement cannot be followed in one of them.
    """
    if set(claim["trees"]) != set(cases_of(claim)):
        raise Refused("the cases are not those of the domain")
    worst = 0.0
    for case, tree in claim["trees"].items():
        for box in boxes_of(claim, case, tree):
            worst = max(worst, figure(source, claim, case, box))
    return worst


def figure(source: str, claim: Claim, case: str, box: Mapping[str, tuple[float, float]]) -> float:
    """The largest error of an entry in one box."""
    functions = {node.name: node for node in _read(source).body if isinstance(node, ast.FunctionDef)}
    if claim["function"] not in functions:
        raise Refused(f"there is no function {claim['function']}")
    waiting: list[dict[str, bool]] = [{}]
    worst = 0.0
    with _precision():
        while waiting:
            outcomes = waiting.pop()
            try:
                worst = max(worst, _best(functions, claim, case, box, outcomes))
            except Undefined:
                if tuple(claim["shape"]):
                    raise
            except Open as question:
                waiting += [{**outcomes, str(question): answer} for answer in (False, True)]
    return worst


def _precision() -> AbstractContextManager[Any]:
    """Of balls; what else runs in this process sets another, and a bound depends on it."""
    import flint  # noqa: PLC0415

    found: AbstractContextManager[Any] = flint.ctx.workprec(BITS)
    return found


def _best(
    functions: Mapping[str, ast.FunctionDef],
    claim: Claim,
    case: str,
    ends: Mapping[str, tuple[float, float]],
    outcomes: Mapping[str, bool],
) -> float:
    """The smallest of the bounds that the ways of telling errors give."""
    chosen, found = _chosen(case), math.inf
    reason = Refused("no bound")
    for way in (WAYS[number] for number in claim.get("ways", range(len(WAYS)))):
        run = _start(claim, chosen, ends, way)
        run.helpers, run.outcomes = functions, outcomes
        try:
            found = min(found, _figure(functions[claim["function"]], claim, run))
        except Refused as error:
            reason = error
        if found < GOOD:
            break
    if not math.isfinite(found):
        raise reason
    return found


@lru_cache(maxsize=4)
def _read(source: str) -> ast.Module:
    return ast.parse(source)


def _chosen(case: str) -> dict[str, str]:
    return dict(item.rsplit(":", 1) for item in case.split())


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
    chosen = _chosen(case)
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


def _start(claim: Claim, chosen: Mapping[str, str], ends: Mapping[str, tuple[float, float]], way: Way) -> Run:
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


def _followed(node: ast.expr, run: Run) -> Number | None:
    """What an expression computes."""
    match node:
        case ast.Constant(value=int() | float() as number) if abs(number) < 2**53:
            return _written(run.box, number)
        case ast.Name(id=name) if name in run.names:
            return run.names[name]
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return run.box.by_power_of_two(_followed(operand, run), -1.0)
        case ast.Subscript(slice=place) if _entry(place) in run.entries:
            return run.entries[_entry(place)]
        case ast.Attribute(attr="pi"):
            return _pi(run.box)
        case ast.BinOp():
            return _operation(node, run)
        case ast.Call():
            return _called(node, run)
    raise Refused(f"there is no rule for {ast.unparse(node)[:60]}")


def _written(box: Box, number: float) -> Number | None:
    """A number of the code, which a narrower format may have to round."""
    bits = abs(int(number.as_integer_ratio()[0])).bit_length() if number else 0
    return box.constant(number, 0.0 if bits <= box.precision.bits else 1.0)


def _pi(box: Box) -> Number:
    if "pi" not in box.known:
        log = box.flint.arb.pi().log()
        box.known["pi"] = box.argument(1, log.lower(), log.upper(), 1.0)
    found: Number = box.known["pi"]
    return found


def _called(node: ast.Call, run: Run) -> Number | None:
    name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
    if name in {"sin", "cos"} and isinstance(node.args[0], ast.Name) and (name, node.args[0].id) in run.waves:
        return run.waves[name, node.args[0].id]
    values = [_followed(argument, run) for argument in node.args]
    if name == "less":
        return _compared(run, node, *values)
    if name == "abs" and isinstance(node.args[0], ast.Name):
        _with_sign(run, node.args[0].id)
        values = [run.names[node.args[0].id]]
    if name in KNOWN and name in run.helpers:
        order = node.args[1].value if len(node.args) > 1 and isinstance(node.args[1], ast.Constant) else 0
        if not isinstance(order, int):
            raise Refused(f"{name} is asked for what is no whole number")
        return helped(run.box, run.helpers[name], values[0], order)
    if name in {"sin", "cos"}:
        return run.box.wave(values[0], is_sine=name == "sin")
    if name == "_ratio":
        return None if values[1] is None else run.box.divide(*values)
    if name in FUNCTIONS:
        return FUNCTIONS[name](run.box, *values)
    raise Refused(f"there is no rule for {ast.unparse(node)[:60]}")


def _compared(run: Run, node: ast.Call, a: Number | None, b: Number | None) -> Number | None:
    """1 where a < b, else zero; where the box leaves that open, both are tried, with what they say of a and b."""
    if a is None or b is None or a.sign <= 0 or b.sign <= 0:
        raise Refused("a comparison of what may not be positive")
    is_below = True if a.high < b.low else False if a.low > b.high else run.answer(ast.unparse(node))
    if a.relative is not None and b.relative is not None:
        off = 2 * (run.box.small(a.relative) + run.box.small(b.relative))
        smaller, larger = (a, b) if is_below else (b, a)
        least, most = (smaller.low - off).lower(), (larger.high + off).upper()
        for argument, one in zip(node.args, (a, b), strict=True):
            if isinstance(argument, ast.Name):
                known = {"high": min(one.high, most)} if one is smaller else {"low": max(one.low, least)}
                run.names[argument.id] = replace(one, **known)
    return run.box.constant(1) if is_below else None


def _with_sign(run: Run, name: str) -> None:
    """A difference whose sign the box leaves open, once with either; what is computed has the sign of the exact one."""
    number = run.names.get(name)
    if number is None or number.sign or number.relative is None or len(number.value) < 2:
        return
    run.box.small(number.relative)
    run.names[name] = run.box.as_whole(replace(number, sign=1 if run.answer(f"{name} > 0") else -1))


def _operation(node: ast.BinOp, run: Run) -> Number | None:
    box, left = run.box, _followed(node.left, run)
    if isinstance(node.op, ast.Pow) and isinstance(node.right, ast.Constant) and node.right.value == 2:
        return box.squared(left)
    right = _followed(node.right, run)
    match node.op:
        case ast.Mult():
            for constant, other in ((node.left, right), (node.right, left)):
                factor = _power_of_two(constant)
                if factor:
                    return box.by_power_of_two(other, factor)
            return box.multiply(left, right)
        case ast.Add():
            return box.add(left, right)
        case ast.Sub():
            return None if _is_same(left, right) else box.add(left, box.by_power_of_two(right, -1.0))
        case ast.Div():
            return box.divide(left, right)
    raise Refused(f"there is no rule for {ast.unparse(node)[:60]}")


def _is_same(a: Number | None, b: Number | None) -> bool:
    """Whether two are one, also as computed: a size may be computed of the other sign, where its error is not known."""
    return a is b and (a is None or (a.relative is not None and bool(a.relative < GOOD)))


def _power_of_two(node: ast.expr) -> float:
    sign = 1.0
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        node, sign = node.operand, -1.0
    if isinstance(node, ast.Constant) and isinstance(node.value, float) and math.frexp(node.value)[0] == 0.5:
        return sign * node.value
    return 0.0


def _entry(place: ast.expr) -> Entry:
    parts = place.elts if isinstance(place, ast.Tuple) else [place]
    return tuple(part.value for part in parts if isinstance(part, ast.Constant) and isinstance(part.value, int))


def _figure(function: ast.FunctionDef, claim: Claim, run: Run) -> float:
    indices = _indices(tuple(claim["shape"]))
    entries = _entries(function, run, indices)
    others = [
        _entries(function, _moved(run, claim, end), indices) for end in ("low", "high") if claim["scale"] == "ends"
    ]
    positions = [n for n, number in enumerate(entries) if number is not None and not number.is_exact]
    if claim["scale"] == "stated":
        (stated,) = (node for node in _read(claim["stated"]).body if isinstance(node, ast.FunctionDef))
        scales = _entries(stated, _anew(run, claim), indices)
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


def _entries(function: ast.FunctionDef, run: Run, indices: Sequence[Entry]) -> list[Number | None]:
    """What the statements make of the arguments."""
    for statement in function.body:
        match statement:
            case ast.Expr(value=ast.Constant(value=str())) | ast.Return(value=ast.Name(id="result")):
                continue
            case ast.Return(value=ast.Subscript(value=ast.Name(id="result"))):
                continue
            case ast.Return(value=ast.Subscript(value=ast.Call(args=[whole]))):
                _collect(whole, (), run)
            case ast.Assign(targets=[ast.Name(id="arguments" | "result")]) | ast.Assign(value=ast.Name(id="arguments")):
                continue
            case ast.Assign(targets=[ast.Subscript(slice=place)], value=value):
                run.entries[_entry(place)] = _followed(value, run)
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                run.names[name] = _followed(value, run)
            case _:
                raise Refused(f"there is no rule for {ast.unparse(statement)[:60]}")
    if set(run.entries) != set(indices):
        raise Refused("the entries are not those of its shape, one statement each")
    return [run.entries[index] for index in indices]


def _collect(node: ast.expr, index: Entry, run: Run) -> None:
    """The entries of an array that is written as a list."""
    if isinstance(node, ast.List):
        for position, part in enumerate(node.elts):
            _collect(part, (*index, position), run)
    else:
        run.entries[index] = _followed(node, run)


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
            bounds += [box.paired(number.error, i, j) for i, j in zip(*forms, strict=True) if i and j]
    elif claim["scale"] == "terms":
        bounds.append(box.share(number.error, number.terms))
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
    bounds = [box.paired(number.error, first.exactly, second.exactly)]
    if first is second:
        bounds.append(box.share(number.error, first.exactly))
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
    bounds = [box.share(number.error, peer.exactly) for peer in there]
    sizes = [(2 * peer.low).exp() for peer in there if peer.low.is_finite()]
    if sizes:
        bounds.append((box.bounds(number.error)[1] - sum(sizes, box.ball(0)).log() / 2).exp().upper())
    if len(there) == 1 and bounds[0] is not None:
        return bounds
    squares: Polynomial = {}
    for peer in there:
        for key, size in times(peer.exactly, peer.exactly).items():
            squares[key] = squares[key] + size if key in squares else size
    if len(squares) <= 40:
        bounds.append(box.paired(number.error, squares, {(): box.one}))
    whole = _squared_length(box, there)
    if whole is not None and len(whole) <= 40:
        bounds.append(box.paired(number.error, whole, {(): box.one}))
    return bounds


def _squared_length(box: Box, peers: Sequence[Number]) -> Polynomial | None:
    total: Signed = {}
    for peer in peers:
        square = box.product(peer.value, peer.value)
        if square is None:
            return None
        total = box.total(total, square)
    found = box.of_one_sign(total)
    return found[1] if found and found[0] > 0 else None
