"""What the statements of a function make of its arguments in one box."""

from __future__ import annotations

import ast
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache

from radartrack.verification.rounding.checker.arithmetic import Box
from radartrack.verification.rounding.checker.function_rules import FUNCTIONS, wave
from radartrack.verification.rounding.checker.known_numbers import Number, Refused
from radartrack.verification.rounding.checker.written_helpers import KNOWN, helped

Entry = tuple[int, ...]
KNOWN_WELL = 16.0  # units of rounding: a computed value has the sign of the exact one


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


@lru_cache(maxsize=4)
def parsed(source: str) -> ast.Module:
    """A module's statements."""
    return ast.parse(source)


def entries_of(function: ast.FunctionDef, run: Run, indices: Sequence[Entry]) -> list[Number | None]:
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
        return wave(run.box, values[0], is_sine=name == "sin")
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
    return a is b and (a is None or (a.relative is not None and bool(a.relative < KNOWN_WELL)))


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
