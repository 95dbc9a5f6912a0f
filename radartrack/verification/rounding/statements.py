"""A generated function as written: its statements are read, not run, over boxes of its domain."""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np

from radartrack.verification.rounding import error_rules as rules
from radartrack.verification.rounding.domain_boxes import Given
from radartrack.verification.rounding.enclosures import SLACK, Enclosure
from radartrack.verification.rounding.error_rules import NotAnalysed, Value

Index = tuple[int, ...]


@dataclass
class Run:
    """What the statements compute; None is exactly zero."""

    given: Given
    names: dict[str, Value | None] = field(default_factory=dict)
    entries: dict[Index, Value | None] = field(default_factory=dict)


def function_node(module: str, name: str) -> ast.FunctionDef:
    """The definition of a function in the text of a module."""
    found = _functions(module).get(name)
    if found is None:
        raise LookupError(f"there is no function {name}")
    return found


@lru_cache(maxsize=4)
def _functions(module: str) -> dict[str, ast.FunctionDef]:
    return {node.name: node for node in ast.parse(module).body if isinstance(node, ast.FunctionDef)}


def evaluated(function: ast.FunctionDef, given: Given) -> dict[Index, Value | None]:
    """Every entry of a function's result.

    Raises:
        NotAnalysed: a statement holds what there is no rule for.
    """
    run = Run(given, dict(given.values))
    for statement in function.body:
        _statement(statement, run)
    return run.entries


def _statement(statement: ast.stmt, run: Run) -> None:
    match statement:
        case ast.Expr(value=ast.Constant(value=str())) | ast.Return():
            return
        case ast.Assign(targets=[ast.Name(id="arguments")]) | ast.Assign(value=ast.Name(id="arguments")):
            return
        case ast.Assign(targets=[ast.Name(id="result")]):
            return
        case ast.Assign(targets=[ast.Name(id=name)], value=value):
            run.names[name] = _value(value, run)
        case ast.Assign(targets=[ast.Subscript(value=ast.Name(id="result"), slice=place)], value=value):
            run.entries[_index(place)] = _value(value, run)
        case _:
            raise NotAnalysed(f"the statement {ast.unparse(statement)[:60]}")


def _index(place: ast.expr) -> Index:
    parts = place.elts if isinstance(place, ast.Tuple) else [place]
    return tuple(part.value for part in parts if isinstance(part, ast.Constant) and isinstance(part.value, int))


def _value(node: ast.expr, run: Run) -> Value | None:
    match node:
        case ast.Name(id=name):
            if name not in run.names:
                raise NotAnalysed(f"the angle {name} outside of sine and cosine")
            return run.names[name]
        case ast.Constant(value=int() | float() as number):
            return _number(float(number), run.given.like)
        case ast.Attribute(attr="pi"):
            return rules.inexact(_number(math.pi, run.given.like))
        case ast.Subscript(value=ast.Name(id="result"), slice=place):
            return run.entries[_index(place)]
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return _negated(_value(operand, run))
        case ast.BinOp(left=left, op=operator, right=right):
            return _operation(left, operator, right, run)
        case ast.Call(func=ast.Attribute(attr=name) | ast.Name(id=name), args=operands):
            return _called(name, operands, run)
    raise NotAnalysed(f"the expression {ast.unparse(node)[:60]}")


def _called(name: str, operands: Sequence[ast.expr], run: Run) -> Value | None:
    waves = {"cos": run.given.cosines, "sin": run.given.sines}.get(name, {})
    if isinstance(operands[0], ast.Name) and operands[0].id in waves:
        return waves[operands[0].id]
    if name not in _CALLS:
        raise NotAnalysed(f"the function {name}")
    return _CALLS[name](*(_value(operand, run) for operand in operands))


def _number(number: float, like: Enclosure) -> Value | None:
    if number == 0:
        return None
    middle = np.full_like(like.middle, math.log(abs(number)))
    slack = np.zeros_like(middle) if abs(number) == 1 else np.full_like(middle, SLACK)
    size = Enclosure(middle, like.slopes, slack, slack, middle - slack, middle + slack)
    return rules.exact(size, np.full(len(middle), 1 if number > 0 else -1, dtype=np.int8), number=True)


def _negated(value: Value | None) -> Value | None:
    return value and rules.scaled(value, -1.0)


def _operation(left: ast.expr, operator: ast.operator, right: ast.expr, run: Run) -> Value | None:
    if isinstance(operator, ast.Pow):
        if not (isinstance(right, ast.Constant) and right.value == 2):
            raise NotAnalysed(f"the power {ast.unparse(right)}")
        base = _value(left, run)
        return base and rules.square(base)
    first, second = _value(left, run), _value(right, run)
    if isinstance(operator, ast.Add | ast.Sub):
        second = _negated(second) if isinstance(operator, ast.Sub) else second
        if first is None or second is None:
            return first or second
        return rules.sum_of(first, second)
    if isinstance(operator, ast.Mult):
        return _product((left, first), (right, second))
    if isinstance(operator, ast.Div):
        if second is None:
            raise NotAnalysed("a division by zero")
        return first and rules.quotient(first, second)
    raise NotAnalysed(f"the operator {type(operator).__name__}")


def _product(left: tuple[ast.expr, Value | None], right: tuple[ast.expr, Value | None]) -> Value | None:
    if left[1] is None or right[1] is None:
        return None
    for (one, _), (_, other) in ((left, right), (right, left)):
        if other is not None and _power_of_two(one):
            return rules.scaled(other, float(ast.literal_eval(one)))
    return rules.product(left[1], right[1])


def _power_of_two(node: ast.expr) -> bool:
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        node = node.operand
    return isinstance(node, ast.Constant) and isinstance(node.value, float) and math.frexp(node.value)[0] == 0.5


def _ratio(above: Value | None, below: Value | None) -> Value | None:
    return above and below and rules.quotient(above, below)


def _hypot(first: Value | None, second: Value | None) -> Value | None:
    if first is None or second is None:
        return (first or second) and rules.magnitude(first or second)  # type: ignore[arg-type]
    return rules.hypotenuse(first, second)


def _root(value: Value | None) -> Value | None:
    return value and rules.root(value)


def _magnitude(value: Value | None) -> Value | None:
    return value and rules.magnitude(value)


def _exponential_less_one(value: Value | None) -> Value | None:
    return value and rules.exponential_less_one(value)


def _exponential(value: Value | None) -> Value | None:
    if value is None:
        raise NotAnalysed("the exponential of zero")
    return rules.exponential(value)


def _direction(y: Value | None, x: Value | None) -> Value | None:
    if y is None or x is None:
        known = y or x
        return known and rules.direction(known, known)
    return rules.direction(y, x)


_CALLS: Mapping[str, Callable[..., Value | None]] = {
    "_ratio": _ratio,
    "abs": _magnitude,
    "arctan2": _direction,
    "exp": _exponential,
    "expm1": _exponential_less_one,
    "hypot": _hypot,
    "sqrt": _root,
}
