"""The slips that print is prone to: what may stand in the place of a part of a formula."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace

from radartrack.derive.checking.question.definitions.known_constants import nearly
from radartrack.derive.checking.repairing.monomial_fit import number_tree
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
    children,
    replace_at,
    walk,
    with_children,
)

FAMILIES = (
    ("sin", "cos", "tan"),
    ("sinh", "cosh", "tanh", "exp"),
    ("asin", "acos", "atan"),
    ("sin", "sinh"),
    ("cos", "cosh"),
    ("tan", "tanh"),
)
INVERSES = ({"sin", "asin"}, {"cos", "acos"}, {"tan", "atan"}, {"exp", "log"})
PERIODIC = {"sin", "cos", "tan"}
LONG_ANGLE = 60  # nodes
SHOWN = 50
NEAR = 3  # terms among which a bracket closes, unless it is at the end
FAR = 40  # terms before an end that is too far


@dataclass(frozen=True)
class Alternative:
    """Something that may stand in the place of a part.

    Attributes:
        tree: what stands there instead.
        kind: the edit, with places for what it is about.
        cost: the less likely the slip, the more.
        about: what it is about.
    """

    tree: Tree
    kind: str
    cost: float
    about: tuple[Tree, ...] = ()

    @property
    def words(self) -> str:
        """The edit in words."""
        return self.kind.format(*map(_shown, self.about))


@dataclass(frozen=True)
class Exchange:
    """Neighbouring terms or factors for which others may stand.

    Attributes:
        place: of the first.
        end: one past the place of the last.
        new: what stands there instead.
        kind, cost, about: as in `Alternative`.
    """

    place: int
    end: int
    new: tuple[Tree, ...]
    kind: str
    cost: float
    about: tuple[Tree, ...]

    def of(self, node: Sum | Product) -> Alternative:
        """The sum or product after the exchange."""
        parts = children(node)
        left = (*parts[: self.place], *self.new, *parts[self.end :])
        tree = left[0] if len(left) == 1 else with_children(node, left)
        return Alternative(tree, self.kind, self.cost, self.about or (tree,))


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
            yield from _without_root(tree)
            yield from _out_of_call(tree)
            yield from _undone(tree)
            yield from _in_call(tree, kinds)
        case Negation(operand):
            yield Alternative(operand, "the sign of {}", 1.0, (operand,))
            yield from _sign_of_sum(operand)
        case Number():
            yield from _known_constants(tree, kinds)
        case Power() | Product() | Quotient():
            yield from _of_an_operation(tree)
        case Sum():
            yield from _of_a_sum(tree)
        case _:
            return


def _known_constants(number: Number, kinds: Mapping[str, object]) -> Iterator[Alternative]:
    for right, tree in nearly(number, kinds):
        yield Alternative(tree, plain_words(f"{number.text} should be {right}"), 0.9)


def exchanges(node: Sum | Product) -> Iterator[Exchange]:
    """What may have been meant by neighbouring terms or factors."""
    if isinstance(node, Product):
        yield from _fewer(node.factors, "an extra factor: {}")
        return
    yield from _fewer(node.terms, "an extra term: {}")
    yield from _signs(node.terms)
    yield from _brackets_around(node.terms)


def exchanged(node: Tree) -> Iterator[Alternative]:
    """A sum or product after each of its exchanges."""
    if isinstance(node, Sum | Product):
        yield from (one.of(node) for one in exchanges(node))


def slips(node: Tree, kinds: Mapping[str, object]) -> Iterator[Alternative]:
    """What may have been meant by a part, each of its numbers and arguments included.

    Args:
        node: the part.
        kinds: the symbols allowed, and what makes them alike.
    """
    yield from alternatives(node, kinds)
    yield from exchanged(node)
    yield from other_numbers(node)
    yield from inside_function(node)
    if isinstance(node, Product):
        yield from _divided(node.factors)
    if isinstance(node, Power):
        yield Alternative(Power(node.base, Negation(node.exponent)), "the sign of the exponent of {}", 1.4, (node,))


def other_numbers(node: Tree) -> Iterator[Alternative]:
    """The numbers for which one may stand."""
    if isinstance(node, Number):
        for number in dict.fromkeys((node.value * 2, node.value / 2, node.value + 1, node.value - 1)):
            tree = number_tree(number)
            yield Alternative(tree, "{} should be {}", 1.1, (node, tree))


def inside_function(node: Tree) -> Iterator[Alternative]:
    """A half, a two or a sign that is missing in the argument of a function, or in an exponent."""
    if isinstance(node, Call) and len(node.arguments) == 1:
        inside = node.arguments[0]
    elif isinstance(node, Power):
        inside = node.exponent
    else:
        return
    if isinstance(inside, Number):
        return
    two = Number("2")
    for changed, words, cost in (
        (Negation(inside), "the sign of {}", 1.0),
        (Quotient(inside, two), "a missing factor 1/2 of {}", 1.2),
        (Product((two, inside)), "a missing factor 2 of {}", 1.2),
    ):
        edited = Power(node.base, changed) if isinstance(node, Power) else replace(node, arguments=(changed,))
        yield Alternative(edited, words, cost, (inside,))


def _of_an_operation(tree: Power | Product | Quotient) -> Iterator[Alternative]:
    match tree:
        case Power(base, exponent):
            yield Alternative(base, "{} without its exponent", 1.1, (tree,))
            yield from _into_call(base, exponent)
            yield from _power_of_part(base, exponent)
        case Product(factors):
            yield from _brackets_removed(factors)
            yield from _factor_into_call(factors)
        case Quotient(numerator, denominator):
            yield from _fractions(numerator, denominator)
            yield from _divisor_into_call(numerator, denominator)


@dataclass(frozen=True)
class Everywhere:
    """A slip that runs through a whole formula.

    Attributes:
        change: what it does to every part.
        words: the edit.
        cost: the less likely the slip, the more.
        values: what each changed symbol is worth instead at a point, when symbols are all that changes.
    """

    change: Callable[[Tree], Tree]
    words: str
    cost: float
    values: Mapping[str, Callable[[Mapping[str, float]], float]] | None = None


def everywhere(used: Mapping[str, int], kinds: Mapping[str, object]) -> Iterator[Everywhere]:
    """Slips that run through a formula in these symbols.

    Args:
        used: how often each of them occurs; what occurs once is changed by an edit of that place.
        kinds: the symbols allowed, and what makes them alike.
    """
    for first, second in (("sin", "cos"), ("sinh", "cosh")):
        yield Everywhere(_swap_functions(first, second), f"{first} and {second} swapped everywhere", 1.8)
    for name, count in used.items():
        for other in sorted(kinds):
            alike = kinds[other] == kinds.get(name)
            both = {name: _like(other), other: _like(name)}
            if other != name and (alike or (other in used and name < other)):
                cost = 1.8 if alike else 2.2
                yield Everywhere(_swap_names(name, other), f"{name} and {other} swapped", cost, both)
            if other != name and alike and count > 1:
                put = {name: _like(other)}
                yield Everywhere(_put(name, Name(other)), f"{name} should be {other} everywhere", 1.9, put)
        if count > 1:
            yield from _to_all(name)


def _to_all(name: str) -> Iterator[Everywhere]:
    """Another sign or power of a symbol wherever it stands."""
    yield Everywhere(_put(name, Negation(Name(name))), f"the sign of {name} everywhere", 1.9, {name: _power(name, -1)})
    squared = Power(Name(name), Number("2"))
    yield Everywhere(_put(name, squared), f"{name} should be {name}**2 everywhere", 2.0, {name: _power(name, 2)})
    yield Everywhere(_root_of(name), f"{name}**2 should be {name} everywhere", 2.0)


def _like(other: str) -> Callable[[Mapping[str, float]], float]:
    return lambda values: values[other]


def _power(name: str, power: int) -> Callable[[Mapping[str, float]], float]:
    """The square for 2, the negative for -1."""
    return lambda values: -values[name] if power < 0 else values[name] ** power


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
                yield Alternative(call, f"{function} should be {other}: {{}}", 1.0, (call,))


def _powers(tree: Tree) -> Iterator[Alternative]:
    for exponent in ("2", "3", "4"):
        power = Power(tree, Number(exponent))
        yield Alternative(power, "{} should be {}", 1.1, (tree, power))


def _of_a_sum(tree: Sum) -> Iterator[Alternative]:
    """Its bracket may have lost a root or an exponent."""
    root, square = Call("sqrt", (tree,)), Power(tree, Number("2"))
    yield Alternative(root, "a missing root: {}", 1.3, (root,))
    yield Alternative(square, "a missing square: {}", 1.3, (square,))
    yield from _brackets_of_fraction(tree.terms)


def _brackets_of_fraction(terms: tuple[Tree, ...]) -> Iterator[Alternative]:
    """a + b/c + d may have been (a + b)/(c + d): both brackets of a fraction are lost in one line."""
    for place, term in enumerate(terms[1:-1], 1):
        bare = term.operand if isinstance(term, Negation) else term
        if isinstance(bare, Quotient):
            last = Negation(bare.numerator) if isinstance(term, Negation) else bare.numerator
            yield _bracket(Quotient(Sum((*terms[:place], last)), _sum(bare.denominator, terms[place + 1 :])))


def _without_root(call: Call) -> Iterator[Alternative]:
    if call.function == "sqrt":
        yield Alternative(call.arguments[0], "an extra root: {}", 1.3, (call,))


def undoes(tree: Tree) -> bool:
    """Whether a function is taken of its inverse, or the inverse of it: tan(atan(x)), atan(tan(x))."""
    if not isinstance(tree, Call) or len(tree.arguments) != 1:
        return False
    inner = tree.arguments[0]
    return isinstance(inner, Call) and len(inner.arguments) == 1 and {tree.function, inner.function} in INVERSES


def _undone(call: Call) -> Iterator[Alternative]:
    """The angle itself, for which an inverse tangent of its tangent is one of a half circle only."""
    if undoes(call) and isinstance(inner := call.arguments[0], Call):
        angle = inner.arguments[0]
        yield Alternative(angle, "{} should be {}", 1.0, (call, angle))


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
    yield Alternative(outside, "a bracket: {}", 1.3, (outside,))


def _in_call(call: Call, kinds: Mapping[str, object]) -> Iterator[Alternative]:
    """Another angle: from the sine that is wanted it does not follow."""
    inside = list(walk(call.arguments[0])) if call.function in PERIODIC else []
    # Of functions of functions all edits would be taken as often as they are nested, of a long sum each with all of it.
    if len(inside) > LONG_ANGLE or any(isinstance(node, Call) for _, node in inside):
        return
    for path, node in inside:
        for edit in (*alternatives(node, kinds), *exchanged(node), *other_numbers(node)):
            yield replace(edit, tree=replace_at(call, (0, *path), edit.tree))


def _into_call(base: Tree, exponent: Tree) -> Iterator[Alternative]:
    if isinstance(base, Call) and len(base.arguments) == 1:
        inside = replace(base, arguments=(Power(base.arguments[0], exponent),))
        yield Alternative(inside, "a bracket: {}", 1.3, (inside,))


def _divisor_into_call(numerator: Tree, denominator: Tree) -> Iterator[Alternative]:
    """exp(a)/2 for exp(a/2)."""
    if (argument := _argument_of(numerator)) is not None:
        inside = _with_argument(numerator, Quotient(argument, denominator))
        yield Alternative(inside, "a bracket: {}", 1.3, (inside,))


def _factor_into_call(factors: tuple[Tree, ...]) -> Iterator[Alternative]:
    """2*sin(a) for sin(2*a)."""
    if len(factors) == 2 and isinstance(factors[0], Number) and (argument := _argument_of(factors[1])) is not None:
        inside = _with_argument(factors[1], Product((factors[0], argument)))
        yield Alternative(inside, "a bracket: {}", 1.3, (inside,))


def _argument_of(tree: Tree) -> Tree | None:
    """What a function of one argument is taken of, or the exponent of a power."""
    match tree:
        case Call(_, (argument,)):
            return argument
        case Power(_, exponent) if not isinstance(exponent, Number):
            return exponent
        case _:
            return None


def _with_argument(tree: Tree, argument: Tree) -> Tree:
    return Power(tree.base, argument) if isinstance(tree, Power) else with_children(tree, (argument,))


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
    return Alternative(tree, "a bracket: {}", 1.4, (tree,))


def _divided(factors: tuple[Tree, ...]) -> Iterator[Alternative]:
    """The product with one factor below."""
    for place, factor in enumerate(factors):
        rest = (*factors[:place], *factors[place + 1 :])
        above = rest[0] if len(rest) == 1 else Product(rest)
        yield Alternative(Quotient(above, factor), "{} below, not above", 1.4, (factor,))


def _fewer(parts: tuple[Tree, ...], kind: str) -> Iterator[Exchange]:
    for place, part in enumerate(parts):
        yield Exchange(place, place + 1, (), kind, 1.1, (part,))


def _signs(terms: tuple[Tree, ...]) -> Iterator[Exchange]:
    for place, term in enumerate(terms):
        bare = term.operand if isinstance(term, Negation) else term
        other = bare if isinstance(term, Negation) else Negation(term)
        cost = (
            1.0 if place or isinstance(term, Negation) else 1.05
        )  # a sign is lost, not put before all that is printed
        yield Exchange(place, place + 1, (other,), "the sign of {}", cost, (bare,))


def _brackets_around(terms: tuple[Tree, ...]) -> Iterator[Exchange]:
    """a*b + c may have been a*(b + c), and a/b + c may have been a/(b + c) or (a + c)/b."""
    for place, term in enumerate(terms[:-1]):
        for end in _ends(place + 2, len(terms)):
            for inner in _swallowed(term, terms[place + 1 : end]):
                yield Exchange(place, end, (inner,), "a bracket: {}", 1.4, ())


def _swallowed(term: Tree, rest: tuple[Tree, ...]) -> Iterator[Tree]:
    match term:
        case Product(factors):
            yield Product((*factors[:-1], _sum(factors[-1], rest)))
            yield from (Product((*factors[:-1], root)) for root in _under_root(factors[-1], rest))
        case Quotient(numerator, denominator):
            yield Quotient(numerator, _sum(denominator, rest))
            yield from (Quotient(numerator, root) for root in _under_root(denominator, rest))
            yield Quotient(_sum(numerator, rest), denominator)
        case Call():
            yield from _under_root(term, rest)
        case Negation(operand):
            yield Negation(_sum(operand, rest))
            for inner in _swallowed(operand, rest):
                yield Negation(inner)
        case _:
            return


def _under_root(term: Tree, rest: tuple[Tree, ...]) -> Iterator[Tree]:
    """A root whose line reached farther: of sqrt(1) - u**2, as text without the line has it."""
    if isinstance(term, Call) and term.function == "sqrt":
        yield Call("sqrt", (_sum(term.arguments[0], rest),))


def _ends(first: int, last: int) -> list[int]:
    """Where a misplaced bracket may close: soon, or at the very end where that is not far."""
    near = range(first, min(first + NEAR, last + 1))
    return [*near, last] if near.stop <= last < first + FAR else [*near]


def _sum(first: Tree, rest: tuple[Tree, ...]) -> Sum:
    return Sum((*(first.terms if isinstance(first, Sum) else (first,)), *rest))


def _brackets_removed(factors: tuple[Tree, ...]) -> Iterator[Alternative]:
    """a*(b + c) may have been a*b + c."""
    for place, factor in enumerate(factors):
        if not isinstance(factor, Sum):
            continue
        others = (*factors[:place], *factors[place + 1 :])
        for end in _ends(1, len(factor.terms) - 1):
            kept = factor.terms[0] if end == 1 else Sum(factor.terms[:end])
            yield _bracket(Sum((Product((*others, kept)), *factor.terms[end:])))
        for out, term in enumerate(factor.terms[:-1]):
            rest = (*factor.terms[:out], *factor.terms[out + 1 :])
            yield _bracket(Sum((Product((*others, rest[0] if len(rest) == 1 else Sum(rest))), term)))


def _fractions(numerator: Tree, denominator: Tree) -> Iterator[Alternative]:
    yield Alternative(Quotient(denominator, numerator), "the fraction upside down: {} above", 1.4, (denominator,))
    yield Alternative(numerator, "an extra divisor: {}", 1.2, (denominator,))
    yield from _number_upside_down(numerator, denominator)
    yield Alternative(Product((numerator, denominator)), "a product, not a fraction: {}", 1.3, (denominator,))
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
                yield Alternative(Quotient(above, below), "{} above, not below", 1.4, (factor,))
        case _:
            pass


def _number_upside_down(numerator: Tree, denominator: Tree) -> Iterator[Alternative]:
    """6*x/5 for 5*x/6."""
    match numerator, denominator:
        case Product((Number() as above, *rest)), Number() as below:
            tree = Quotient(Product((below, *rest)), above)
            yield Alternative(tree, "the fraction upside down: {}/{}", 1.3, (below, above))
        case _:
            return


def _sign_of_sum(operand: Tree) -> Iterator[Alternative]:
    if isinstance(operand, Sum):
        yield _bracket(Sum((Negation(operand.terms[0]), *operand.terms[1:])))


def _swap_functions(first: str, second: str) -> Callable[[Tree], Tree]:
    other = {first: second, second: first}
    return lambda node: (
        replace(node, function=other[node.function]) if isinstance(node, Call) and node.function in other else node
    )


def _swap_names(first: str, second: str) -> Callable[[Tree], Tree]:
    other = {first: second, second: first}
    return lambda node: Name(other[node.name]) if isinstance(node, Name) and node.name in other else node


def _put(name: str, tree: Tree) -> Callable[[Tree], Tree]:
    return lambda node: tree if isinstance(node, Name) and node.name == name else node


def _root_of(name: str) -> Callable[[Tree], Tree]:
    squared = Power(Name(name), Number("2"))
    return lambda node: Name(name) if node == squared else node


def plain_words(words: str) -> str:
    """Words that are no pattern to fill in."""
    return words.replace("{", "{{").replace("}", "}}")


def _shown(tree: Tree) -> str:
    text = to_text(tree)
    return text if len(text) <= SHOWN else f"{text[: SHOWN - 3]}..."
