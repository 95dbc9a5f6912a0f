"""Limits with a closed form: quotients of polynomials and exponentials, and continuous functions of what has a limit.

At infinity the terms x^p e^(cx) of numerator and denominator are ordered by c, then by p, and the leading ones are
compared; a rate whose sign the symbols' domains do not say leaves the question open. At a finite point the first
derivatives that do not vanish are compared. Roots at infinity are roots at zero of the inverse, from each of which
the power that vanishes there is taken out.
"""

from __future__ import annotations

from collections.abc import Callable
from math import lcm

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.equality import proved_zero
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.verbs.derivatives import is_finite
from radartrack.derive.verbs.no_closed_form import NoClosedForm, shown

MOST_DERIVATIVES = 24  # until numerator and denominator are known at a point where both vanish
ZERO: Expr = sp.Integer(0)
ONE: Expr = sp.Integer(1)
_CONTINUOUS = (sp.Abs, sp.acos, sp.asin, sp.atan, sp.cos, sp.cosh, sp.exp, sp.sin, sp.sinh, sp.tanh)


def limit(function: Expr, variable: Symbol, point: Expr) -> Expr:
    """The limit of a function where the variable goes to a point, or to infinity or minus infinity.

    Raises:
        NoClosedForm: when there is none, it is infinite, or it cannot be decided.
    """
    x = sp.Symbol(f"{{{variable.name}}}", real=True)  # the domain of the paper's letter does not hold here
    free = function.xreplace({variable: -x if point == -sp.oo else x})
    if point in (sp.oo, -sp.oo):
        return _limit(free, x, _at_infinity)
    return _limit(free, x, lambda quotient, symbol: _at_point(quotient, symbol, point))


def _limit(function: Expr, x: Symbol, of_quotient: Callable[[Expr, Symbol], Expr]) -> Expr:
    if x not in function.free_symbols:
        return function
    try:
        return of_quotient(function, x)
    except _NoQuotient:
        pass
    if of_quotient is _at_infinity and _is_algebraic(function, x):
        return _of_roots_at_infinity(function, x)
    if isinstance(function, sp.Add | sp.Mul):
        return function.func(*(_limit(part, x, of_quotient) for part in function.args))
    if isinstance(function, sp.Pow) and x not in function.exp.free_symbols:
        inside = _limit(function.base, x, of_quotient)
        if inside != ZERO or function.exp.is_positive:
            return inside**function.exp
    if isinstance(function, _CONTINUOUS):
        return function.func(*(_limit(argument, x, of_quotient) for argument in function.args))
    raise NoClosedForm(f"the limit of {_shown(function)} cannot be decided here")


class _NoQuotient(ValueError):
    """Something else than polynomials and exponentials occurs."""


def _at_infinity(function: Expr, x: Symbol) -> Expr:
    above, below = sp.fraction(sp.together(function))
    (rate, power, value), (other_rate, other_power, other) = (_leading(sp.expand(part), x) for part in (above, below))
    growth = _sign(rate - other_rate) or (power > other_power) - (power < other_power)
    if growth > 0:
        raise NoClosedForm(f"{_shown(function)} grows without bound")
    return value / other if growth == 0 else ZERO


def _leading(total: Expr, x: Symbol) -> tuple[Expr, int, Expr]:
    """The rate c, the power p and the coefficient of the leading one of terms x^p e^(cx)."""
    terms: dict[Expr, dict[int, Expr]] = {}
    for part in sp.Add.make_args(total):
        rate, power, coefficient = _term(part, x)
        of_rate = terms.setdefault(rate, {})
        of_rate[power] = of_rate.get(power, ZERO) + coefficient
    known = {rate: {p: c for p, c in powers.items() if sp.cancel(c) != ZERO} for rate, powers in terms.items()}
    rates = [rate for rate, powers in known.items() if powers]
    if not rates:
        return ZERO, 0, ZERO
    best = rates[0]
    for one in rates[1:]:
        best = one if _sign(one - best) > 0 else best
    power = max(known[best])
    return best, power, known[best][power]


def _term(part: Expr, x: Symbol) -> tuple[Expr, int, Expr]:
    rate, power, coefficient = ZERO, 0, ONE
    for factor in sp.Mul.make_args(part):
        base, exponent = factor.as_base_exp()
        if x not in factor.free_symbols:
            coefficient *= factor
        elif base == x and isinstance(exponent, sp.Integer):
            power += int(exponent)
        elif isinstance(factor, sp.exp) and x not in (slope := sp.diff(factor.args[0], x)).free_symbols:
            rate += slope
            coefficient *= sp.exp(sp.expand(factor.args[0] - slope * x))
        else:
            raise _NoQuotient
    return sp.expand(rate), power, coefficient


def _sign(rate: Expr) -> int:
    rate = sp.factor(rate)
    if rate == ZERO:
        return 0
    if rate.is_positive or (-rate).is_positive:
        return 1 if rate.is_positive else -1
    raise NoClosedForm(f"the limit depends on the sign of {shown(rate)}, which is not known")


def _at_point(function: Expr, x: Symbol, point: Expr) -> Expr:
    above, below = sp.fraction(sp.together(function))
    if any(not _is_smooth(part, x, point) for part in (above, below)):
        raise _NoQuotient
    first, second = (_first_derivative(part, x, point) for part in (above, below))
    if first[0] < second[0]:
        raise NoClosedForm(f"{_shown(function)} grows without bound")
    return first[1] / second[1] if first[0] == second[0] else ZERO


def _is_smooth(part: Expr, x: Symbol, point: Expr) -> bool:
    """Whether only polynomials, sines, cosines and exponentials occur, and roots of what does not vanish there."""
    roots = {power for power in part.atoms(sp.Pow) if x in power.free_symbols and not isinstance(power.exp, sp.Integer)}
    return not part.atoms(sp.Function) - part.atoms(sp.cos, sp.sin, sp.exp, sp.cosh, sp.sinh) and all(
        isinstance(root, sp.exp) or (isinstance(root.exp, sp.Rational) and _is_fixed(root.base.xreplace({x: point})))
        for root in roots
    )


def _is_fixed(value: Expr) -> bool:
    """Whether a value is finite and known to be no zero."""
    return is_finite(value) and bool(sp.factor(value).is_positive)


def _is_algebraic(function: Expr, x: Symbol) -> bool:
    return not any(x in part.free_symbols for part in function.atoms(sp.Function, sp.exp)) and all(
        isinstance(power.exp, sp.Rational) for power in function.atoms(sp.Pow) if x in power.free_symbols
    )


def _of_roots_at_infinity(function: Expr, x: Symbol) -> Expr:
    """The limit of roots of quotients of polynomials: that at zero of the inverse, or of a root of it."""
    degree = lcm(*(power.exp.q for power in function.atoms(sp.Pow) if isinstance(power.exp, sp.Rational)))
    small = sp.Symbol("{inverse}", positive=True)
    try:
        return _limit(_without_poles(function.xreplace({x: small**-degree}), small), small, _at_zero)
    except NoClosedForm:
        raise NoClosedForm(f"the limit of {_shown(function)} is infinite, or cannot be decided here") from None


def _at_zero(quotient: Expr, symbol: Symbol) -> Expr:
    return _at_point(quotient, symbol, ZERO)


def _without_poles(function: Expr, small: Symbol) -> Expr:
    """With the powers of what becomes small taken out of roots."""
    if isinstance(function, sp.Pow) and small in function.free_symbols and not isinstance(function.exp, sp.Integer):
        above, below = sp.fraction(sp.together(_without_poles(function.base, small)))
        orders = [_lowest(sp.expand(part), small) for part in (above, below)]
        rest = sp.expand(above / small ** orders[0]) / sp.expand(below / small ** orders[1])
        return small ** (function.exp * (orders[0] - orders[1])) * rest**function.exp
    arguments = [_without_poles(argument, small) for argument in function.args]
    return function.func(*arguments) if arguments else function


def _lowest(total: Expr, small: Symbol) -> Expr:
    """The least power in a polynomial, perhaps of a root."""
    powers = (term.as_powers_dict().get(small, ZERO) for term in sp.Add.make_args(total))
    return min(powers, key=float)


def _first_derivative(part: Expr, x: Symbol, point: Expr) -> tuple[int, Expr]:
    """The order and the value of the first derivative that does not vanish; of zero, beyond all orders."""
    for order in range(MOST_DERIVATIVES):
        value = sp.cancel(sp.expand(part.xreplace({x: point})))
        if not is_finite(value):
            raise _NoQuotient
        if value != ZERO and not proved_zero(value):
            return order, value
        part = sp.diff(part, x)
    if sp.expand(part) == ZERO:
        return MOST_DERIVATIVES, ZERO
    raise NoClosedForm(f"the first {MOST_DERIVATIVES} derivatives of a part vanish at {shown(point)}")


def _shown(function: Expr) -> str:
    return shown(function).replace("{", "").replace("}", "")
