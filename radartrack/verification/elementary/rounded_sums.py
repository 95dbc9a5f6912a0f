"""What statements do to errors: each rounding is a symbol of its own, so that what is lost and put back cancels."""

from __future__ import annotations

import ast
from dataclasses import dataclass, field
from fractions import Fraction

from radartrack.verification.elementary.ball_arithmetic import Ball, Refused, around, half_ulp, nearest, point
from radartrack.verification.elementary.elementary_text import Text


@dataclass
class Form:
    """What a statement computes in one cell.

    Attributes:
        ideal: its value in exact arithmetic.
        error: what is computed less that: coefficients of symbols in [-1, 1], under None a number.
        computed: the number, where it is one.
    """

    ideal: Ball
    error: dict[int | None, Ball] = field(default_factory=dict)
    computed: Fraction | None = None


@dataclass
class Cell:
    """The statements in one cell."""

    text: Text
    names: dict[str, Form] = field(default_factory=dict)
    symbols: int = 0

    def follow(self, first: str, last: str) -> None:
        """The statements from one name to another."""
        names = [name for name, _ in self.text.statements]
        for name, value in self.text.statements[names.index(first) : names.index(last) + 1]:
            self.names[name] = self._lost_of(value) or self.of(value)

    def of(self, node: ast.expr) -> Form:
        """An expression, every operation rounded."""
        match node:
            case ast.Constant(value=float(value)):
                return Form(point(value), {}, Fraction(value))
            case ast.Name(id=name) if name in self.names:
                return self.names[name]
            case ast.BinOp(left, operation, right):
                return self._rounded(operation, self.of(left), self.of(right))
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return self._times(Form(point(-1.0), {}, Fraction(-1)), self.of(operand))
        raise Refused(f"{self.text.name}: {ast.unparse(node)} cannot be followed")

    def before_rounding(self, node: ast.expr) -> Ball:
        """The largest error of a sum whose last rounding is not yet done."""
        if not (isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add)):
            raise Refused(f"{self.text.name}: a result that is no sum: {ast.unparse(node)}")
        return _size(_sum(self.of(node.left), self.of(node.right), 1))

    def _rounded(self, operation: ast.operator, a: Form, b: Form) -> Form:
        if isinstance(operation, ast.Mult):
            return self._times(a, b)
        if not isinstance(operation, ast.Add | ast.Sub):
            raise Refused(f"{self.text.name}: an operation that cannot be followed")
        sign = 1 if isinstance(operation, ast.Add) else -1
        found = _sum(a, b, sign)
        if a.computed is not None and b.computed is not None:
            return self._known(found.ideal, a.computed + sign * b.computed)
        if a.computed == 0 or b.computed == 0 or (sign < 0 and _are_close(a, b)):
            return found
        return self._with_rounding(found)

    def _times(self, a: Form, b: Form) -> Form:
        ideal = a.ideal * b.ideal
        if a.computed is not None and b.computed is not None:
            return self._known(ideal, a.computed * b.computed)
        error = {key: value * a.ideal for key, value in b.error.items()}
        for key, value in a.error.items():
            error[key] = error.get(key, point(0)) + value * b.ideal
        both = _size(a) * _size(b)
        found = Form(ideal, error)
        if both.upper() > 0:
            self._add_symbol(found, both)
        if any(one.computed is not None and not one.error and _is_power_of_two(one.computed) for one in (a, b)):
            return found
        return self._with_rounding(found)

    def _known(self, ideal: Ball, exactly: Fraction) -> Form:
        computed = nearest(exactly, self.text.bits)
        return Form(ideal, {None: point(computed) - ideal}, computed)

    def _with_rounding(self, found: Form) -> Form:
        self._add_symbol(found, half_ulp(_computed(found), self.text.bits))
        return found

    def _add_symbol(self, form: Form, coefficient: Ball) -> None:
        self.symbols += 1
        form.error[self.symbols] = coefficient

    def _lost_of(self, value: ast.expr) -> Form | None:
        """(a − (s − b′)) + (b − b′) with s = a + b and b′ = s − a is what s lacks of a + b (Knuth 1969, theorem B)."""
        match value:
            case ast.BinOp(
                ast.BinOp(ast.Name(a), ast.Sub(), ast.BinOp(ast.Name(s), ast.Sub(), ast.Name(back))),
                ast.Add(),
                ast.BinOp(ast.Name(b), ast.Sub(), ast.Name(again)),
            ):
                shapes = ast.unparse(self.text.value(s)), ast.unparse(self.text.value(back)), again
                if shapes != (f"{a} + {b}", f"{s} - {a}", back):
                    raise Refused(f"{self.text.name}: {ast.unparse(value)} is not what a sum lost")
                exact, rounded = _sum(self.names[a], self.names[b], 1), self.names[s]
                lost = {k: exact.error.get(k, point(0)) - v for k, v in rounded.error.items()}
                return Form(point(0), {k: v for k, v in lost.items() if not v.is_zero()})
        return None


def _sum(a: Form, b: Form, sign: int) -> Form:
    error = dict(a.error)
    for key, value in b.error.items():
        error[key] = error.get(key, point(0)) + sign * value
    return Form(a.ideal + sign * b.ideal, error)


def _size(form: Form) -> Ball:
    """The largest error."""
    return sum((abs(value) for value in form.error.values()), point(0))


def _computed(form: Form) -> Ball:
    return form.ideal + around(_size(form))


def _are_close(a: Form, b: Form) -> bool:
    """Whether each is at most twice the other, so that their difference is exact (Sterbenz 1974)."""
    first, second = _computed(a), _computed(b)
    return bool(first > 0 and second > 0 and 2 * first >= second and 2 * second >= first)


def _is_power_of_two(value: Fraction) -> bool:
    return (
        value != 0
        and abs(value.numerator) & (abs(value.numerator) - 1) == 0
        and (value.denominator & (value.denominator - 1) == 0)
    )
