"""The typed façade over SymPy: the only module that imports it; its types stand in `symbolic.pyi`.

SymPy carries no type information, so every other module takes its symbolic algebra from here.
"""

from fractions import Fraction
from functools import lru_cache
from math import factorial

from sympy import (
    QQ,
    QQ_I,
    Abs,
    Add,
    Basic,
    E,
    Expr,
    Function,
    Heaviside,
    I,
    Integer,
    Matrix,
    Mul,
    Number,
    Poly,
    Pow,
    Rational,
    Symbol,
    acos,
    acot,
    acoth,
    acsc,
    arg,
    asec,
    asin,
    asinh,
    atan,
    atan2,
    atanh,
    cancel,
    conjugate,
    cos,
    cosh,
    cot,
    coth,
    csc,
    csch,
    diff,
    erf,
    exp,
    expand,
    factor_list,
    factor_terms,
    fraction,
    groebner,
    im,
    latex,
    log,
    nan,
    oo,
    pi,
    re,
    sec,
    sech,
    sign,
    sin,
    sinh,
    sqrt,
    srepr,
    tan,
    tanh,
    together,
    zoo,
)
from sympy import Float as _Float
from sympy import factor as _factor
from sympy.core import random
from sympy.core.numbers import Exp1, ImaginaryUnit, NumberSymbol
from sympy.polys.rings import PolyElement, PolyRing
from sympy.printing.str import StrPrinter

__all__ = [
    "QQ",
    "QQ_I",
    "Abbreviation",
    "Abs",
    "Add",
    "Basic",
    "E",
    "Exp1",
    "Expr",
    "Function",
    "Heaviside",
    "I",
    "ImaginaryUnit",
    "Integer",
    "Matrix",
    "Mul",
    "Number",
    "NumberSymbol",
    "Poly",
    "PolyElement",
    "PolyRing",
    "Pow",
    "Rational",
    "StrPrinter",
    "Symbol",
    "acos",
    "acot",
    "acoth",
    "acsc",
    "arg",
    "asec",
    "asin",
    "asinh",
    "atan",
    "atan2",
    "atanh",
    "below",
    "cancel",
    "conjugate",
    "cos",
    "cosh",
    "cot",
    "coth",
    "csc",
    "csch",
    "diff",
    "erf",
    "exact",
    "exp",
    "expand",
    "expm1",
    "factor",
    "factor_list",
    "factor_terms",
    "fraction",
    "groebner",
    "hypot",
    "im",
    "is_float",
    "latex",
    "log",
    "nan",
    "oo",
    "pi",
    "ratio",
    "re",
    "remainder",
    "sec",
    "sech",
    "sign",
    "sin",
    "sinh",
    "sqrt",
    "srepr",
    "stumpff",
    "tan",
    "tanh",
    "third",
    "together",
    "unguarded",
    "zoo",
]


DOUBLE = 53  # bits


class expm1(Function):
    """e^x − 1 as a function of its own, so that it reaches the writer as one."""

    nargs = 1

    def fdiff(self, argindex: int = 1) -> Expr:  # noqa: ARG002 - SymPy names the argument; there is one
        """The derivative, e^x."""
        return exp(self.args[0])


class Abbreviation(Function):
    """A function whose `expanded` form, of elementary ones, loses digits or passes through complex numbers."""


class remainder(Abbreviation):
    """e^x less the terms of its series below an order: x^2/2 + x^3/6 + ... from the order 2 on."""

    nargs = 2

    def expanded(self) -> Expr:
        """The difference itself, in which digits cancel."""
        x, order = self.args
        return exp(x) - Add(*(x**n / factorial(n) for n in range(int(order))))


class hypot(Function):
    """√(x² + y²) as a function of its own, so that it reaches the writer as one."""

    nargs = 2

    def fdiff(self, argindex: int = 1) -> Expr:
        """The derivative by either argument."""
        return self.args[argindex - 1] / hypot(*self.args)


class ratio(Function):
    """x/y where y is not zero, and zero where it is: for derivatives that do not exist everywhere."""

    nargs = 2


class stumpff(Abbreviation):
    """Stumpff's c_n of x^2: 1/n! - x^2/(n+2)! + x^4/(n+4)! - ..., a sine or cosine less what its series begins with.

    c_0 is cos x, c_1 is sin x / x, c_2 is (1 - cos x)/x^2; all are finite at zero, and their derivatives are of them.
    """

    nargs = 2

    def fdiff(self, argindex: int = 1) -> Expr:  # noqa: ARG002 - by the first argument; the other is a number
        """The derivative by x."""
        x, order = self.args
        return -x * (stumpff(x, order + 1) - order * stumpff(x, order + 2))

    def expanded(self) -> Expr:
        """The closed form, which is 0/0 at zero."""
        x, order = self.args
        if order < 2:
            return sin(x) / x if order else cos(x)
        return (Rational(1, factorial(int(order) - 2)) - stumpff(x, order - 2).expanded()) / x**2


class third(Abbreviation):
    """The cosine of the third part of the angle whose cosine is given; hyperbolic ones where it is above one.

    It is the positive root c of 4 c^3 - 3 c = x, for x from 0 on.
    """

    nargs = 1

    def fdiff(self, argindex: int = 1) -> Expr:  # noqa: ARG002 - SymPy names the argument; there is one
        """The derivative, from that of the cubic."""
        return 1 / (12 * self**2 - 3)

    def expanded(self) -> Expr:
        """Cardano's cube roots, of a complex number where the argument is below one."""
        x = self.args[0]
        root = (x + sqrt(x**2 - 1)) ** Rational(1, 3)
        return (root + 1 / root) / 2


class below(Function):
    """One where the first argument is less than the second, else zero: a weight between forms of one function."""

    nargs = 2


@lru_cache(maxsize=1 << 12)
def factor(expression: Expr) -> Expr:
    """The product of factors over the rationals; many quantities share their parts, and finding them takes long.

    SymPy draws the points at which it looks for factors. With bad ones a long sum takes minutes instead of a second, so
    they are the same in every process.
    """
    random.seed(0)
    return _factor(expression)


def unguarded(expression: Expr) -> Expr:
    """Ratios as quotients, hypot as the root of a sum of squares, what is left of a series as a difference."""
    if not expression.args:
        return expression
    arguments = [unguarded(argument) for argument in expression.args]
    if isinstance(expression, ratio):
        return arguments[0] / arguments[1]
    if isinstance(expression, hypot):
        return sqrt(arguments[0] ** 2 + arguments[1] ** 2)
    if isinstance(expression, remainder | stumpff):
        return expression.func(*arguments).expanded()
    return expression.func(*arguments)


def exact(value: object) -> Expr:
    """A number or an expression with every float in it as the shortest decimal that stands for it: 0.1 is 1/10.

    Raises:
        TypeError: for anything else.
        ValueError: where a number is not finite.
    """
    if isinstance(value, int | float | Fraction) and not isinstance(value, bool):
        return _rational(value)
    if not isinstance(value, Expr):
        raise TypeError(f"it must be an expression or a number; given {value!r}")
    if value.has(nan, oo, zoo, -oo):
        raise ValueError(f"{value} is not finite")
    return value.xreplace({number: _rational(number) for number in value.atoms(_Float)})


def _rational(number: object) -> Expr:
    """Exactly, but a float of up to 53 bits by its shortest decimal."""
    if isinstance(number, float) or (isinstance(number, _Float) and number._prec <= DOUBLE):  # noqa: SLF001 - SymPy's
        number = repr(float(number))
    try:
        return Rational(Fraction(str(number)))
    except ValueError:
        raise ValueError(f"{number} is not finite") from None


def is_float(expression: Expr) -> bool:
    """Whether an inexact number occurs; derivations are exact, so it never may."""
    return bool(expression.has(_Float))
