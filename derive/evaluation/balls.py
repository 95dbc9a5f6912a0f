"""Formulas in ball arithmetic (Arb, through python-flint): many digits with a proved error, and faster than mpmath.

python-flint is optional. What is used of it is tried before it is trusted: there have been versions whose negation
rounded to 53 bits.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache, reduce
from importlib.util import find_spec
from operator import add, mul
from typing import Any

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.evaluation.steps import leaves, steps
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, Symbol

Ball = Any
PRECISION = 448  # bits; the textbook form of a fourth power of 1e-9 against 1e8 squared loses some 175
MOST = 8 * PRECISION
GOOD = 120  # bits that an entry must have, unless it is zero


class Balls:
    """A tensor of formulas, prepared for evaluation at many points; as `derive.evaluation.Evaluator`, with balls."""

    def __init__(self, entries: Tensor[Expr], symbols: Sequence[Symbol]) -> None:
        numbers = {leaf for entry in entries for leaf in leaves(entry) if leaf.is_number}
        self._numbers = sorted(numbers, key=str)
        self._known: dict[int, list[Ball]] = {}
        self._steps = steps(entries, [*symbols, *self._numbers], _step)
        self._shape = entries.shape

    def __call__(self, point: Mapping[str, float] | Sequence[float]) -> Tensor[Ball]:
        """The entries at one point, in more and more bits until they are sharp."""
        values = list(point.values() if isinstance(point, Mapping) else point)
        bits = PRECISION
        while True:
            with _precision(bits):
                entries = self._entries(values, bits)
            if bits >= MOST or all(_sharp(entry) for entry in entries):
                return Tensor(self._shape, tuple(entry.mid() for entry in entries))
            bits *= 2

    def _entries(self, values: Sequence[float], bits: int) -> list[Ball]:
        if bits not in self._known:
            self._known[bits] = list(map(_number, self._numbers))
        slots = [*map(_flint().arb, values), *self._known[bits]]
        for operation, operands in self._steps.steps:
            slots.append(operation(*[slots[i] for i in operands]))
        return [slots[i] for i in self._steps.results]


def _step(expression: Expr) -> tuple[Callable[..., Ball], Sequence[Expr]]:
    """What makes a part of a formula from its own parts."""
    if isinstance(expression, sp.Pow) and isinstance(expression.exp, sp.Integer):
        exponent = int(expression.exp)
        return lambda base: base**exponent, (expression.base,)
    if isinstance(expression, sp.Pow) and expression.exp == sp.Rational(1, 2):
        return lambda base: base.sqrt(), (expression.base,)
    return _OPERATIONS[expression.func], expression.args


def _number(number: Expr) -> Ball:
    """At the precision of the moment."""
    if isinstance(number, sp.Rational):
        return _flint().arb(int(number.p)) / int(number.q)
    return {sp.pi: _flint().arb.pi, sp.E: _flint().arb.const_e}[number]()


def _stumpff(x: Ball, order: Ball) -> Ball:
    """c_n of the square, by the closed form; its digits are lost near zero and found again in more bits."""
    n = int(order.unique_fmpz())
    if x.is_zero():
        return 1 / _flint().arb(n).fac()
    square, value = x * x, x.sin() / x if n % 2 else x.cos()
    for k in range(n % 2, n, 2):
        value = (1 / _flint().arb(k).fac() - value) / square
    return value


def _third(x: Ball) -> Ball:
    return (x.acosh() / 3).cosh() if x >= 1 else (x.acos() / 3).cos()


def _sharp(entry: Ball) -> bool:
    return bool(entry.is_exact() or entry.rel_accuracy_bits() >= GOOD)


_OPERATIONS: dict[type[Expr], Callable[..., Ball]] = {
    sp.Abs: abs,
    sp.Add: lambda *terms: reduce(add, terms),
    sp.Mul: lambda *factors: reduce(mul, factors),
    sp.Pow: lambda base, exponent: base**exponent,
    sp.acos: lambda x: x.acos(),
    sp.asin: lambda x: x.asin(),
    sp.atan: lambda x: x.atan(),
    sp.atan2: lambda y, x: y.atan2(y, x),
    sp.cos: lambda x: x.cos(),
    sp.cosh: lambda x: x.cosh(),
    sp.erf: lambda x: x.erf(),
    sp.exp: lambda x: x.exp(),
    sp.expm1: lambda x: x.expm1(),
    sp.hypot: lambda x, y: (x * x + y * y).sqrt(),
    sp.log: lambda x: x.log(),
    sp.ratio: lambda above, below: above * 0 if below.is_zero() else above / below,
    sp.sin: lambda x: x.sin(),
    sp.sinh: lambda x: x.sinh(),
    sp.stumpff: _stumpff,
    sp.tan: lambda x: x.tan(),
    sp.tanh: lambda x: x.tanh(),
    sp.third: _third,
}


@cache
def _flint() -> Any:
    import flint  # noqa: PLC0415 - optional, and slow to load

    return flint


@contextmanager
def _precision(bits: int) -> Iterator[None]:
    context = _flint().ctx
    before = context.prec
    context.prec = bits
    try:
        yield
    finally:
        context.prec = before


@cache
def trustworthy() -> bool:
    """Whether python-flint is installed and what is used of it keeps its digits."""
    if find_spec("flint") is None:
        return False
    with _precision(PRECISION):
        third = _flint().arb(1) / 3
        residues = [-third + third, abs(-third) - third, third - third.mid(), (third - 1.5) + 1.5 - third]
        residues += [third.sin() ** 2 + third.cos() ** 2 - 1, (third.expm1() + 1).log() - third]
    return all(abs(float(residue.mid())) + float(residue.rad()) < 2.0 ** (16 - PRECISION) for residue in residues)


def exact_arithmetic() -> tuple[str, Callable[[Tensor[Expr], Sequence[Symbol]], Any]]:
    """The faster of the two that can be trusted, and its name."""
    if trustworthy():
        return f"ball arithmetic, python-flint {_flint().__version__}", Balls
    return "mpmath", Evaluator
