"""The generated elementary functions as text: statements, numbers, and what they say in exact arithmetic."""

from __future__ import annotations

import ast
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from radartrack.verification.elementary.ball_arithmetic import Refused, flint

Powers = dict[tuple[str, ...], Fraction]  # by the factors of a product, in order
EXACTLY = {  # what the statements behind the reduction say, before anything is rounded
    "sin": "y + y * y * y * sine_series + y_low - 0.5 * y * y * y_low",
    "cos": "1.0 - 0.5 * y * y + y * y * y * y * cosine_series - y * y_low",
    "exp": "1.0 + rest + 0.5 * rest * rest + lost + rest * lost + rest * rest * rest * series",
}
EXACTLY["expm1"] = f"scale * ({EXACTLY['exp']}) - 1.0"
LEAVES = frozenset("y y_low sine_series cosine_series rest lost series scale".split())  # noqa: SIM905 - names
PARTS_OF_BOTH = {"sin": ("sine_of_y", "sine_series"), "cos": ("cosine_of_y", "cosine_series")}


@dataclass(frozen=True)
class Text:
    """One function of the module, and its precision.

    Attributes:
        name: in double precision.
        bits: of the significand.
        statements: names and expressions in order.
        results: what is returned.
        largest_angle: beyond which an angle is refused.
    """

    name: str
    bits: int
    statements: tuple[tuple[str, ast.expr], ...]
    results: tuple[ast.expr, ...]
    largest_angle: float

    def value(self, name: str) -> ast.expr:
        """What a name stands for."""
        found = [value for target, value in self.statements if target == name]
        if len(found) != 1:
            raise Refused(f"{self.name}: {name} is assigned {len(found)} times")
        return found[0]

    @property
    def unit(self) -> Fraction:
        """Half the distance between one and the next number."""
        return Fraction(2) ** -self.bits


def _expanded(node: ast.expr, text: Text | None) -> Powers:
    """An expression multiplied out, its names replaced by what they stand for, down to the leaves."""
    match node:
        case ast.Constant(value=float(value)):
            return {(): Fraction(value)}
        case ast.Name(id=name):
            return {(name,): Fraction(1)} if text is None or name in LEAVES else _expanded(text.value(name), text)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return {key: -value for key, value in _expanded(operand, text).items()}
        case ast.BinOp(left, operation, right) if isinstance(operation, ast.Add | ast.Sub | ast.Mult):
            first, second = _expanded(left, text), _expanded(right, text)
            if isinstance(operation, ast.Mult):
                terms = [(tuple(sorted(a + b)), u * v) for a, u in first.items() for b, v in second.items()]
            else:
                sign = 1 if isinstance(operation, ast.Add) else -1
                terms = [*first.items(), *((key, sign * value) for key, value in second.items())]
            found: Powers = {}
            for key, part in terms:
                found[key] = found.get(key, Fraction(0)) + part
            return {key: part for key, part in found.items() if part}
    raise Refused(f"{ast.unparse(node)} is no sum of products")


def require_exactly(text: Text, node: ast.expr, name: str) -> None:
    """In exact arithmetic an expression is what the bound of its error speaks of."""
    wanted = ast.parse(EXACTLY[name], mode="eval").body
    if _expanded(node, text) != _expanded(wanted, None):
        raise Refused(f"{text.name}: without rounding, {ast.unparse(node)} is not what it should be")


def polynomial_of(node: ast.expr, variable: str) -> Any:
    """An expression as a polynomial with exact coefficients."""
    match node:
        case ast.Constant(value=float(value)):
            number = Fraction(value)
            return flint().fmpq_poly([flint().fmpq(number.numerator, number.denominator)])
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -polynomial_of(operand, variable)
        case ast.Name(id=name) if name == variable:
            return flint().fmpq_poly([0, 1])
        case ast.BinOp(left, ast.Add(), right):
            return polynomial_of(left, variable) + polynomial_of(right, variable)
        case ast.BinOp(left, ast.Mult(), right):
            return polynomial_of(left, variable) * polynomial_of(right, variable)
    raise Refused(f"{ast.unparse(node)} is no polynomial")


def number_of(node: ast.expr) -> Fraction:
    """A number as it is written."""
    match node:
        case ast.Constant(value=float(value)):
            return Fraction(value)
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=float(value))):
            return -Fraction(value)
    raise Refused(f"{ast.unparse(node)} is no number")


def grid_of(value: Fraction) -> Fraction:
    """The largest power of two of which it is a multiple."""
    lowest = value.numerator & -value.numerator
    return Fraction(lowest, value.denominator)


def require_shape(text: Text, shape: list[str]) -> None:
    """The first statements are these, with any numbers."""
    for (name, value), expected in zip(text.statements, shape, strict=False):
        if f"{name} = {_without_numbers(value)}" != ast.unparse(ast.parse(expected)):
            raise Refused(f"{text.name}: {name} = {ast.unparse(value)}, where there should be {expected}")
    if len(text.statements) < len(shape):
        raise Refused(f"{text.name} ends before its argument is reduced")


class _Numbers(ast.NodeTransformer):
    """Puts C for every number and L for the largest angle."""

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.AST:
        """A negative number is a number."""
        return ast.Name("C") if isinstance(node.operand, ast.Constant) else self.generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> ast.AST:  # noqa: ARG002 - as ast calls it
        """Any number."""
        return ast.Name("C")

    def visit_Name(self, node: ast.Name) -> ast.AST:
        """The limit of angles by its name."""
        return ast.Name("L") if node.id.startswith("LARGEST_ANGLE") else node


def _without_numbers(value: ast.expr) -> str:
    return ast.unparse(_Numbers().visit(ast.parse(ast.unparse(value), mode="eval")))
