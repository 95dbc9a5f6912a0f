"""Sums with what their terms share written once, as Horner's rule does for powers.

a b + a c + d becomes a (b + c) + d: the same terms from fewer multiplications. Nothing is multiplied out, so that what
was arranged not to cancel does not cancel now. Inner sums that are opposite are written with the same signs.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.term_order import by_name
from radartrack.derive.symbolic import Expr


def nested(expression: Expr) -> Expr:
    """The expression with every sum in it nested."""
    if expression.is_Atom:
        return expression
    arguments = [nested(argument) for argument in expression.args]
    if isinstance(expression, sp.Add):
        return _nested_sum([_Term.of(argument) for argument in arguments])
    if isinstance(expression, sp.Mul):
        return sp.Mul(*(part for argument in arguments for part in _signed(argument)))
    return expression.func(*arguments)


@dataclass(frozen=True)
class _Term:
    """A product: a number, and integer powers by base."""

    number: Expr
    powers: Mapping[Expr, int]

    @classmethod
    def of(cls, expression: Expr) -> _Term:
        number, rest = expression.as_coeff_Mul(rational=True)
        factors = [_power(factor) for factor in sp.Mul.make_args(rest)] if rest != 1 else []
        return cls(number, dict(factors))

    def over(self, base: Expr, power: int) -> _Term:
        """The term divided by a power of one of its bases."""
        return _Term(self.number, {**self.powers, base: self.powers[base] - power})

    def expression(self) -> Expr:
        return sp.Mul(self.number, *(base**power for base, power in self.powers.items()))


def _power(factor: Expr) -> tuple[Expr, int]:
    base, exponent = factor.as_base_exp()
    is_integer = isinstance(exponent, sp.Integer) and not isinstance(factor, sp.exp)
    return (base, int(exponent)) if is_integer else (factor, 1)


def _nested_sum(terms: Sequence[_Term]) -> Expr:
    """The factor that most terms have in common is taken out first; ties go by name."""
    uses = Counter((base, power > 0) for term in terms for base, power in term.powers.items() if power)
    most = max(uses.values(), default=0)
    if most < 2:
        return sp.Add(*(term.expression() for term in terms))
    base = by_name(base for (base, _), count in uses.items() if count == most)[0]
    above = uses[base, True] == most
    holding: list[_Term] = []
    rest: list[_Term] = []
    for term in terms:
        power = term.powers.get(base, 0)
        (holding if power and (power > 0) == above else rest).append(term)
    power = min((term.powers[base] for term in holding), key=abs)
    inner = _nested_sum([term.over(base, power) for term in holding])
    outer = sp.Mul(base**power, *_signed(inner))
    return sp.Add(outer, _nested_sum(rest)) if rest else outer


def _signed(factor: Expr) -> tuple[Expr, ...]:
    """A sum that begins with a minus as its opposite behind the number -1; any other factor alone."""
    if isinstance(factor, sp.Add):
        numbers = {rest: number for number, rest in (term.as_coeff_Mul(rational=True) for term in factor.args)}
        if numbers[by_name(numbers)[0]] < 0:
            return (sp.Integer(-1), -factor)
    return (factor,)
