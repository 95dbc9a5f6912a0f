"""The slips that print is prone to: what may stand in the place of a part of a formula."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace

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
    names,
    rebuild,
)

FAMILIES = (("sin", "cos", "tan"), ("sinh", "cosh", "tanh", "exp"), ("asin", "acos", "atan"))
SHOWN = 50


@dataclass(frozen=True)
class Alternative:
    """Something that may stand in the place of a part.

    Attributes:
        tree: what stands there instead.
        words: the edit.
        cost: the less likely the slip, the more.
    """

    tree: Tree
    words: str
    cost: float


def alternatives(tree: Tree, kinds: Mapping[str, object]) -> Iterator[Alternative]:
    """What may have been meant by this part alone.

    Args:
        tree: the part.
        kinds: the symbols allowed, and what makes them alike: their units.
    """
    match tree:
        case Name(name):
            yield from _other_names(name, kinds)
            yield from _powers(tree)
        case Call(function, arguments):
            yield from _other_functions(function, arguments)
            yield from _powers(tree)
            yield from _out_of_call(tree)
        case Power(base, exponent):
            yield Alternative(base, f"{_shown(tree)} without its exponent", 1.1)
            yield from _into_call(base, exponent)
            yield from _power_of_part(base, exponent)
        case Sum(terms):
            yield from _fewer(tree, terms, "an extra term")
            yield from _signs(terms)
            yield from _brackets_around(terms)
        case Product(factors):
            yield from _fewer(tree, factors, "an extra factor")
            yield from _brackets_removed(factors)
        case Quotient(numerator, denominator):
            yield from _fractions(numerator, denominator)
        case Negation(operand):
            yield Alternative(operand, f"the sign of {_shown(operand)}", 1.0)
            yield from _sign_of_sum(operand)
        case _:
            return


def everywhere(tree: Tree, kinds: Mapping[str, object]) -> Iterator[Alternative]:
    """Slips that run through a whole formula."""
    used = sorted(names(tree))
    for first, second in (("sin", "cos"), ("sinh", "cosh")):
        swapped = rebuild(tree, _swap_functions(first, second))
        yield Alternative(swapped, f"{first} and {second} swapped everywhere", 1.8)
    for name in used:
        for other in sorted(kinds):
            if other != name:
                alike = 0.0 if kinds[other] == kinds.get(name) else 0.5
                yield Alternative(
                    rebuild(tree, _swap_names(name, other)), f"{name} and {other} swapped", 1.8 + alike
                )
                yield Alternative(
                    rebuild(tree, _rename(name, other)), f"{name} should be {other}", 1.9 + alike
                )
        yield Alternative(
            rebuild(tree, _put(name, Negation(Name(name)))), f"the sign of {name} everywhere", 1.9
        )
        squared = Power(Name(name), Number("2"))
        yield Alternative(rebuild(tree, _put(name, squared)), f"{name} should be {name}**2 everywhere", 2.0)
        root = rebuild(tree, _root_of(name))
        yield Alternative(root, f"{name}**2 should be {name} everywhere", 2.0)


def _other_names(name: str, kinds: Mapping[str, object]) -> Iterator[Alternative]:
    for other in sorted(kinds):
        if other != name:
            cost = 1.0 if kinds[other] == kinds.get(name) else 1.3
            yield Alternative(Name(other), f"{name} should be {other}", cost)


def _other_functions(function: str, arguments: tuple[Tree, ...]) -> Iterator[Alternative]:
    for family in FAMILIES:
        for other in family:
            if function in family and other != function:
                call = Call(other, arguments)
                yield Alternative(call, f"{function} should be {other}: {_shown(call)}", 1.0)


def _powers(tree: Tree) -> Iterator[Alternative]:
    for exponent in ("2", "3", "4"):
        power = Power(tree, Number(exponent))
        yield Alternative(power, f"{_shown(tree)} should be {_shown(power)}", 1.1)


def _out_of_call(call: Call) -> Iterator[Alternative]:
    if len(call.arguments) != 1:
        return
    (argument,) = call.arguments
    match argument:
        case Power(base, exponent):
            outside: Tree = Power(replace(call, arguments=(base,)), exponent)
        case Product(factors):
            outside = Product((replace(call, arguments=(factors[0],)), *factors[1:]))
        case Sum(terms):
            outside = Sum((replace(call, arguments=(terms[0],)), *terms[1:]))
        case _:
            return
    yield Alternative(outside, f"a bracket: {_shown(outside)}", 1.3)


def _into_call(base: Tree, exponent: Tree) -> Iterator[Alternative]:
    if isinstance(base, Call) and len(base.arguments) == 1:
        inside = replace(base, arguments=(Power(base.arguments[0], exponent),))
        yield Alternative(inside, f"a bracket: {_shown(inside)}", 1.3)


def _power_of_part(base: Tree, exponent: Tree) -> Iterator[Alternative]:
    match base:
        case Product(factors):
            yield _bracket(Product((*factors[:-1], Power(factors[-1], exponent))))
        case Quotient(numerator, denominator):
            yield _bracket(Quotient(numerator, Power(denominator, exponent)))
            yield _bracket(Quotient(Power(numerator, exponent), denominator))
        case Sum(terms):
            yield _bracket(Sum((*terms[:-1], Power(terms[-1], exponent))))
        case _:
            return


def _bracket(tree: Tree) -> Alternative:
    return Alternative(tree, f"a bracket: {_shown(tree)}", 1.4)


def _fewer(tree: Sum | Product, parts: tuple[Tree, ...], kind: str) -> Iterator[Alternative]:
    for place, part in enumerate(parts):
        rest = (*parts[:place], *parts[place + 1 :])
        yield Alternative(rest[0] if len(rest) == 1 else type(tree)(rest), f"{kind}: {_shown(part)}", 1.1)


def _signs(terms: tuple[Tree, ...]) -> Iterator[Alternative]:
    for place, term in enumerate(terms):
        other = term.operand if isinstance(term, Negation) else Negation(term)
        flipped = Sum((*terms[:place], other, *terms[place + 1 :]))
        yield Alternative(
            flipped, f"the sign of {_shown(term.operand if isinstance(term, Negation) else term)}", 1.0
        )


def _brackets_around(terms: tuple[Tree, ...]) -> Iterator[Alternative]:
    """a*b + c may have been a*(b + c), and a/b + c may have been a/(b + c) or (a + c)/b."""
    for place, term in enumerate(terms[:-1]):
        for end in range(place + 2, len(terms) + 1):
            rest = terms[place + 1 : end]
            for inner in _swallowed(term, rest):
                others = (*terms[:place], inner, *terms[end:])
                yield _bracket(others[0] if len(others) == 1 else Sum(others))


def _swallowed(term: Tree, rest: tuple[Tree, ...]) -> Iterator[Tree]:
    match term:
        case Product(factors):
            yield Product((*factors[:-1], _sum(factors[-1], rest)))
        case Quotient(numerator, denominator):
            yield Quotient(numerator, _sum(denominator, rest))
            yield Quotient(_sum(numerator, rest), denominator)
        case Negation(operand):
            yield Negation(_sum(operand, rest))
            for inner in _swallowed(operand, rest):
                yield Negation(inner)
        case _:
            return


def _sum(first: Tree, rest: tuple[Tree, ...]) -> Sum:
    return Sum((*(first.terms if isinstance(first, Sum) else (first,)), *rest))


def _brackets_removed(factors: tuple[Tree, ...]) -> Iterator[Alternative]:
    """a*(b + c) may have been a*b + c."""
    for place, factor in enumerate(factors):
        if not isinstance(factor, Sum):
            continue
        others = (*factors[:place], *factors[place + 1 :])
        for end in range(1, len(factor.terms)):
            kept = factor.terms[0] if end == 1 else Sum(factor.terms[:end])
            yield _bracket(Sum((Product((*others, kept)), *factor.terms[end:])))
        for out, term in enumerate(factor.terms[:-1]):
            rest = (*factor.terms[:out], *factor.terms[out + 1 :])
            yield _bracket(Sum((Product((*others, rest[0] if len(rest) == 1 else Sum(rest))), term)))


def _fractions(numerator: Tree, denominator: Tree) -> Iterator[Alternative]:
    yield Alternative(
        Quotient(denominator, numerator), f"the fraction upside down: {_shown(denominator)} above", 1.4
    )
    yield Alternative(numerator, f"an extra divisor: {_shown(denominator)}", 1.2)
    yield Alternative(
        Product((numerator, denominator)), f"a product, not a fraction: {_shown(denominator)}", 1.3
    )
    match numerator:
        case Sum(terms):
            yield _bracket(Sum((*terms[:-1], Quotient(terms[-1], denominator))))
            yield _bracket(Sum((Quotient(terms[0], denominator), *terms[1:])))
        case _:
            pass
    match denominator:
        case Sum(terms):
            yield _bracket(Sum((Quotient(numerator, terms[0]), *terms[1:])))
        case Product(factors):
            for place, factor in enumerate(factors):
                rest = (*factors[:place], *factors[place + 1 :])
                below = rest[0] if len(rest) == 1 else Product(rest)
                above = Product((numerator, factor))
                yield Alternative(Quotient(above, below), f"{_shown(factor)} above, not below", 1.4)
        case _:
            pass


def _sign_of_sum(operand: Tree) -> Iterator[Alternative]:
    if isinstance(operand, Sum):
        yield _bracket(Sum((Negation(operand.terms[0]), *operand.terms[1:])))


def _swap_functions(first: str, second: str) -> Callable[[Tree], Tree]:
    other = {first: second, second: first}
    return lambda node: (
        replace(node, function=other[node.function])
        if isinstance(node, Call) and node.function in other
        else node
    )


def _swap_names(first: str, second: str) -> Callable[[Tree], Tree]:
    other = {first: second, second: first}
    return lambda node: Name(other[node.name]) if isinstance(node, Name) and node.name in other else node


def _rename(name: str, other: str) -> Callable[[Tree], Tree]:
    return _put(name, Name(other))


def _put(name: str, tree: Tree) -> Callable[[Tree], Tree]:
    return lambda node: tree if isinstance(node, Name) and node.name == name else node


def _root_of(name: str) -> Callable[[Tree], Tree]:
    squared = Power(Name(name), Number("2"))
    return lambda node: Name(name) if node == squared else node


def _shown(tree: Tree) -> str:
    text = to_text(tree)
    return text if len(text) <= SHOWN else f"{text[: SHOWN - 3]}..."
