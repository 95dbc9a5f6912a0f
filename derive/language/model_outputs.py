"""What an output of a model must be: smooth, and of the unit that is stated for it."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from radartrack.derive import symbolic as sp
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import ONE, Unit

LONGEST = 60
SMOOTH = (
    sp.acos, sp.asin, sp.atan, sp.atan2, sp.cos, sp.cosh, sp.exp, sp.hypot, sp.log, sp.sin, sp.sinh, sp.tan, sp.tanh,
)  # fmt: skip
"""What an expression may hold beside sums, products and powers."""
MADE_OF = (*SMOOTH, sp.Add, sp.Mul, sp.Pow, sp.Rational, sp.Symbol)


def require_smooth(output: str, expression: Expr) -> None:
    """Check that an output is made of what has derivatives of every order.

    Raises:
        ValueError: naming what has none.
    """
    for node in reversed(list(parts(expression))):  # the whole before its parts: a case before its condition
        if is_power(node) and not isinstance(node.exp, sp.Rational):
            raise ValueError(f"output {output}: in {shown(node)} the exponent is no number; exp and log say it")
        if not isinstance(node, MADE_OF) and node not in {sp.pi, sp.E}:
            allowed = ", ".join(sorted(function.__name__ for function in SMOOTH))
            raise ValueError(
                f"output {output}: {shown(node)} is not known to have derivatives of every order; "
                f"sums, products, powers and {allowed} are"
            )


def require_unit(output: str, expression: Expr, unit: Unit) -> None:
    """Check metres and seconds; a radian leaves no trace in a formula, and a number alone may have any unit.

    Raises:
        ValueError: naming both units.
    """
    try:
        found = _unit(expression)
    except ValueError as error:
        raise ValueError(f"output {output}: {error}") from None
    if found is not None and found != _plain(unit):
        raise ValueError(f"output {output} is said to be in {unit}; its expression {shown(expression)} is in {found}")


def shown(expression: Expr) -> str:
    """On one line, cut short where it is long."""
    text = " ".join(str(expression).split())
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 3]}..."


def parts(expression: Expr) -> Iterator[Expr]:
    """Every subexpression, those inside of others first, in the same order each time."""
    for argument in expression.args:
        yield from parts(argument)
    yield expression


def is_power(node: Expr) -> bool:
    """Whether it is a power, and no exponential, which SymPy takes for one."""
    return isinstance(node, sp.Pow) and not isinstance(node, sp.exp)


def _plain(unit: Unit) -> Unit:
    return Unit(unit.metre, unit.second)


def _unit(expression: Expr) -> Unit | None:
    """Metres and seconds; None for a number alone, and for what any unit fits.

    Raises:
        ValueError: terms of different units are added.
    """
    if isinstance(expression, Variable):
        return _plain(expression.unit)
    if isinstance(expression, sp.Add | sp.hypot):
        return _common(expression)
    if isinstance(expression, sp.Mul):
        units = [_unit(factor) for factor in expression.args if not factor.is_number]
        total = ONE
        for unit in units:
            total = total * (unit or ONE)
        return total
    if isinstance(expression, sp.Pow) and isinstance(expression.exp, sp.Rational):
        base = _unit(expression.base)
        return base and base ** Fraction(int(expression.exp.p), int(expression.exp.q))
    for argument in expression.args:
        _require_number(expression, argument)
    return None if expression.is_number else ONE


def _require_number(function: Expr, argument: Expr) -> None:
    """Refuse the logarithm of a length; what a quotient is taken of, as atan2 does, has a unit of its own."""
    unit = None if isinstance(function, sp.atan2 | sp.Pow) else _unit(argument)
    if unit not in {None, ONE}:
        raise ValueError(f"{shown(argument)} in {unit} cannot be inside of {shown(function)}")


def _common(terms: Expr) -> Unit | None:
    """The unit that all terms have."""
    found = {term: unit for term in terms.args if (unit := _unit(term)) is not None}
    (first, unit), *rest = found.items() or [(terms, None)]
    for term, other in rest:
        if other != unit:
            raise ValueError(f"{shown(first)} in {unit} and {shown(term)} in {other} cannot be added")
    return unit
