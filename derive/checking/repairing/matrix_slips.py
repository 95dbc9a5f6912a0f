"""The slips that print is prone to in products of matrices: a transpose, an inverse or a factor lost, or misplaced."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import pairwise

from radartrack.derive.checking.repairing.print_slips import Alternative
from radartrack.derive.formula.shape import Shape
from radartrack.derive.formula.tree import Array, Call, Name, Product, Sum, Tree

ShapeOf = Callable[[Tree], Shape]


def matrix_slips(node: Tree, arrays: Mapping[str, Shape], shape: ShapeOf) -> Iterator[Alternative]:
    """What may have been meant by an array, or by a sum or a product of arrays.

    Args:
        node: the part.
        arrays: the names that stand for arrays, any of which may be missing.
        shape: of a part.
    """
    found = shape(node)
    if not found:
        return
    yield from _of_node(node, arrays, shape)
    if len(found) == 2 and not isinstance(node, Array) and not _is_turned(node):
        yield Alternative(Call("transpose", (node,)), "a missing transpose: {}", 1.0, (node,))
        if found[0] == found[1]:
            yield Alternative(Call("inv", (node,)), "a missing inverse: {}", 1.2, (node,))
    if not isinstance(node, Product | Sum):
        yield from _longer((node,), arrays)


def _of_node(node: Tree, arrays: Mapping[str, Shape], shape: ShapeOf) -> Iterator[Alternative]:
    match node:
        case Name(name):
            alike = (other for other in sorted(arrays) if other != name and arrays[other] == shape(node))
            yield from (Alternative(Name(other), f"{name} should be {other}", 1.0) for other in alike)
        case Call("transpose", (inner,)):
            yield Alternative(inner, "an extra transpose: {}", 1.0, (node,))
            yield from _turned_for_inverted(node, Call("inv", (inner,)))
        case Call("inv", (inner,)):
            yield Alternative(inner, "an extra inverse: {}", 1.1, (node,))
            yield from _turned_for_inverted(node, Call("transpose", (inner,)))
        case Product(factors):
            yield from _turned(factors)
            yield from _reordered(factors, shape)
            yield from _longer(factors, arrays)
        case Sum(terms):
            for name in sorted(one for one, own in arrays.items() if own == shape(node)):
                yield Alternative(Sum((*terms, Name(name))), f"a missing term {name}", 1.3)
        case _:
            return


def _turned_for_inverted(node: Tree, other: Tree) -> Iterator[Alternative]:
    yield Alternative(other, "{} should be {}", 1.1, (node, other))


def _is_turned(node: Tree) -> bool:
    return isinstance(node, Call) and node.function == "transpose"


def _turned(factors: tuple[Tree, ...]) -> Iterator[Alternative]:
    """The product with one of the matrices that are written out in it transposed."""
    for place, factor in enumerate(factors):
        if isinstance(factor, Array) and isinstance(factor.entries[0], Array):
            turned = (*factors[:place], _transposed(factor), *factors[place + 1 :])
            yield Alternative(Product(turned), "a missing transpose: {}", 1.0, (factor,))


def _reordered(factors: tuple[Tree, ...], shape: ShapeOf) -> Iterator[Alternative]:
    """The product with two of its arrays exchanged, or with the transpose on the other side: J.T*K*J for J*K*J.T."""
    places = [place for place, factor in enumerate(factors) if shape(factor)]
    for first, second in [*pairwise(places), *([(places[0], places[-1])] if places[2:] else [])]:
        changed = list(factors)
        changed[first], changed[second] = factors[second], factors[first]
        tree = Product(tuple(changed))
        yield Alternative(tree, "the order of the factors: {}", 1.0, (tree,))


def _longer(factors: tuple[Tree, ...], arrays: Mapping[str, Shape]) -> Iterator[Alternative]:
    """The product with an array more: the other end of a sandwich, which is likelier, or any other."""
    ends = ((len(factors), _transposed(factors[0])), (0, _transposed(factors[-1])))
    for place, end in ends if factors[0] != _transposed(factors[-1]) else ():
        yield Alternative(_put(factors, place, end), "a missing factor {}", 1.2, (end,))
    for name in sorted(arrays):
        array = Name(name)
        for more in (array, _transposed(array), Call("inv", (array,))):
            for place in range(len(factors) + 1):
                yield Alternative(_put(factors, place, more), "a missing factor {}", 1.3, (more,))


def _transposed(tree: Tree) -> Tree:
    return tree.arguments[0] if isinstance(tree, Call) and tree.function == "transpose" else Call("transpose", (tree,))


def _put(factors: tuple[Tree, ...], place: int, new: Tree) -> Product:
    return Product((*factors[:place], new, *factors[place:]))
