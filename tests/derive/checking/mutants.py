"""Formulas with one slip, and the same formulas written differently: what the checker must tell apart."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from random import Random

from radartrack.derive import symbolic as sp
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import (
    Call,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    replace_at,
    walk,
)
from radartrack.derive.symbolic import Expr

SWAPS = {"sin": "cos", "cos": "sin", "sinh": "cosh", "cosh": "sinh"}
POINTS = 3


def mutants(tree: Tree, names: dict[str, object], count: int, random: Random) -> Iterator[Tree]:
    """Up to `count` formulas that differ from this one in one place, no two alike."""
    changed = [replace_at(tree, path, new) for path, node in walk(tree) for new in _changes(node, names, bool(path))]
    distinct = [one for one in {to_text(one): one for one in changed}.values() if one != tree]
    yield from random.sample(distinct, min(count, len(distinct)))


def _changes(node: Tree, names: dict[str, object], below: bool) -> Iterator[Tree]:
    match node:
        case Number():
            yield from _other_numbers(node)
        case Name(name):
            yield Power(node, Number("2"))
            yield from (Name(other) for other, kind in names.items() if other != name and kind == names[name])
        case Call(function, arguments) if function in SWAPS:
            yield Call(SWAPS[function], arguments)
        case Power(base, Number() as exponent):
            yield from (base, Power(base, Number(str(exponent.value + 1))))
        case Negation(operand):
            yield operand
        case Sum(terms) | Product(terms):
            yield from _without_one(node, terms)
            yield from _with_a_sign(node, terms)
        case Quotient(numerator, denominator):
            yield from (numerator, Product((numerator, denominator)))
    yield from () if below else (Negation(node), Product((Number("2"), node)))


def _other_numbers(node: Number) -> Iterator[Tree]:
    for number in (node.value + 1, node.value * 2, abs(node.value - 1)):
        yield Number(str(number)) if number.denominator == 1 else node
    yield Quotient(Number("1"), node) if node.value > 1 else node


def _without_one(node: Sum | Product, parts: tuple[Tree, ...]) -> Iterator[Tree]:
    for place in range(len(parts)):
        rest = (*parts[:place], *parts[place + 1 :])
        yield rest[0] if len(rest) == 1 else type(node)(rest)


def _with_a_sign(node: Sum | Product, terms: tuple[Tree, ...]) -> Iterator[Tree]:
    for place, term in enumerate(terms if isinstance(node, Sum) else ()):
        other = term.operand if isinstance(term, Negation) else Negation(term)
        yield Sum((*terms[:place], other, *terms[place + 1 :]))


def rewritings(expression: Expr) -> dict[str, Expr]:
    """The same function, expanded, in exponentials, over double angles, and as one fraction."""
    return {
        "expanded": sp.expand(expression),
        "in exponentials": _replaced(expression, (sp.sinh, _sinh), (sp.cosh, _cosh), (sp.tanh, _tanh)),
        "over double angles": _replaced(sp.expand(expression), (sp.Pow, _double_angle)),
        "half angles": _replaced(expression, (sp.sin, _half_sine), (sp.cos, _half_cosine)),
        "one fraction": expression if _has_roots(expression) else sp.together(expression),
    }


def _has_roots(expression: Expr) -> bool:
    """Roots of products are not taken apart: that they may be depends on signs."""
    return any(not isinstance(power.exp, sp.Integer) for power in expression.atoms(sp.Pow))


def _replaced(expression: Expr, *rules: tuple[type[Expr], Callable[[Expr], Expr]]) -> Expr:
    for kind, rule in rules:
        expression = expression.xreplace({call: rule(call) for call in expression.atoms(kind)})
    return expression


def _sinh(call: Expr) -> Expr:
    return (sp.exp(call.args[0]) - sp.exp(-call.args[0])) / 2


def _cosh(call: Expr) -> Expr:
    return (sp.exp(call.args[0]) + sp.exp(-call.args[0])) / 2


def _tanh(call: Expr) -> Expr:
    return _sinh(call) / _cosh(call)


def _double_angle(power: Expr) -> Expr:
    base, exponent = power.as_base_exp()
    if not isinstance(exponent, sp.Integer) or exponent < 2 or base.func not in {sp.sin, sp.cos}:
        return power
    sign = 1 if base.func is sp.cos else -1
    return (1 + sign * sp.cos(2 * base.args[0])) / 2 * base ** (exponent - 2)


def _half_sine(call: Expr) -> Expr:
    half = call.args[0] / 2
    return 2 * sp.sin(half) * sp.cos(half)


def _half_cosine(call: Expr) -> Expr:
    half = call.args[0] / 2
    return 1 - 2 * sp.sin(half) ** 2
