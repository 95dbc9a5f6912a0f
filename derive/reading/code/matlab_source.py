"""Lines of MATLAB or Octave as a formula: arrays are counted from 1, and .* works entry by entry."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.limits import MAX_DEPTH
from radartrack.derive.formula.tree import Place, Tree
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.reading.code.code_functions import SEVERAL, applied, changed_coordinates, is_function, of_blocks
from radartrack.derive.reading.code.syntax_trees import Chain, field, first_error, named, parsed, text_of
from radartrack.derive.reading.code.workspace import Remark, Value, Workspace

if TYPE_CHECKING:
    from tree_sitter import Node

_NUMBER = re.compile(r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")
_CONTINUED = re.compile(r"\.\.\.[^\S\n]*\n")  # what stands behind the dots is gone with the comments
_ENTRYWISE = frozenset({".*"})
_PRODUCTS = frozenset({"*", ".*", "/", "./"})
_SKIPPED = frozenset({"comment", ";", ",", "\n", "line_continuation", "clear_statement"})
_COMMANDS = frozenset({"clc", "clear", "close", "clearvars", "format", "hold", "more", "warning"})  # of no effect here
_BRANCHED = (["block"], ["block", "else_clause"])
_UNREAD = {
    "if_statement": "formulas have no cases: give the lines of the branch that is meant",
    "switch_statement": "formulas have no cases: give the lines of the branch that is meant",
    "for_statement": "loops are not read: write the lines out",
    "while_statement": "loops are not read: write the lines out",
}


def read_matlab(text: str, space: Workspace, function: str = "") -> Value:
    """What MATLAB code computes.

    Args:
        text: an expression, a block of assignments, or functions.
        space: where names have values.
        function: the one to read, by its name.

    Raises:
        FormulaError: for what formulas do not have, and what is not MATLAB.
    """
    offset = 0
    text = _CONTINUED.sub(lambda found: " " * len(found.group()), text)
    root = parsed("matlab", text + "\n")
    if [node.type for node in named(root)] == ["command"]:  # x -1 is x with the option -1, unless in brackets
        offset = 1
        root = parsed("matlab", f"({text.rstrip().rstrip(';')}\n)\n")
    error = first_error(root)
    if error is not None:
        start = min(error.start_byte, len(text))
        raise FormulaError("this is not MATLAB", span=(start, min(max(error.end_byte, start), len(text))))
    return _MatlabReader(space, offset).file(root, function)


class _MatlabReader:
    def __init__(self, space: Workspace, offset: int) -> None:
        self._space = space
        self._offset = offset
        self._chain = Chain(space)
        self._depth = 0

    def file(self, root: Node, function: str) -> Value:
        """What the block, or the function that is meant, computes."""
        functions = [node for node in root.children if node.type == "function_definition"]
        chosen = [node for node in functions if not function or text_of(field(node, "name")) == function]
        if function and not chosen:
            raise FormulaError(f"there is no function {function} here")
        others = [node for node in root.children if node.type not in _SKIPPED | {"function_definition"}]
        if not chosen or (others and not function):
            return self._space.result(self._block(root.children))
        body = [part for node in chosen[-1].children if node.type == "block" for part in node.children]
        self._block(body)
        output = next((node for node in chosen[-1].children if node.type == "function_output"), None)
        if output is None:
            return self._space.result()
        first = output.children[0]
        outputs = named(first) if first.type == "multioutput_variable" else [first]
        computed = [one for one in outputs if self._space.is_defined(text_of(one))]
        if outputs[0] not in computed:
            raise FormulaError(f"{text_of(outputs[0])} is not computed here", span=self._span(outputs[0]))
        values = [self._space.name(text_of(one), self._span(one)) for one in computed]
        return self._space.fitting(values) or values[0]

    def _block(self, statements: Sequence[Node]) -> Value | None:
        last: Value | None = None
        for node in self._taken(statements):
            if node.type in _SKIPPED | {"function_definition"} or self._is_idle(node):
                continue
            if node.type == "assignment":
                self._assign(node)
                last = None
            elif node.type in _UNREAD:
                raise FormulaError(_UNREAD[node.type], span=self._span(node))
            else:
                last = self.value(node)
        return last

    def _taken(self, statements: Sequence[Node]) -> Iterator[Node]:
        """The statements, with those of a branch for it where the other one only keeps from dividing by zero."""
        for node in statements:
            blocks = [part for part in named(node) if part.type in {"block", "else_clause", "elseif_clause"}]
            is_first = None
            if node.type == "if_statement" and [part.type for part in blocks][:3] in _BRANCHED:
                both = text_of(blocks[0]), text_of(blocks[1]) if len(blocks) > 1 else ""
                is_first = self._space.branch(text_of(field(node, "condition")).strip(), both, self._span(node))
            if is_first is None:
                yield node
            elif is_first or len(blocks) > 1:
                chosen = blocks[0] if is_first else next(part for part in named(blocks[1]) if part.type == "block")
                yield from self._taken(chosen.children)

    def _is_idle(self, node: Node) -> bool:
        return node.type == "command" and text_of(node).split()[0] in _COMMANDS

    def _assign(self, node: Node) -> None:
        left = field(node, "left")
        right = field(node, "right")
        if right.type == "lambda":  # f = @(x) ...
            right = field(right, "expression")
        if left.type == "multioutput_variable":
            self._assign_several(left, right)
            return
        self._call_entry(left, right)
        value = self.value(right)
        if left.type == "function_call":
            places = [self._place(one) for one in self._arguments(left)]
            self._space.assign_entry(text_of(field(left, "name")), places, value, self._span(left))
        elif name := self._name(left):
            self._space.assign(name, value)
        else:
            raise FormulaError("this cannot be assigned to", span=self._span(left))

    def _call_entry(self, left: Node, right: Node) -> None:
        """px = state(1): what is an entry has the name."""
        if left.type != "identifier" or right.type != "function_call" or is_function(text_of(field(right, "name"))):
            return
        inside = self._arguments(right)
        if all(text_of(one).isdigit() for one in inside):
            places = [self._place(one) for one in inside]
            self._space.call_entry(text_of(left), text_of(field(right, "name")), places)

    def _assign_several(self, left: Node, right: Node) -> None:
        """[x, y] = pol2cart(th, r) and its kin."""
        function = text_of(field(right, "name")) if right.type == "function_call" else ""
        arguments = [self.value(one) for one in self._arguments(right)] if function in SEVERAL else []
        if function not in SEVERAL:
            raise FormulaError("a function that returns several values is not read here", span=self._span(right))
        for target, value in zip(
            named(left), changed_coordinates(self._space, function, arguments, self._span(right)), strict=False
        ):
            if target.type == "identifier":  # a ~ drops one
                self._space.assign(text_of(target), value)

    def _name(self, node: Node) -> str:
        """A name, or that of a field: plot.x is plot_x."""
        if node.type == "field_expression":
            parts = [text_of(part) for part in named(node)]
            return "_".join(parts) if all(part.isidentifier() for part in parts) else ""
        return text_of(node) if node.type == "identifier" else ""

    def value(self, node: Node) -> Value:
        """What an expression is worth."""
        self._depth += 1
        if self._depth > MAX_DEPTH:
            raise FormulaError(f"the formula is nested more than {MAX_DEPTH} deep", span=self._span(node))
        try:
            return self._value(node)
        except FormulaError as error:
            raise FormulaError(error.message, span=error.span or self._span(node)) from None
        finally:
            self._depth -= 1

    def _value(self, node: Node) -> Value:
        span = self._span(node)
        match node.type:
            case "number":
                if not _NUMBER.fullmatch(text_of(node)):
                    raise FormulaError(f"{text_of(node)[:40]} is no decimal number", span=span)
                return self._space.number(text_of(node), span)
            case "identifier" | "field_expression":
                return self._space.name(self._name(node), span)
            case "parenthesis":
                return self.value(_only(node))
            case "unary_operator":
                operand = self.value(field(node, "operand"))
                return self._space.negated(operand, span) if text_of(node).startswith("-") else operand
            case "postfix_operator":
                return self._transposed(self.value(field(node, "operand")), span)
            case "binary_operator":
                return self._operation(node, span)
            case "matrix":
                return self._matrix(node, span)
            case "function_call":
                return self._call(node, span)
            case _:
                raise FormulaError(f"{node.type.replace('_', ' ')} has no place in a formula", span=span)

    def _operation(self, node: Node, span: Span) -> Value:
        sign = _sign(node)
        if sign in {"+", "-"}:
            return self._chain.sum(self._parts(node, frozenset({"+", "-"})), span)
        if sign in _PRODUCTS:
            return self._chain.product(self._parts(node, _PRODUCTS), span, entrywise=_ENTRYWISE)
        if sign in {"^", ".^"}:
            return self._power(node, sign, span)
        left, right = self.value(field(node, "left")), self.value(field(node, "right"))
        if sign == "\\":
            return self._space.product([self._space.call("inv", [left], span), right], span)
        raise FormulaError(f"{sign} has no place in a formula", span=span)

    def _power(self, node: Node, sign: str, span: Span) -> Value:
        """A power, which binds tighter than a sign before it, whatever the syntax tree says: -x^2 is -(x^2)."""
        base, is_negative = field(node, "left"), False
        while base.type == "unary_operator":
            is_negative ^= text_of(base).startswith("-")
            base = field(base, "operand")
        value = self.value(base)
        for exponent in self._exponents(field(node, "right")):
            value = self._space.power(value, self.value(exponent), span, of_entries=sign == ".^")
        return self._space.negated(value, span) if is_negative else value

    def _exponents(self, node: Node) -> list[Node]:
        """Exponents behind each other, taken from the left in MATLAB: a^b^c is (a^b)^c."""
        if node.type == "unary_operator" and _is_power(field(node, "operand")):
            raise FormulaError("put the exponent in brackets", span=self._span(node))
        found: list[Node] = []
        while _is_power(node):
            found.append(field(node, "left"))
            self._space.remarks.append(
                Remark(self._span(node), "a^b^c is (a^b)^c in MATLAB, and a^(b^c) in mathematics")
            )
            node = field(node, "right")
        return [*found, node]

    def _parts(self, node: Node, signs: frozenset[str]) -> list[tuple[str, Value, Span]]:
        """The operands of a chain with the sign before each; the first one has the first sign."""
        found: list[tuple[str, Value, Span]] = []
        while node.type == "binary_operator" and (sign := _sign(node)) in signs:
            right = field(node, "right")
            found.append((sign, self.value(right), self._span(right)))
            node = field(node, "left")
        return [("+" if "+" in signs else "*", self.value(node), self._span(node)), *reversed(found)]

    def _matrix(self, node: Node, span: Span) -> Value:
        """Rows; one row, and one column, are a vector; of arrays, the matrix that they make side by side."""
        rows = [[self.value(entry) for entry in named(row)] for row in named(node)]
        parts = [entry for row in rows for entry in row]
        if any(entry.shape for entry in parts):
            return of_blocks(self._space, [[self._block_of(entry, span) for entry in row] for row in rows], parts, span)
        if len(rows) == 1:
            return replace(self._space.array(rows[0], span), is_row=True)
        if all(len(row) == 1 for row in rows):
            return self._space.array([row[0] for row in rows], span)
        made = [self._space.array(row, self._span(one)) for row, one in zip(rows, named(node), strict=True)]
        return self._space.array(made, span)

    def _block_of(self, value: Value, span: Span) -> Tensor[Tree]:
        """The entries of a part of a matrix; a vector that lies is a row."""
        entries = self._space.opened(value, span)
        return Tensor((1, *entries.shape), entries.entries) if value.is_row else entries

    def _transposed(self, value: Value, span: Span) -> Value:
        """A transpose; a vector lies then where it stood, which makes a difference inside a product only."""
        if value.shape is not None and len(value.shape) == 1:
            return replace(value, is_row=not value.is_row)
        return self._space.call("transpose", [value], span)

    def _call(self, node: Node, span: Span) -> Value:
        name = text_of(field(node, "name"))
        arguments = self._arguments(node)
        if self._space.is_defined(name) or not is_function(name):
            places = [self._place(one) for one in arguments]
            found = self._space.entry(name, places, span)
            is_row = len(places) > 1 and isinstance(places[0], int) and not isinstance(places[1], int)
            return replace(found, is_row=True) if is_row else found  # A(1, :)
        return applied(self._space, name, [self.value(one) for one in arguments], span)

    def _arguments(self, node: Node) -> list[Node]:
        return [part for child in named(node) if child.type == "arguments" for part in named(child)]

    def _place(self, node: Node) -> Place:
        if node.type == "spread_operator":
            return None, None
        if node.type == "range":
            ends = named(node)
            if len(ends) == 2:
                return self._whole(ends[0]), self._whole(ends[1])
        return self._whole(node)

    def _whole(self, node: Node) -> int:
        text = text_of(node)
        if not text.isdigit() or len(text) > 3:
            name = text_of(field(node.parent.parent, "name")) if node.parent and node.parent.parent else ""
            raise FormulaError(
                f"{name} is no function here, and an entry is picked by a whole number", span=self._span(node)
            )
        return int(text)

    def _span(self, node: Node) -> Span:
        return max(node.start_byte - self._offset, 0), max(node.end_byte - self._offset, 0)


def _is_power(node: Node) -> bool:
    return node.type == "binary_operator" and _sign(node) in {"^", ".^"}


def _sign(node: Node) -> str:
    """The operator between two operands."""
    return next(text_of(child) for child in node.children if not child.is_named)


def _only(node: Node) -> Node:
    parts = named(node)
    if not parts:
        raise FormulaError("a value is missing here")
    return parts[0]
