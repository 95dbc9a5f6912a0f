"""One expression as a line of NumPy, in an order that depends on names alone."""

from __future__ import annotations

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.term_order import by_name
from radartrack.derive.symbolic import Expr

FUNCTIONS: dict[type[Expr], str] = {
    sp.Abs: "np.abs",
    sp.acos: "np.arccos",
    sp.asin: "np.arcsin",
    sp.atan: "np.arctan",
    sp.atan2: "np.arctan2",
    sp.below: "np.less",
    sp.cos: "np.cos",
    sp.cosh: "np.cosh",
    sp.exp: "np.exp",
    sp.expm1: "np.expm1",
    sp.hypot: "np.hypot",
    sp.log: "np.log",
    sp.ratio: "_ratio",
    sp.sin: "np.sin",
    sp.sinh: "np.sinh",
    sp.tan: "np.tan",
    sp.tanh: "np.tanh",
    sp.third: "_third",
}
SUM, PRODUCT, POWER, ATOM = range(4)


class NotWritable(ValueError):
    """An expression holds a node that has no NumPy code, such as an unevaluated integral."""


def code(expression: Expr) -> str:
    """The expression as NumPy code.

    Raises:
        NotWritable: for a node that NumPy has no function for, and for inexact numbers.
    """
    return _code(expression)[0]


def terms(expression: Expr) -> list[str]:
    """The terms of a sum as code, each after the first with its sign and a space in front."""
    pieces = [_signed(term) for term in by_name(expression.args)]
    first = min((i for i, (sign, _) in enumerate(pieces) if sign == "+"), default=0)
    pieces.insert(0, pieces.pop(first))
    (sign, text), *rest = pieces
    return [text if sign == "+" else f"-{text}", *(f"{sign} {text}" for sign, text in rest)]


def _code(expression: Expr) -> tuple[str, int]:
    if isinstance(expression, sp.Symbol):
        return expression.name, ATOM
    if isinstance(expression, sp.Add):
        return " ".join(terms(expression)), SUM
    if isinstance(expression, sp.Mul | sp.Rational):
        sign, text = _signed(expression)
        return (text, PRODUCT) if sign == "+" else (f"-{text}", SUM)
    if isinstance(expression, sp.Pow):
        return _power(expression)
    if isinstance(expression, sp.remainder | sp.stumpff):
        argument, order = expression.args
        return f"_{expression.func.__name__}({code(argument)}, {int(order)})", ATOM
    if expression.func in FUNCTIONS:
        arguments = ", ".join(code(argument) for argument in expression.args)
        return f"{FUNCTIONS[expression.func]}({arguments})", ATOM
    if expression in (sp.pi, sp.E):
        return f"np.{'pi' if expression == sp.pi else 'e'}", ATOM
    raise NotWritable(f"{type(expression).__name__} in {expression} has no NumPy code")


def _signed(expression: Expr) -> tuple[str, str]:
    """Sign and magnitude of a term."""
    number, rest = expression.as_coeff_Mul(rational=True)
    if not isinstance(number, sp.Rational):
        raise NotWritable(f"{number} in {expression} is not exact")
    sign = "-" if number < 0 else "+"
    above, below = [], []
    numerator, denominator = int(abs(number.p)), int(number.q)
    if denominator & (denominator - 1) == 0 and denominator > 1:
        above.append(repr(numerator / denominator))
    elif numerator != 1:
        above.append(f"{numerator}.0")
    for factor in by_name(sp.Mul.make_args(rest)) if rest != 1 else []:
        base, exponent = factor.as_base_exp()
        if isinstance(exponent, sp.Rational) and exponent < 0 and not isinstance(factor, sp.exp):
            below.append(_wrapped(base**-exponent, POWER))
        else:
            above.append(_wrapped(factor, PRODUCT))
    if denominator & (denominator - 1):
        below.append(f"{denominator}.0")
    product = " * ".join(above) or "1.0"
    if not below:
        return sign, product
    divisor = below[0] if len(below) == 1 else f"({' * '.join(below)})"
    return sign, f"{product} / {divisor}"


def _power(expression: Expr) -> tuple[str, int]:
    base, exponent = expression.as_base_exp()
    if exponent == sp.Rational(1, 2):
        return f"np.sqrt({code(base)})", ATOM
    if isinstance(exponent, sp.Rational) and exponent < 0:
        return f"1.0 / {_wrapped(base**-exponent, POWER)}", PRODUCT
    if isinstance(exponent, sp.Rational) and exponent.q == 2:
        return _integer_power(f"np.sqrt({code(base)})", int(exponent.p))
    if isinstance(exponent, sp.Rational) and exponent.q > 2:
        return f"{_wrapped(base, ATOM)} ** ({int(exponent.p)}.0 / {int(exponent.q)}.0)", POWER
    if not isinstance(exponent, sp.Integer):
        raise NotWritable(f"the power {expression} has an exponent that is no number")
    return _integer_power(_wrapped(base, ATOM), int(exponent))


def _integer_power(base: str, exponent: int) -> tuple[str, int]:
    """Squares are fast in NumPy and rounded once; other powers are made of them."""
    if exponent == 1:
        return base, ATOM
    if exponent == 2:
        return f"{base}**2", POWER
    half, level = _integer_power(base, exponent // 2)
    squared = f"({half})**2" if level < ATOM else f"{half}**2"
    return (squared, POWER) if exponent % 2 == 0 else (f"{base} * {squared}", PRODUCT)


def _wrapped(expression: Expr, level: int) -> str:
    text, found = _code(expression)
    return text if found >= level else f"({text})"
