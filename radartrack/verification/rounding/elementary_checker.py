"""Checks certificates of the elementary functions: in every cell the claimed bound is derived again, in ball arithmetic.

What is read is the text of the generated module, which is never run. Three things are shown of each function: the
argument is reduced with an error that is told; the polynomial is as close to the function as is told (its difference from
Taylor's series, whose rest is bounded, in exact coefficients); and the roundings of the written operations add up to
what is told. Each rounding is a symbol of its own, so that what one statement loses and another puts back cancels. All
numbers are balls of Arb (python-flint), which round outward. Assumed is IEEE 754 arithmetic, to nearest, and nothing else.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache
from typing import Any

Ball = Any
PRECISION = 160  # bits of the balls
TERMS = 26  # of Taylor's series
TINY = 2.0**-30  # below, a function is its argument but for less than a hundredth of an ulp
OF_TINY = 0.51
SATURATED = 64
SHAPES = {
    "angle": [
        "x = chosen(abs(angle) <= L, angle, NAN)",
        "quarters = (x * C + C) - C",
        "rest = x - quarters * C",
    ],
    "exponent": [
        "not_huge = chosen(x > C, C, x)",
        "given = chosen(not_huge < C, C, not_huge)",
        "doublings = (given * C + C) - C",
        "high = given - doublings * C",
        "low = doublings * C",
        "rest = high - low",
        "lost = (high - rest) - low",
    ],
}
FUNCTIONS = ("sin", "cos", "exp", "expm1")
EXACTLY = {  # what the statements behind the reduction say, before anything is rounded
    "sin": "y + y * y * y * sine_series + y_low - 0.5 * y * y * y_low",
    "cos": "1.0 - 0.5 * y * y + y * y * y * y * cosine_series - y * y_low",
    "exp": "1.0 + rest + 0.5 * rest * rest + lost + rest * lost + rest * rest * rest * series",
}
EXACTLY["expm1"] = f"scale * ({EXACTLY['exp']}) - 1.0"
LEAVES = frozenset("y y_low sine_series cosine_series rest lost series scale".split())  # noqa: SIM905 - names
PARTS_OF_BOTH = {"sin": ("sine_of_y", "sine_series"), "cos": ("cosine_of_y", "cosine_series")}


class Refused(ValueError):
    """The certificate does not show what it claims, or a statement is none that can be followed."""


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


def confirmed(source: str, name: str, bits: int, trees: Mapping[str, str]) -> float:
    """The bound that a certificate proves, in units of the last place of the exact value.

    Args:
        source: the text of the generated module.
        name: of the function in double precision.
        bits: 53, or 24 for the function in single precision.
        trees: of every case how its interval is halved: a dot is a cell, a bar halves.

    Raises:
        Refused: the cells do not cover the domain, or a statement is none that can be followed.
    """
    text = read(source, name, bits)
    wanted = cases(text)
    if set(trees) != set(wanted):
        raise Refused(f"{name}: the cases are not those of the domain")
    return max(
        bound(text, case, low, high) for case, ends in wanted.items() for low, high in cells(ends, trees[case])
    )


def cells(ends: tuple[float, float], tree: str) -> Iterator[tuple[float, float]]:
    """The cells of a tree in preorder; halves meet in one number, so nothing is left out between them."""
    waiting = [ends]
    for letter in tree:
        if not waiting or letter not in ".|":
            raise Refused("a tree goes on after its end, or holds what is neither a dot nor a bar")
        low, high = waiting.pop()
        if letter == ".":
            yield low, high
        else:
            middle = (low + high) / 2
            waiting += [(middle, high), (low, middle)]
    if waiting:
        raise Refused("a tree ends before its cells cover the interval")


def bound(text: Text, case: str, low: float, high: float) -> float:
    """In one cell, in units of the last place."""
    flint().ctx.prec = PRECISION
    if text.name in PARTS_OF_BOTH:
        found = _of_angle(text, low, high)
    elif text.name == "exp":
        found = _of_exponential(text, low, high)
    else:
        found = _of_exponential_less_one(text, case, low, high)
    return float(found.upper()) * (1 + 1e-12)


@lru_cache(maxsize=16)
def read(source: str, name: str, bits: int) -> Text:
    """A function's statements, each of whose numbers has as many bits as the precision.

    Raises:
        Refused: it holds something else.
    """
    end = {53: "", 24: "_single"}[bits]
    tree = ast.parse(source)
    wanted = f"sin_and_cos{end}" if name in PARTS_OF_BOTH else f"{name}{end}"
    function = next((n for n in tree.body if isinstance(n, ast.FunctionDef) and n.name == wanted), None)
    if function is None:
        raise Refused(f"there is no function {wanted}")
    *lines, last = function.body[1:]
    if not isinstance(last, ast.Return) or not all(isinstance(line, ast.Assign) for line in lines):
        raise Refused(f"{wanted} holds what is no assignment")
    for node in ast.walk(function):
        if isinstance(node, ast.Constant) and isinstance(node.value, float):
            number = Fraction(node.value)
            if nearest(number, bits) != number:
                raise Refused(f"{wanted}: {node.value} has more than {bits} bits")
    statements = tuple((ast.unparse(line.targets[0]), line.value) for line in lines if isinstance(line, ast.Assign))
    results = tuple(last.value.elts) if isinstance(last.value, ast.Tuple) else (last.value,)
    if not all(isinstance(result, ast.expr) for result in results):
        raise Refused(f"{wanted} returns nothing")
    angle = _largest_angle(tree, bits)
    text = Text(name, bits, statements, results, angle)  # type: ignore[arg-type] # asserted above
    _require_alone(tree, name, end)
    (_require_angle if name in PARTS_OF_BOTH else _require_exponent)(text)
    return text


def cases(text: Text) -> dict[str, tuple[float, float]]:
    """The reduced arguments: intervals by what else they are told apart by."""
    reach = _reach(text)
    if text.name in PARTS_OF_BOTH:  # odd and even functions of operations that are so too
        return {"": (0.0, reach)}
    if text.name == "exp":
        return {"": (-reach, reach)}
    whole = {str(k): (-reach, reach) for k in range(-text.bits, SATURATED + 1) if k}
    return {"few": (-reach, reach), "0-": (-reach, 0.0), "0+": (0.0, reach), **whole, "many": (-reach, reach)}


# What is known of numbers


@lru_cache(maxsize=1)
def flint() -> Any:
    """python-flint, which is needed for checking alone."""
    import flint as library  # noqa: PLC0415 - an extra of the tests

    library.ctx.prec = PRECISION
    return library


def nearest(value: Fraction, bits: int) -> Fraction:
    """Rounded to so many bits, ties to even; no limit to exponents."""
    if not value:
        return value
    exponent = abs(value.numerator).bit_length() - value.denominator.bit_length()
    exponent -= abs(value) < Fraction(2) ** exponent
    step = Fraction(2) ** (exponent - bits + 1)
    return round(value / step) * step


def _exact(value: Fraction | float) -> Ball:
    number = Fraction(value)
    return flint().arb(flint().fmpq(number.numerator, number.denominator))


def _between(low: float, high: float) -> Ball:
    middle, radius = (Fraction(low) + Fraction(high)) / 2, (Fraction(high) - Fraction(low)) / 2
    return _exact(middle) + _around(_exact(radius))


def _around(radius: Ball) -> Ball:
    """All numbers of at most this size."""
    return flint().arb(0, radius.abs_upper() if hasattr(radius, "abs_upper") else abs(radius).upper())


def _half_ulp(size: Ball, bits: int) -> Ball:
    """Of the largest number of this size."""
    top = float(abs(size).upper())
    exponent = math.frexp(top * (1 + 2.0**-50))[1] if top else -1000
    return _exact(Fraction(2) ** (exponent - bits - 1))


def _ulp_at_least(size: Ball, bits: int) -> Ball:
    """Of the smallest number of this size."""
    bottom = float(abs(size).lower())
    if not bottom > 0:
        raise Refused("a result that may vanish has no last place")
    return _exact(Fraction(2) ** (math.frexp(bottom * (1 - 2.0**-50))[1] - bits))


# What statements do to errors


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
                return Form(_exact(value), {}, Fraction(value))
            case ast.Name(id=name) if name in self.names:
                return self.names[name]
            case ast.BinOp(left, operation, right):
                return self._rounded(operation, self.of(left), self.of(right))
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return self._times(Form(_exact(-1.0), {}, Fraction(-1)), self.of(operand))
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
            error[key] = error.get(key, _exact(0)) + value * b.ideal
        both = _size(a) * _size(b)
        found = Form(ideal, error)
        if both.upper() > 0:
            self._add_symbol(found, both)
        if any(one.computed is not None and not one.error and _is_power_of_two(one.computed) for one in (a, b)):
            return found
        return self._with_rounding(found)

    def _known(self, ideal: Ball, exactly: Fraction) -> Form:
        computed = nearest(exactly, self.text.bits)
        return Form(ideal, {None: _exact(computed) - ideal}, computed)

    def _with_rounding(self, found: Form) -> Form:
        self._add_symbol(found, _half_ulp(_computed(found), self.text.bits))
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
                lost = {k: exact.error.get(k, _exact(0)) - v for k, v in rounded.error.items()}
                return Form(_exact(0), {k: v for k, v in lost.items() if not v == 0})
        return None


def _sum(a: Form, b: Form, sign: int) -> Form:
    error = dict(a.error)
    for key, value in b.error.items():
        error[key] = error.get(key, _exact(0)) + sign * value
    return Form(a.ideal + sign * b.ideal, error)


def _size(form: Form) -> Ball:
    """The largest error."""
    return sum((abs(value) for value in form.error.values()), _exact(0))


def _computed(form: Form) -> Ball:
    return form.ideal + _around(_size(form))


def _are_close(a: Form, b: Form) -> bool:
    """Whether each is at most twice the other, so that their difference is exact (Sterbenz 1974)."""
    first, second = _computed(a), _computed(b)
    return bool(first > 0 and second > 0 and 2 * first >= second and 2 * second >= first)


def _is_power_of_two(value: Fraction) -> bool:
    return value != 0 and abs(value.numerator) & (abs(value.numerator) - 1) == 0 and (
        value.denominator & (value.denominator - 1) == 0
    )


# Polynomials


Powers = dict[tuple[str, ...], Fraction]  # by the factors of a product, in order


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
            for key, value in terms:
                found[key] = found.get(key, Fraction(0)) + value
            return {key: value for key, value in found.items() if value}
    raise Refused(f"{ast.unparse(node)} is no sum of products")


def _require_exactly(text: Text, node: ast.expr, name: str) -> None:
    """In exact arithmetic an expression is what the bound of its error speaks of."""
    wanted = ast.parse(EXACTLY[name], mode="eval").body
    if _expanded(node, text) != _expanded(wanted, None):
        raise Refused(f"{text.name}: without rounding, {ast.unparse(node)} is not what it should be")


def _polynomial(node: ast.expr, variable: str) -> Any:
    """An expression as a polynomial with exact coefficients."""
    match node:
        case ast.Constant(value=float(value)):
            number = Fraction(value)
            return flint().fmpq_poly([flint().fmpq(number.numerator, number.denominator)])
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_polynomial(operand, variable)
        case ast.Name(id=name) if name == variable:
            return flint().fmpq_poly([0, 1])
        case ast.BinOp(left, ast.Add(), right):
            return _polynomial(left, variable) + _polynomial(right, variable)
        case ast.BinOp(left, ast.Mult(), right):
            return _polynomial(left, variable) * _polynomial(right, variable)
    raise Refused(f"{ast.unparse(node)} is no polynomial")


def _differs(node: ast.expr, variable: str, at: Ball, taylor: list[Fraction], rest: Ball) -> Ball:
    """By how much a polynomial may differ from a series of which these are the first coefficients."""
    series = flint().fmpq_poly([flint().fmpq(c.numerator, c.denominator) for c in taylor])
    difference = _polynomial(node, variable) - series
    middle, radius = at.mid(), at.rad()
    return abs(_at(difference, middle)) + radius * abs(_at(difference.derivative(), at)) + rest


def _at(polynomial: Any, place: Ball) -> Ball:
    value = _exact(0)
    for coefficient in reversed(polynomial.coeffs()):
        value = value * place + flint().arb(coefficient)
    return value


def _factorial(n: int) -> int:
    return math.factorial(n)


# Sine and cosine


def _of_angle(text: Text, low: float, high: float) -> Ball:
    """The reduced angle y in a cell; what y lacks is at most half its last place."""
    lost = _reduction_of_angles(text)
    result, series = PARTS_OF_BOTH[text.name]
    if text.name == "sin" and high <= TINY:
        return _exact(OF_TINY) + lost
    y, half_last = _between(low, high), _half_ulp(_exact(high), text.bits)
    cell = Cell(text, {"y": Form(y), "y_low": Form(_around(half_last))})
    names = [name for name, _ in text.statements]
    cell.follow("square", names[names.index(result) - 1])
    error = cell.before_rounding(text.value(result))
    square = y * y
    rest = abs(y) ** (2 * TERMS) / _factorial(2 * TERMS + 3)  # the first term that is left out
    if text.name == "sin":
        taylor = [Fraction((-1) ** (n + 1), _factorial(2 * n + 3)) for n in range(TERMS)]
        off = abs(y) ** 3 * _differs(text.value(series), "square", square, taylor, rest)
        beside, exact = half_last * y**4 / 24, y.sin()
    else:
        taylor = [Fraction((-1) ** n, _factorial(2 * n + 4)) for n in range(TERMS)]
        off = y**4 * _differs(text.value(series), "square", square, taylor, rest)
        beside, exact = half_last * abs(y) ** 3 / 6, y.cos()
    exact = exact + _around(half_last)
    return _exact(0.5) + (error + off + beside + half_last**2) / _ulp_at_least(exact, text.bits) + lost


@lru_cache(maxsize=8)
def _reduction_of_angles(text: Text) -> Ball:
    """The error that the reduction leaves, in units of the last place of the sine or cosine."""
    flint().ctx.prec = PRECISION
    half_pi, unit = flint().arb.pi() / 2, _exact(text.unit)
    parts = [_number(value) for value in _parts(text)]
    off = abs(half_pi - sum(map(_exact, parts), _exact(0)))
    worst = _exact(0)
    for k in range(1, _most_quarters(text) + 1):
        exact = k * half_pi
        middle = Fraction(float(exact)) if text.bits == 53 else nearest(Fraction(float(exact)), text.bits)
        step = _step(middle, text.bits)
        distance = min(abs(_exact(middle + n * step) - exact).lower() for n in (-1, 0, 1))
        last = k * abs(_exact(parts[-1]))
        if not 4 * last < distance:
            raise Refused("an angle so near a right one that what is kept of it is larger than the rest")
        error = (k * off + 2 * unit * last) / distance + 8 * unit * unit
        worst = error if float(error.upper()) > float(worst.upper()) else worst
    return worst * _exact(1.2) / unit


def _step(value: Fraction, bits: int) -> Fraction:
    exponent = math.frexp(float(value))[1]
    return Fraction(2) ** (exponent - bits)


def _most_quarters(text: Text) -> int:
    return math.ceil(text.largest_angle * 2 / math.pi + 0.5)


def _parts(text: Text) -> list[ast.expr]:
    """Of π/2, as the statements take them."""
    names = [name for name, _ in text.statements]
    found = []
    for _, value in text.statements[: names.index("y")]:
        for node in ast.walk(value):
            match node:
                case ast.BinOp(ast.Name("quarters"), ast.Mult(), factor):
                    found.append(factor)
    return found


def _number(node: ast.expr) -> Fraction:
    match node:
        case ast.Constant(value=float(value)):
            return Fraction(value)
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=float(value))):
            return -Fraction(value)
    raise Refused(f"{ast.unparse(node)} is no number")


def _require_angle(text: Text) -> None:
    """The reduction is the one of which the bound speaks, its products and differences are exact, signs are right."""
    parts = _parts(text)
    shape = list(SHAPES["angle"])
    rest, low = "rest", ""
    for n in range(2, len(parts)):
        now = f"rest_{n}"
        lost = f"({rest} - {now} - part_{n})" if low else f"{rest} - {now} - part_{n}"
        shape += [f"part_{n} = quarters * C", f"{now} = {rest} - part_{n}", f"low_{n} = {low}{lost}"]
        rest, low = now, f"low_{n} + "
    shape += [f"low = {low.removesuffix(' + ')} - quarters * C", f"y = {rest} + low", f"y_low = {rest} - y + low"]
    _require_shape(text, shape)
    _require_whole(text, "quarters", text.largest_angle)
    bits, most = text.bits, _most_quarters(text)
    for n, part in enumerate(map(_number, parts[:-1])):
        grid = _grid(part)
        # A multiple is exact. From the angle, which is a multiple of 2^-bits, it leaves less than one; later ones are
        # either smaller than what they are taken from, or both are multiples of the grid and few of them.
        largest = most * abs(part)
        if not largest <= grid * 2**bits:
            raise Refused("a multiple of a part of π/2 that is rounded")
        if not (grid >= Fraction(1, 2**bits) if n == 0 else 2 * largest <= grid * 2**bits):
            raise Refused("a difference of multiples of parts of π/2 that is not kept")
    _require_quadrants(text)
    _require_exactly(text, text.value(PARTS_OF_BOTH[text.name][0]), text.name)


def _mantissa(text: Text) -> ast.expr:
    """What is multiplied by powers of two to give e^x."""
    result = text.results[-1]
    match result.args[1] if isinstance(result, ast.Call) else result:
        case ast.BinOp(ast.BinOp(mantissa, ast.Mult(), ast.Call()), ast.Mult(), ast.Call()):
            return mantissa
    raise Refused("e^x is no number times two powers of two")


def _require_quadrants(text: Text) -> None:
    """Which of sine and cosine is taken with which sign, for every number of right angles, with 3 and 5 for them.

    Numbers of right angles are whole and exact, and so is their rounded quarter: what is left depends on no more than the
    rest by four, but for a tie, which is one at every fourth and rounds to an even quarter.
    """
    names = [name for name, _ in text.statements]
    last = [*text.statements[names.index("cosine_of_y") + 1 :]]
    expected = {0: (3, 5), 1: (5, -3), 2: (-3, -5), 3: (-5, 3)}
    if len(text.results) != 2:
        raise Refused("there are not two results")
    most = _most_quarters(text)
    for k in (*range(-16, 17), *range(most - 8, most + 1), *range(-most, 9 - most)):
        values = {"quarters": Fraction(k), "sine_of_y": Fraction(3), "cosine_of_y": Fraction(5)}
        for name, value in last:
            values[name] = _evaluated(value, values, text.bits)
        if tuple(_evaluated(result, values, text.bits) for result in text.results) != expected[k % 4]:
            raise Refused(f"sine and cosine of {k} right angles are not what they should be")


def _evaluated(node: ast.expr, values: Mapping[str, Fraction], bits: int) -> Fraction:
    """An expression of numbers as it is computed."""
    match node:
        case ast.Constant(value=float(value)):
            return Fraction(value)
        case ast.Name(id=name) if name in values:
            return values[name]
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_evaluated(operand, values, bits)
        case ast.BinOp(left, operation, right):
            a, b = _evaluated(left, values, bits), _evaluated(right, values, bits)
            match operation:
                case ast.Add():
                    return nearest(a + b, bits)
                case ast.Sub():
                    return nearest(a - b, bits)
                case ast.Mult():
                    return nearest(a * b, bits)
        case ast.Call(func=ast.Name("abs"), args=[inside]):
            return abs(_evaluated(inside, values, bits))
        case ast.Call(func=ast.Name("chosen"), args=[ast.Compare(left, [ast.Eq()], [right]), first, second]):
            equal = _evaluated(left, values, bits) == _evaluated(right, values, bits)
            return _evaluated(first if equal else second, values, bits)
    raise Refused(f"{ast.unparse(node)} cannot be followed")


# Exponentials


def _of_exponential(text: Text, low: float, high: float) -> Ball:
    """2^k e^y for any k: the power of two is exact, and where it is not, half of this bound and half an ulp are less."""
    y, half_last = _between(low, high), _half_ulp(_exact(max(-low, high)), text.bits)
    cell = Cell(text, {"rest": Form(y), "lost": Form(_around(half_last))})
    cell.follow("square", "tail")
    error = cell.before_rounding(_mantissa(text))
    error = error + _exponential_is_off(text, y, half_last) + _reduction_of_exponents(text) * 3 / 2
    found = _exact(0.5) + error / _ulp_at_least(y.exp() + _around(half_last * 2), text.bits)
    if not found < 1:
        raise Refused("the bound of e^x is above one ulp, and subnormal numbers may have more")
    return found


def _of_exponential_less_one(text: Text, case: str, low: float, high: float) -> Ball:
    if case == "many":
        return _of_many_doublings(text, low, high)
    if case == "few":  # the result is -1, which lacks e^x
        return (_exact(high).exp() + _reduction_of_exponents(text) * 2) / 2
    k = int(case.rstrip("+-"))
    if k == 0 and max(-low, high) <= TINY:
        return _exact(OF_TINY)
    y = _between(low, high)
    half_last = _half_ulp(_exact(max(-low, high)), text.bits) if k else _exact(0)
    scale = Fraction(2) ** k
    lost = Form(_around(half_last)) if k else Form(_exact(0), {}, Fraction(0))
    cell = Cell(text, {"rest": Form(y), "lost": lost, "scale": Form(_exact(scale), {}, scale)})
    cell.follow("square", "tail")
    cell.follow("shifted", "lost_again")
    error = cell.before_rounding(text.value("near"))
    error = error + _exact(scale) * _exponential_is_off(text, y, half_last)
    if k:
        error = error + _exact(scale) * _reduction_of_exponents(text) * 3 / 2
    exact = _exact(scale) * (y.exp() + _around(2 * half_last)) - 1 if k else y.expm1()
    return _exact(0.5) + error / _ulp_at_least(exact, text.bits)


def _of_many_doublings(text: Text, low: float, high: float) -> Ball:
    """Above 64 doublings e^x is taken, from which one is less than 2^-63 of it."""
    return _of_exponential(text, low, high) + _exact(Fraction(2) ** (text.bits - SATURATED + 2))


def _exponential_is_off(text: Text, y: Ball, half_last: Ball) -> Ball:
    """The polynomial, and what is left out of the product with what the reduced argument lacks."""
    taylor = [Fraction(1, _factorial(n + 3)) for n in range(TERMS)]
    rest = 2 * abs(y) ** TERMS / _factorial(TERMS + 3)
    cubic = abs(y) ** 3 * _differs(text.value("series"), "rest", y, taylor, rest)
    return cubic + half_last * (abs(y.expm1() - y) + half_last)


@lru_cache(maxsize=8)
def _reduction_of_exponents(text: Text) -> Ball:
    """Of the reduced argument, in its own unit."""
    flint().ctx.prec = PRECISION
    first, second = _ln_two(text)
    most, unit = _most_doublings(text), _exact(text.unit)
    off = abs(flint().arb(2).log() - _exact(first) - _exact(second))
    return most * off + 5 * unit * most * abs(_exact(second))


def _ln_two(text: Text) -> tuple[Fraction, Fraction]:
    match text.value("high"), text.value("low"):
        case ast.BinOp(_, _, ast.BinOp(_, _, first)), ast.BinOp(_, _, second):
            return _number(first), _number(second)
    raise Refused("ln 2 is not taken in two parts")


def _limits(text: Text) -> tuple[float, float]:
    """The largest and the smallest exponent."""
    found = []
    for name in ("not_huge", "given"):
        match text.value(name):
            case ast.Call(args=[ast.Compare(_, _, [limit]), same, _]):
                if _number(limit) != _number(same):
                    raise Refused("an exponent is not held at the limit that it exceeds")
                found.append(float(_number(limit)))
    if len(found) != 2:
        raise Refused("exponents are not limited")
    return found[0], found[1]


def _most_doublings(text: Text) -> int:
    return math.ceil(max(map(abs, _limits(text))) / math.log(2) + 0.5)


def _require_exponent(text: Text) -> None:
    _require_shape(text, SHAPES["exponent"])
    high, low = _limits(text)
    largest = {53: (709.79, -745.14), 24: (88.73, -103.98)}[text.bits]  # beyond, e^x is infinite and zero
    if not (high >= largest[0] and low <= largest[1]):
        raise Refused("exponents are limited to fewer than have a value")
    _require_whole(text, "doublings", max(high, -low))
    first, _ = _ln_two(text)
    grid, most = _grid(first), _most_doublings(text)
    if not (most * first <= grid * 2**text.bits and grid >= Fraction(1, 2 ** (text.bits + 1))):
        raise Refused("a multiple of ln 2 that is rounded")
    whole = _whole(text, "doublings")
    powers = "power_of_two(half) * power_of_two(doublings - half)"
    direct = f"(1.0 + (rest + (half_square + tail))) * {powers}"
    if ast.unparse(text.value("half")) != f"doublings * 0.5 + {whole!r} - {whole!r}":
        raise Refused("doublings are not halved")
    limit = float(SATURATED)
    expected = {
        "exp": [direct],
        "expm1": [f"chosen(doublings > {limit}, {direct}, near)"],
    }[text.name]
    if [ast.unparse(result) for result in text.results] != expected:
        raise Refused(f"{text.name} returns something else")
    _require_exactly(text, _mantissa(text), "exp")
    if text.name == "expm1":
        _require_exactly(text, text.value("near"), "expm1")
        shapes = {
            "few": f"chosen(doublings > {limit}, {limit}, doublings)",
            "scale": f"chosen(doublings < -{float(text.bits)}, 0.0, power_of_two(few))",
            "shifted": "scale - 1.0",
        }
        if any(ast.unparse(text.value(name)) != shape for name, shape in shapes.items()):
            raise Refused("doublings are not limited")


# What both reductions share


def _reach(text: Text) -> float:
    """A number that no reduced argument is above."""
    if text.name in PARTS_OF_BOTH:
        largest, step = text.largest_angle, math.pi / 2
    else:
        largest, step = max(map(abs, _limits(text))), math.log(2)
    return step / 2 + 4 * step * (largest / step + 1) * float(text.unit)


def _whole(text: Text, name: str) -> float:
    match text.value(name):
        case ast.BinOp(ast.BinOp(ast.BinOp(_, ast.Mult(), _), ast.Add(), first), ast.Sub(), second):
            if _number(first) == _number(second) == Fraction(3, 2) * 2 ** (text.bits - 1):
                return float(_number(first))
    raise Refused(f"{name} is not rounded to a whole number")


def _require_whole(text: Text, name: str, largest: float) -> None:
    """It is the quotient by the step, rounded to the nearest whole number but for the rounding of the quotient."""
    _whole(text, name)
    match text.value(name):
        case ast.BinOp(ast.BinOp(ast.BinOp(_, ast.Mult(), factor), _, _), _, _):
            inverse = flint().arb.pi() / 2 if name == "quarters" else flint().arb(2).log()
            if not abs(_exact(_number(factor)) * inverse - 1) < 2 * _exact(text.unit):
                raise Refused(f"{name} is not counted by the inverse")
            if not largest * float(_number(factor)) < 2.0 ** (text.bits - 3):
                raise Refused(f"{name} may be more than whole numbers are exact")


def _require_shape(text: Text, shape: list[str]) -> None:
    for (name, value), expected in zip(text.statements, shape, strict=False):
        if f"{name} = {_without_numbers(value)}" != ast.unparse(ast.parse(expected)):
            raise Refused(f"{text.name}: {name} = {ast.unparse(value)}, where there should be {expected}")
    if len(text.statements) < len(shape):
        raise Refused(f"{text.name} ends before its argument is reduced")


class _Numbers(ast.NodeTransformer):
    """Puts C for every number and L for the largest angle."""

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.AST:  # noqa: N802 - as ast calls it
        """A negative number is a number."""
        return ast.Name("C") if isinstance(node.operand, ast.Constant) else self.generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> ast.AST:  # noqa: ARG002, N802 - as ast calls it
        """Any number."""
        return ast.Name("C")

    def visit_Name(self, node: ast.Name) -> ast.AST:  # noqa: N802 - as ast calls it
        """The limit of angles by its name."""
        return ast.Name("L") if node.id.startswith("LARGEST_ANGLE") else node


def _without_numbers(value: ast.expr) -> str:
    return ast.unparse(_Numbers().visit(ast.parse(ast.unparse(value), mode="eval")))


def _grid(value: Fraction) -> Fraction:
    """The largest power of two of which it is a multiple."""
    lowest = value.numerator & -value.numerator
    return Fraction(lowest, value.denominator)


def _largest_angle(tree: ast.Module, bits: int) -> float:
    for node in tree.body:
        match node:
            case ast.Assign(targets=[ast.Tuple(elts=[ast.Name("LARGEST_ANGLE"), _])], value=ast.Tuple(elts=values)):
                return float(_number(values[bits != 53]))
    raise Refused("there is no largest angle")


def _require_alone(tree: ast.Module, name: str, end: str) -> None:
    """A function of one of the two results returns that."""
    if name not in PARTS_OF_BOTH:
        return
    wanted = f"return sin_and_cos{end}(angle)[{int(name == 'cos')}]"
    function = next((n for n in tree.body if isinstance(n, ast.FunctionDef) and n.name == f"{name}{end}"), None)
    if function is None or [ast.unparse(line) for line in function.body[1:]] != [wanted]:
        raise Refused(f"{name}{end} is not one of sin_and_cos{end}")
