"""Formulas with one slip, and the same formulas written differently: what the checker must tell apart."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import islice
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

SWAPS = {"sin": ("cos",), "cos": ("sin", "cosh"), "sinh": ("cosh", "sin"), "cosh": ("sinh", "cos")}
SHORT = 300  # characters of what SymPy factors in little time
TRIES = 20  # for each formula with two slips that is wanted


def mutants(tree: Tree, names: Mapping[str, object], count: int, random: Random) -> list[Tree]:
    """Formulas that differ from this one by one slip; by two where there are not `count` of these.

    Args:
        tree: the formula.
        names: its symbols, and what makes them alike: their dimensions.
        count: how many are wanted.
        random: chooses among them.
    """
    known = {to_text(tree)}
    found = list(islice(_slips(tree, names, known, random), count))
    once = list(found)
    for _ in range(TRIES * (count - len(found))):
        if len(found) < count:
            found.extend(islice(_slips(random.choice(once), names, known, random), 1))
    return found


def _slips(tree: Tree, names: Mapping[str, object], known: set[str], random: Random) -> Iterator[Tree]:
    """Formulas with one slip in any order; none that prints as one that is known."""
    places = [
        (path, new)
        for path, node in walk(tree)
        for new in (*_changes(node, names), *_additions(node, names, whole=not path))
    ]
    for path, new in random.sample(places, len(places)):
        changed = replace_at(tree, path, new)
        if (text := to_text(changed)) not in known:
            known.add(text)
            yield changed


def _changes(node: Tree, names: Mapping[str, object]) -> Iterator[Tree]:
    """Another sign, number, symbol, function or exponent, or something left out."""
    match node:
        case Number():
            yield from _other_numbers(node)
        case Name(name):
            yield from (Name(other) for other, kind in names.items() if other != name and kind == names[name])
            yield from (Power(node, Number("2")), Power(node, Number("3")))
        case Call(function, arguments):
            yield from (Call(other, arguments) for other in SWAPS.get(function, ()))
            yield Power(node, Number("2"))
        case Power(base, Number() as exponent):
            yield from (base, Power(base, Number(str(exponent.value + 1))))
        case Negation(operand):
            yield operand
        case Sum(terms) | Product(terms):
            yield from _without_one(node, terms)
            yield from _with_a_sign(node, terms)
        case Quotient(numerator, denominator):
            yield from (numerator, Product((numerator, denominator)), Quotient(denominator, numerator))


def _additions(node: Tree, names: Mapping[str, object], *, whole: bool) -> Iterator[Tree]:
    """A factor, divisor or term too many, or another sign."""
    if whole:
        yield Negation(node)
    if whole or isinstance(node, Name | Call | Sum):
        factors: list[Tree] = [Number("2"), Number("3"), *map(Name, names)]
        for factor in factors:
            yield from (Product((factor, node)), Quotient(node, factor))
    if whole or isinstance(node, Sum):
        terms = node.terms if isinstance(node, Sum) else (node,)
        more: list[Tree] = [Number("1"), *map(Name, names)]
        yield from (Sum((*terms, term)) for term in more)


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
    """The same function expanded, factored, in exponentials, over double and half angles, and as one fraction."""
    expanded = sp.expand(expression)
    return {
        "expanded": expanded,
        "factored": _factored(expression),
        "in exponentials": _replaced(expression, (sp.sinh, _sinh), (sp.cosh, _cosh), (sp.tanh, _tanh)),
        "over double angles": _replaced(expanded, (sp.Pow, _double_angle)),
        "half angles": _replaced(expression, (sp.sin, _half_sine), (sp.cos, _half_cosine)),
        "one fraction": sp.together(expression),
    }


def _factored(expression: Expr) -> Expr:
    return sp.factor(expression) if len(str(expression)) <= SHORT else sp.factor_terms(expression)


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
