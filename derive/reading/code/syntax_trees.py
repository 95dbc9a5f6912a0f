"""Syntax trees of C, C++ and MATLAB, made by tree-sitter."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.reading.code.workspace import Value, Workspace

if TYPE_CHECKING:
    from tree_sitter import Node, Parser

_GRAMMARS = {"c": "tree_sitter_c", "cpp": "tree_sitter_cpp", "matlab": "tree_sitter_matlab"}


def parsed(language: str, source: str) -> Node:
    """The root of the syntax tree; errors are nodes in it.

    Raises:
        FormulaError: when the parsers are not installed.
    """
    return _parser(language).parse(source.encode("ascii")).root_node


@cache
def _parser(language: str) -> Parser:
    try:
        from tree_sitter import Language, Parser  # noqa: PLC0415 - it is optional

        return Parser(Language(import_module(_GRAMMARS[language]).language()))
    except ImportError:
        raise FormulaError(
            f"code in {language} is read with tree-sitter: python -m pip install 'radartrack[code]'"
        ) from None


def first_error(root: Node) -> Node | None:
    """The first place that is not of the language."""
    return next((node for node in _walk(root) if node.is_error or node.is_missing), None)


def _walk(root: Node) -> Iterator[Node]:
    """Nodes with errors below, before what is in them; nothing recurses."""
    waiting = [root]
    while waiting:
        node = waiting.pop()
        yield node
        waiting.extend(reversed([child for child in node.children if child.has_error or child.is_missing]))


def text_of(node: Node) -> str:
    """What a node says."""
    return (node.text or b"").decode("ascii")


def named(node: Node) -> list[Node]:
    """The parts of a node that are no signs and no comments."""
    return [child for child in node.named_children if child.type != "comment"]


def field(node: Node, name: str) -> Node:
    """A part of a node that it must have.

    Raises:
        FormulaError: when it does not.
    """
    found = node.child_by_field_name(name)
    if found is None:
        raise FormulaError("this is not read", span=(node.start_byte, node.end_byte))
    return found


class Chain:
    """Sums and products of a syntax tree, however long: they hang on each other's left.

    Args:
        space: where values are made.
    """

    def __init__(self, space: Workspace) -> None:
        self._space = space

    def sum(self, parts: list[tuple[str, Value, Span]], span: Span) -> Value:
        """Values with + or - before them."""
        terms = [self._space.negated(value, where) if sign == "-" else value for sign, value, where in parts]
        return self._space.sum(terms, span)

    def product(self, parts: list[tuple[str, Value, Span]], span: Span, *, entrywise: frozenset[str]) -> Value:
        """Values with a sign of multiplication or division before them; which signs work entry by entry."""
        factors: list[Value] = []
        for sign, value, where in parts:
            here = (span[0], where[1])
            if sign.endswith("/"):
                factors = [self._space.quotient(self._joined(factors, here), value, here)]
            elif sign in entrywise and self._space.both_arrays(factors, value):
                factors = [self._space.product([self._joined(factors, here), value], here, of_entries=True)]
            else:
                factors.append(value)
        return self._joined(factors, span)

    def _joined(self, factors: list[Value], span: Span) -> Value:
        return factors[0] if len(factors) == 1 else self._space.product(factors, span)
