"""Checks certificates of rounding errors: in every box the claimed bound is derived again, in ball arithmetic.

It shares no code with what found the boxes. Sizes are intervals of logarithms, errors are sums of products of powers,
and all numbers are balls of Arb (python-flint), which round outward; so what it confirms is proved, given the
assumptions: the standard model of floating point, and `ULPS` of the elementary functions.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

Ball = Any
Key = tuple[tuple[int, float], ...]  # atoms, by their numbers, and their exponents
Polynomial = dict[Key, Ball]  # coefficients are not negative
Entry = tuple[int, ...]

ULPS = {"sin": 1, "cos": 1, "exp": 1, "expm1": 1, "hypot": 1, "arctan2": 1, "square": 1}
SMALLEST, LARGEST_CORRELATION = 1e-20, 0.99
BITS, EXPONENTS = 53, 1000  # of the significand; beyond ± of these powers of two a number may not be normal
CLOSE = 1.5  # an error's terms are shared among products that serve this nearly as well as the best
NOTHING: Polynomial = {}


class Refused(ValueError):
    """The certificate does not show what it claims."""


def confirmed(source: str, claim: Mapping[str, Any]) -> float:
    """The bound that a certificate proves, in ulp of the scale.

    Args:
        source: the text of the generated module.
        claim: with `function`, `arguments` (name, low, high, kind), `shape`, `scale`, `groups`, `correlated`, and
            `trees`, of every case how its box is split.

    Raises:
        Refused: the boxes do not cover the domain, or a statement cannot be followed in one of them.
    """
    function = next((node for node in _read(source).body if getattr(node, "name", "") == claim["function"]), None)
    if not isinstance(function, ast.FunctionDef):
        raise Refused(f"there is no function {claim['function']}")
    if set(claim["trees"]) != set(cases_of(claim)):
        raise Refused("the cases are not those of the domain")
    worst = 0.0
    for case, tree in claim["trees"].items():
        chosen = dict(item.rsplit(":", 1) for item in case.split())
        for box in _boxes(claim["arguments"], chosen, tree):
            worst = max(worst, _figure(function, claim, chosen, box))
    return worst


@lru_cache(maxsize=4)
def _read(source: str) -> ast.Module:
    return ast.parse(source)


def cases_of(claim: Mapping[str, Any]) -> list[str]:
    """All choices of signs and zeros that the domain of a claim has."""
    found = [""]
    for argument in claim["arguments"]:
        choices = _choices(argument, correlated=claim["correlated"])
        found = [f"{head} {argument['name']}:{choice}".strip() for head in found for choice in choices]
    return found


def _choices(argument: Mapping[str, Any], *, correlated: bool) -> list[str]:
    """Signs and zeros that the domain has; of an angle the signs of cosine and sine, and which of them is small."""
    kind, reach = argument["kind"], max(-argument["low"], argument["high"])
    if kind == "correlation":
        return ["+", "-"] if correlated else ["zero"]
    if kind == "angle":
        cosine = "+" if reach <= math.pi / 2 else "±"
        octants = [cosine + "±s"] + ([cosine + "±c"] if reach > math.pi / 4 else [])
        if correlated:
            sides = {"+": "+", "±": "+-"}
            octants = [c + s + o[2] for o in octants for c in sides[o[0]] for s in sides[o[1]]]
        return (["zero"] if argument["low"] <= 0 <= argument["high"] else []) + octants
    if kind == "signed":
        return ["zero", "±"]
    return ["+"] if argument["low"] > 0 else ["zero", "+"]


def _boxes(
    arguments: Sequence[Mapping[str, Any]], chosen: Mapping[str, str], tree: str
) -> Iterator[dict[str, tuple[float, float]]]:
    """The leaves of a tree in preorder; halves meet in one number, so nothing is left out between them."""
    present = [argument for argument in arguments if chosen[argument["name"]] != "zero"]
    stack = [[_ends(argument) for argument in present]]
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


def _ends(argument: Mapping[str, Any]) -> tuple[float, float]:
    """Of the logarithm of a size, or of an angle's distance from a quarter turn; a little wider than they need be."""
    reach = max(abs(argument["low"]), abs(argument["high"]))
    low, high = (argument["low"] if argument["low"] > 0 else min(SMALLEST, reach)), reach
    if argument["kind"] == "angle":
        low, high = SMALLEST, min(reach, math.pi / 4 * (1 + 1e-9))
    if argument["kind"] == "correlation":
        low, high = SMALLEST, LARGEST_CORRELATION
    return math.log(low) - 1e-12, math.log(high) + 1e-12


@dataclass(frozen=True)
class Number:
    """What is known of an intermediate result in one box.

    Attributes:
        sign: 1, −1, or 0 where it is not known.
        low: of the logarithm of its size; minus infinity where nothing keeps it from zero.
        high: likewise.
        relative: bound of its error by itself, in 2⁻⁵³; None where there is none.
        size: a sum that the size is at most.
        exactly: a sum that the size is, if it is one.
        error: a sum that the error is at most, in 2⁻⁵³.
        terms: the sum of the sizes of its terms.
        tiny: binary logarithm that a computed value is not below, unless it is zero.
    """

    sign: int
    low: Ball
    high: Ball
    relative: Ball | None
    size: Polynomial
    exactly: Polynomial | None
    error: Polynomial
    terms: Polynomial
    tiny: float


@dataclass
class Box:
    """The arguments in one box, and what the statements made of them so far."""

    flint: Any
    atoms: list[tuple[Ball, Ball]] = field(default_factory=list)
    names: dict[str, Number | None] = field(default_factory=dict)
    waves: dict[tuple[str, str], Number | None] = field(default_factory=dict)
    entries: dict[Entry, Number | None] = field(default_factory=dict)

    def ball(self, value: float) -> Ball:
        """A number as it is."""
        return self.flint.arb(value)

    @property
    def unit(self) -> Ball:
        """The unit of errors."""
        return self.ball(2.0**-BITS)

    def atom(self, low: Ball, high: Ball) -> Polynomial:
        """A size that is not taken apart."""
        self.atoms.append((low, high))
        return {((len(self.atoms) - 1, 1.0),): self.ball(1)}

    def bounds(self, sum_: Polynomial) -> tuple[Ball, Ball]:
        """Of the logarithm of a sum."""
        ends = [self._monomial(key, coefficient) for key, coefficient in sum_.items()]
        low, high = (sum((end[i].exp() for end in ends), self.ball(0)) for i in (0, 1))
        return _below(low.log() if low.lower() > 0 else self.ball(-math.inf)), _above(high.log())

    def _monomial(self, key: Key, coefficient: Ball) -> tuple[Ball, Ball]:
        low = coefficient.lower().log() if coefficient.lower() > 0 else self.ball(-math.inf)
        high = coefficient.upper().log() if coefficient.upper() > 0 else self.ball(-math.inf)
        for number, exponent in key:
            ends = self.atoms[number]
            first, last = (ends[0], ends[1]) if exponent > 0 else (ends[1], ends[0])
            low, high = low + first * exponent, high + last * exponent
        return low, high

    def share(self, error: Polynomial, scale: Polynomial) -> Ball | None:
        """A number κ with error ≤ κ · scale; a term of the error counts by that of the scale that it is smallest by."""
        loads: dict[Key, Ball] = {}
        for key, coefficient in error.items():
            best: Key | None = None
            ratio = self.ball(math.inf)
            for other, size in scale.items():
                found = _above(self._monomial(_product(key, other, -1.0), coefficient / size)[1].exp())
                if found < ratio:
                    best, ratio = other, found
            if best is None:
                return None
            loads[best] = loads.get(best, self.ball(0)) + ratio
        return _largest([self.ball(0), *loads.values()])

    def paired(self, error: Polynomial, first: Polynomial, second: Polynomial) -> Ball | None:
        """A number κ with error ≤ κ · √(first · second).

        Σ Mᵢⱼ √(aᵢ bⱼ) is at most ‖M‖ √(Σ aᵢ Σ bⱼ), and ‖M‖² at most the largest sum of a row by that of a column.
        """
        pairs = [(i, j) for i in first for j in second]
        rows, columns = dict.fromkeys(first, self.ball(0)), dict.fromkeys(second, self.ball(0))
        for key, coefficient in error.items():
            ratios = []
            for i, j in pairs:
                power = _product(_product(key, i, -0.5), j, -0.5)
                ratios.append(_above(self._monomial(power, coefficient / (first[i] * second[j]).sqrt())[1].exp()))
            best = min(map(_float, ratios))
            if not math.isfinite(best):
                return None
            shared = [n for n, ratio in enumerate(ratios) if _float(ratio) <= CLOSE * best]
            for n in shared:
                i, j = pairs[n]
                rows[i] += ratios[n] / len(shared)
                columns[j] += ratios[n] / len(shared)
        return _above((_largest(list(rows.values())) * _largest(list(columns.values()))).sqrt())


def _float(ball: Ball) -> float:
    """Close to its upper end; infinite where it is no number."""
    value = float(ball.upper())
    return math.inf if math.isnan(value) else value


def _largest(balls: Sequence[Ball]) -> Ball:
    """One that no other is above."""
    return max(balls, key=_float)


def _above(ball: Ball) -> Ball:
    return ball.upper()


def _below(ball: Ball) -> Ball:
    return ball.lower()


def _product(first: Key, second: Key, power: float = 1.0) -> Key:
    exponents = dict(first)
    for number, exponent in second:
        exponents[number] = exponents.get(number, 0.0) + power * exponent
    return tuple(sorted((number, exponent) for number, exponent in exponents.items() if exponent))


def _plus(*sums: Polynomial) -> Polynomial:
    found: Polynomial = {}
    for one in sums:
        for key, coefficient in one.items():
            found[key] = found[key] + coefficient if key in found else coefficient
    return found


def _times(first: Polynomial, second: Polynomial) -> Polynomial:
    return _plus(*({_product(i, j): a * b} for i, a in first.items() for j, b in second.items()))


def _scaled(one: Polynomial, factor: Ball) -> Polynomial:
    return {key: coefficient * factor for key, coefficient in one.items()}


def _made(
    box: Box, sign: int, size: Polynomial, exactly: Polynomial | None, error: Polynomial | None, relative: Ball | None,
    terms: Polynomial, tiny: float, ends: tuple[Ball, Ball] | None = None,
) -> Number:  # fmt: skip
    """A result with both bounds of its error; one that may be out of range is refused."""
    low, high = ends or box.bounds(size)
    low = low if exactly is not None or ends else box.ball(-math.inf)
    most = box.ball(EXPONENTS * 0.69)
    if tiny < -EXPONENTS or not high < most or not (relative is not None or box.bounds(error or {})[1] < most):
        raise Refused("a result may underflow or overflow")
    if error is None:
        error = _scaled(size, relative)
    elif exactly is not None:
        found = box.share(error, exactly)
        if found is not None and (relative is None or found < relative):
            relative = found
    return Number(sign, low, high, relative, size, exactly, error, terms, tiny)


def _rounded(box: Box, relative: Ball | None, units: float) -> Ball | None:
    return None if relative is None else _above(relative + units + box.unit * relative * units)


def _small(box: Box, relative: Ball) -> Ball:
    """A relative error as a share, of operands of what is known for small ones only."""
    part = box.unit * relative
    if not part < box.ball(1e-10):
        raise Refused("an operand with a relative error above 1e-10")
    return part


def _multiply(box: Box, a: Number | None, b: Number | None, units: float = 1.0) -> Number | None:
    if a is None or b is None:
        return None
    relative, u = None, box.unit
    if a.relative is not None and b.relative is not None:
        relative = _rounded(box, a.relative + b.relative + u * a.relative * b.relative, units)
    size, exactly = _times(a.size, b.size), None
    if a.exactly is not None and b.exactly is not None:
        exactly = _times(a.exactly, b.exactly)
    error = None
    if relative is None or not (a.error == NOTHING and b.error == NOTHING):
        spread = _plus(_times(a.error, b.size), _times(a.size, b.error), _scaled(_times(a.error, b.error), u))
        error = _plus(_scaled(spread, 1 + u * units), _scaled(size, box.ball(units)))
    ends = (_below(a.low + b.low), _above(a.high + b.high))
    return _made(box, a.sign * b.sign, size, exactly, error, relative, _times(a.terms, b.terms), a.tiny + b.tiny, ends)


def _by_power_of_two(box: Box, a: Number | None, factor: float) -> Number | None:
    if a is None:
        return None
    f = box.ball(abs(factor))
    return Number(
        a.sign if factor > 0 else -a.sign, _below(a.low + f.log()), _above(a.high + f.log()), a.relative,
        _scaled(a.size, f), a.exactly and _scaled(a.exactly, f), _scaled(a.error, f), _scaled(a.terms, f),
        a.tiny + math.log2(abs(factor)),
    )  # fmt: skip


def _divide(box: Box, a: Number | None, b: Number | None) -> Number | None:
    if a is None:
        return None
    if b is None or b.relative is None or b.exactly is None:
        raise Refused("a divisor that may be zero")
    u = box.unit
    worse = _above(b.relative / (1 - _small(box, b.relative)))
    inverse = b.exactly if len(b.exactly) == 1 else box.atom(b.low, b.high)
    inverse = {tuple((n, -e) for n, e in key): 1 / c for key, c in inverse.items()}
    size, terms = _times(a.size, inverse), _times(a.terms, inverse)
    exactly = a.exactly and _times(a.exactly, inverse)
    relative = None if a.relative is None else _rounded(box, a.relative + worse + u * a.relative * worse, 1.0)
    error = _plus(_scaled(_times(a.error, inverse), (1 + u) * (1 + u * worse)), _scaled(size, 1 + (1 + u) * worse))
    ends = (_below(a.low - b.high), _above(a.high - b.low))
    tiny = a.tiny - float(b.high.upper()) / math.log(2) - 1e-3
    return _made(box, a.sign * b.sign, size, exactly, error, relative, terms, tiny, ends)


def _add(box: Box, a: Number | None, b: Number | None) -> Number | None:
    if a is None or b is None:
        return a or b
    u, size = box.unit, _plus(a.size, b.size)
    is_of_exact = a.error == NOTHING and b.error == NOTHING
    error = _plus(_scaled(_plus(a.error, b.error), 1 + u), size)
    terms = _plus(a.terms, b.terms)
    if a.sign * b.sign > 0:
        exactly = _plus(a.exactly, b.exactly) if a.exactly is not None and b.exactly is not None else None
        relative = None
        if a.relative is not None and b.relative is not None:
            relative = _rounded(box, max(a.relative, b.relative, key=lambda ball: float(ball.upper())), 1.0)
        ends = (_below((a.low.exp() + b.low.exp()).log()), _above((a.high.exp() + b.high.exp()).log()))
        return _made(box, a.sign, size, exactly, error, relative, terms, max(a.tiny, b.tiny) - 1e-3, ends)
    tiny = min(a.tiny, b.tiny) - BITS
    relative = box.ball(1) if is_of_exact else None
    for major, minor in ((a, b), (b, a)):
        if major.sign and minor.high < major.low:
            opposite = a.sign * b.sign < 0
            low = _below(major.low + (1 - (minor.high - major.low).exp()).log())
            high = major.high if opposite else _above((major.high.exp() + minor.high.exp()).log())
            if opposite and minor.low.is_finite():
                high = _above(major.high + (1 - (minor.low - major.high).exp()).log())
            return _made(box, major.sign, size, box.atom(low, high), error, relative, terms, tiny, (low, high))
    high = _above((a.high.exp() + b.high.exp()).log())
    if a.sign * b.sign < 0:
        high = _above(_largest([_above(x.high.exp() - y.low.exp()) for x, y in ((a, b), (b, a))]).log())
    return _made(box, 0, size, None, error, relative, terms, tiny, (box.ball(-math.inf), high))


def _root(box: Box, a: Number | None) -> Number | None:
    if a is None:
        return None
    if a.sign <= 0 or a.relative is None:
        raise Refused("a root of what may be negative")
    part = _small(box, a.relative)
    relative = _rounded(box, a.relative / (1 + (1 - part).sqrt()), 1.0)
    inside = a.exactly if a.exactly is not None and len(a.exactly) == 1 else box.atom(a.low, a.high)
    size = {tuple((n, e / 2) for n, e in key): c.sqrt() for key, c in inside.items()}
    terms = size
    return _made(box, 1, size, size, None, relative, terms, a.tiny / 2 - 1e-3, (_below(a.low / 2), _above(a.high / 2)))


def _hypotenuse(box: Box, a: Number | None, b: Number | None) -> Number | None:
    if a is None or b is None:
        return _magnitude(box, a or b)
    if a.relative is None or b.relative is None:
        raise Refused("the length of a vector whose entries may vanish")
    relative = _rounded(box, max(a.relative, b.relative, key=lambda ball: float(ball.upper())), 2.0 * ULPS["hypot"])
    low, high = (((2 * x).exp() + (2 * y).exp()).log() / 2 for x, y in ((a.low, b.low), (a.high, b.high)))
    size = box.atom(_below(low), _above(high))
    return _made(box, 1, size, size, None, relative, size, max(a.tiny, b.tiny) - 1e-3, (_below(low), _above(high)))


def _magnitude(box: Box, a: Number | None) -> Number | None:
    del box
    return a and Number(1, a.low, a.high, a.relative, a.size, a.exactly, a.error, a.exactly or {}, a.tiny)


def _direction(box: Box, y: Number | None, x: Number | None) -> Number | None:
    known = [one for one in (y, x) if one is not None]
    if not known:
        return None
    relatives = [one.relative for one in known if one.relative is not None]
    if len(relatives) < len(known):
        raise Refused("the direction of a vector whose entries may vanish")
    both = sum(relatives, box.ball(0)) * (1 + box.ball(1e-9))
    _small(box, both)
    high = _above(box.flint.arb.pi().log())
    low = box.ball(-math.inf)
    size = box.atom(low, high)
    tiny = min(one.tiny for one in known) - max(float(one.high.upper()) for one in known) / math.log(2) - 2
    return _made(box, 0, size, size, None, _rounded(box, both, 2.0 * ULPS["arctan2"]), size, tiny, (low, high))


def _exponential(box: Box, a: Number | None) -> Number | None:
    if a is None or not a.sign:
        raise Refused("an exponential of either sign")
    ends = [a.sign * a.low.exp(), a.sign * a.high.exp()]
    low, high = (_below(ends[0]), _above(ends[1])) if a.sign > 0 else (_below(ends[1]), _above(ends[0]))
    off = box.bounds(a.error)[1].exp() if a.error else box.ball(0)
    off = off if a.relative is None else min(off, a.relative * a.high.exp(), key=lambda ball: float(ball.upper()))
    change = (box.unit * off).expm1() / box.unit
    size = box.atom(low, high)
    tiny = float(low.lower()) / math.log(2) - 1e-3
    return _made(box, 1, size, size, None, _rounded(box, _above(change), 2.0 * ULPS["exp"]), size, tiny, (low, high))


def _exponential_less_one(box: Box, a: Number | None) -> Number | None:
    if a is None:
        return None
    if not a.sign or a.relative is None:
        raise Refused("expm1 of either sign")
    low, high = ((a.sign * end.exp()).expm1() * a.sign for end in (a.low, a.high))
    low, high = _below(low.log()), _above(high.log())
    part = _small(box, a.relative)
    farthest = a.high.exp() * (1 + part)
    condition = farthest / -(-farthest).expm1() if a.sign > 0 else box.ball(1)
    change = ((condition * -(1 - part).log()).expm1()) / box.unit
    size = box.atom(low, high)
    relative = _rounded(box, _above(change), 2.0 * ULPS["expm1"])
    return _made(box, a.sign, size, size, None, relative, size, float(low.lower()) / math.log(2) - 1e-3, (low, high))


_FUNCTIONS: dict[str, Callable[..., Number | None]] = {
    "abs": _magnitude, "arctan2": _direction, "exp": _exponential, "expm1": _exponential_less_one,
    "hypot": _hypotenuse, "sqrt": _root,
}  # fmt: skip


def _argument(box: Box, sign: int, low: Ball, high: Ball, roundings: float = 0.0) -> Number:
    size = box.atom(low, high)
    tiny = float(low.lower()) / math.log(2) - 1e-3
    error = _scaled(size, box.ball(roundings)) if roundings else NOTHING
    return Number(sign, low, high, box.ball(roundings), size, size, error, size, tiny)


def _constant(box: Box, value: Ball, roundings: float = 0.0) -> Number | None:
    if value == 0:
        return None
    size: Polynomial = {(): abs(value)}
    log = abs(value).log()
    error = _scaled(size, box.ball(roundings)) if roundings else NOTHING
    tiny = float(log.lower()) / math.log(2) - 1e-3
    return Number(1 if value > 0 else -1, _below(log), _above(log), box.ball(roundings), size, size, error, size, tiny)


def _start(claim: Mapping[str, Any], chosen: Mapping[str, str], ends: Mapping[str, tuple[float, float]]) -> Box:
    import flint  # noqa: PLC0415

    box, signs = Box(flint), {"+": 1, "-": -1, "±": 0}
    for argument in claim["arguments"]:
        name, choice = argument["name"], chosen[argument["name"]]
        if choice == "zero":
            box.names[name] = None
            box.waves["sin", name], box.waves["cos", name] = None, _constant(box, box.ball(1))
            continue
        low, high = box.ball(ends[name][0]), box.ball(ends[name][1])
        if argument["kind"] != "angle":
            box.names[name] = _argument(box, signs[choice], low, high)
            continue
        small = _below(low.exp().sin().log()), _above(high.exp().sin().log())
        large = _below(high.exp().cos().log()), _above(low.exp().cos().log())
        sine, cosine = (small, large) if choice[2] == "s" else (large, small)
        box.waves["sin", name] = _argument(box, signs[choice[1]], *sine, roundings=2.0 * ULPS["sin"])
        box.waves["cos", name] = _argument(box, signs[choice[0]], *cosine, roundings=2.0 * ULPS["cos"])
    return box


def _followed(node: ast.expr, box: Box) -> Number | None:
    """What an expression computes."""
    match node:
        case ast.Constant(value=int() | float() as number) if abs(number) < 2**BITS:
            return _constant(box, box.ball(number))
        case ast.Name(id=name) if name in box.names:
            return box.names[name]
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return _by_power_of_two(box, _followed(operand, box), -1.0)
        case ast.Subscript(slice=place) if _entry(place) in box.entries:
            return box.entries[_entry(place)]
        case ast.Attribute(attr="pi"):
            return _constant(box, box.flint.arb.pi(), 1.0)
        case ast.BinOp():
            return _operation(node, box)
        case ast.Call():
            return _called(node, box)
    raise Refused(f"there is no rule for {ast.unparse(node)[:60]}")


def _called(node: ast.Call, box: Box) -> Number | None:
    name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
    if name in {"sin", "cos"} and isinstance(node.args[0], ast.Name) and (name, node.args[0].id) in box.waves:
        return box.waves[name, node.args[0].id]
    values = [_followed(argument, box) for argument in node.args]
    if name == "_ratio":
        return None if values[1] is None else _divide(box, *values)
    if name in _FUNCTIONS:
        return _FUNCTIONS[name](box, *values)
    raise Refused(f"there is no rule for {ast.unparse(node)[:60]}")


def _operation(node: ast.BinOp, box: Box) -> Number | None:
    left = _followed(node.left, box)
    if isinstance(node.op, ast.Pow) and isinstance(node.right, ast.Constant) and node.right.value == 2:
        squared = _multiply(box, left, left, 2.0 * ULPS["square"])
        return squared and Number(1, *(getattr(squared, name) for name in _AFTER_SIGN))
    right = _followed(node.right, box)
    if isinstance(node.op, ast.Mult):
        for constant, other in ((node.left, right), (node.right, left)):
            factor = _power_of_two(constant)
            if factor:
                return _by_power_of_two(box, other, factor)
        return _multiply(box, left, right)
    if isinstance(node.op, ast.Add):
        return _add(box, left, right)
    if isinstance(node.op, ast.Sub):
        return _add(box, left, _by_power_of_two(box, right, -1.0))
    if isinstance(node.op, ast.Div):
        return _divide(box, left, right)
    raise Refused(f"there is no rule for {ast.unparse(node)[:60]}")


_AFTER_SIGN = ("low", "high", "relative", "size", "exactly", "error", "terms", "tiny")


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


def _figure(
    function: ast.FunctionDef, claim: Mapping[str, Any], chosen: Mapping[str, str], ends: Mapping[str, Any]
) -> float:
    """The largest error of an entry in one box."""
    box = _start(claim, chosen, ends)
    for statement in function.body:
        if isinstance(statement, ast.Return | ast.Expr):
            continue
        if not (isinstance(statement, ast.Assign) and len(statement.targets) == 1):
            raise Refused(f"there is no rule for {ast.unparse(statement)[:60]}")
        target, value = statement.targets[0], statement.value
        if isinstance(target, ast.Subscript):
            box.entries[_entry(target.slice)] = _followed(value, box)
        elif isinstance(target, ast.Name) and target.id not in {"arguments", "result"}:
            box.names[target.id] = _followed(value, box)
    shape = tuple(claim["shape"])
    if set(box.entries) != set(_indices(shape)):
        raise Refused("the entries are not those of its shape, one statement each")
    numbers = [box.entries[index] for index in _indices(shape)]
    return max((_error(box, claim, numbers, n) for n, number in enumerate(numbers) if number), default=0.0)


def _indices(shape: Entry) -> list[Entry]:
    found: list[Entry] = [()]
    for length in shape:
        found = [(*head, i) for head in found for i in range(length)]
    return found


def _error(box: Box, claim: Mapping[str, Any], numbers: Sequence[Number | None], position: int) -> float:
    """Of one entry against its scale."""
    number = numbers[position]
    if number is None:
        return 0.0
    bounds = [number.relative]
    if claim["scale"] == "covariance":
        row, column = divmod(position, claim["shape"][-1])
        first, second = (numbers[i * claim["shape"][-1] + i] for i in (row, column))
        if row != column and first and second and first.exactly and second.exactly:
            bounds.append(box.paired(number.error, first.exactly, second.exactly))
    elif claim["scale"] == "terms":
        bounds.append(box.share(number.error, number.terms))
    else:
        peers = [numbers[i] for i in claim["groups"][position]]
        bounds += [box.share(number.error, peer.exactly) for peer in peers if peer and peer.exactly]
        sizes = [(2 * peer.low).exp() for peer in peers if peer and peer.low.is_finite()]
        if sizes and number.error:
            bounds.append(_above((box.bounds(number.error)[1] - sum(sizes, box.ball(0)).log() / 2).exp()))
    finite = [float(bound.upper()) for bound in bounds if bound is not None and bound.is_finite()]
    if not finite:
        raise Refused(f"no bound of entry {position}")
    return math.nextafter(min(finite), math.inf)
