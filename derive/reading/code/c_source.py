"""Lines of C and C++ as a formula, with their arithmetic: 3/2 is 1, and ^ is no power."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.limits import MAX_DEPTH
from radartrack.derive.formula.tree import Place
from radartrack.derive.reading.code.code_functions import applied, is_function
from radartrack.derive.reading.code.matrix_classes import class_sizes, is_matrix_class, laid_out
from radartrack.derive.reading.code.syntax_trees import Chain, field, first_error, named, parsed, text_of
from radartrack.derive.reading.code.workspace import Value, Workspace

if TYPE_CHECKING:
    from tree_sitter import Node

_EXPRESSION = "void f(){return (", "\n);}"
_BLOCK = "void f(){", "\n;}"
_FILE = "", "\n"
_RETURN = re.compile(r"\s*return\b")
_NUMBER = re.compile(r"(?P<digits>\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)(?P<suffix>[fFlLuU]*)")
_WHOLE_TYPES = frozenset(
    ("int", "long", "short", "unsigned", "size_t", "char", "bool", "int32_t", "int64_t", "uint32_t", "uint64_t")
)
_OF_A_TYPE = {"Identity": "1", "Zero": "0"}  # what stands on the diagonal
_SETTING = {"setIdentity": "1", "setZero": "0"}
_UNREAD_OPERATORS = {
    "^": "^ is exclusive or in {language}, and a power in mathematics: write pow(x, n) for the power",
    "%": "% is a remainder in {language}, which formulas do not have",
}
_UNREAD = {
    "conditional_expression": "formulas have no cases: give the branch that is meant",
    "if_statement": "formulas have no cases: give the lines of the branch that is meant",
    "switch_statement": "formulas have no cases: give the lines of the branch that is meant",
    "for_statement": "loops are not read: write the lines out",
    "for_range_loop": "loops are not read: write the lines out",
    "while_statement": "loops are not read: write the lines out",
    "do_statement": "loops are not read: write the lines out",
    "update_expression": "++ and -- have no place in a formula",
}
_SKIPPED = frozenset(
    {"comment", "preproc_include", "using_declaration", ";", "preproc_def", "type_definition", "{", "}"}
)


def read_c(text: str, language: str, space: Workspace, function: str = "") -> Value:
    """What C or C++ code computes.

    Args:
        text: an expression, a block of assignments, or functions.
        language: `c` or `cpp`.
        space: where names have values.
        function: the one to read, by its name.

    Raises:
        FormulaError: for what formulas do not have, and what is not of the language.
    """
    statement = text.rstrip().removesuffix(";")
    fault: Span | None = None
    forms = (_EXPRESSION, _BLOCK, _FILE) if not _RETURN.match(text) else (_BLOCK,)  # return (x)*y would be a call
    for before, after in (_FILE,) if function else forms:
        root = parsed(language, before + (statement if before == _EXPRESSION[0] else text) + after)
        error = first_error(root)
        if error is not None:
            fault = fault if fault and not before else _shifted(error, len(before), len(text))
        elif before != _EXPRESSION[0] or _is_expression(root):
            chosen = _function(root, function)
            if before == _BLOCK[0] and _has_functions(chosen):
                continue  # C lets them stand in functions
            reader = _CReader(space, len(before))
            return reader.block(root.children) if chosen is None else reader.function(chosen)
    raise FormulaError(f"this is not {space.language}", span=fault)


def _has_functions(function: Node | None) -> bool:
    inside = function.child_by_field_name("body") if function is not None else None
    return inside is not None and any(node.type == "function_definition" for node in inside.children)


def _is_expression(root: Node) -> bool:
    """Whether what was put into a return is a value, not an assignment or a list of values."""
    inside = next(node for node in field(root.children[0], "body").children if node.type == "return_statement")
    value = _only(_only(inside))
    is_filled = value.type == "binary_expression" and text_of(field(value, "operator")) == "<<"
    return not is_filled and value.type not in {"assignment_expression", "comma_expression"}


def _shifted(node: Node, offset: int, length: int) -> Span:
    start = min(max(node.start_byte - offset, 0), length)
    return start, min(max(node.end_byte - offset, start), length)


def _function(root: Node, name: str) -> Node | None:
    """The function that is meant, or the last one.

    Raises:
        FormulaError: when there is none of this name.
    """
    functions = [node for node in _functions(root) if not name or _name_of(node) == name]
    if name and not functions:
        raise FormulaError(f"there is no function {name} here")
    return functions[-1] if functions else None


def _functions(root: Node) -> Iterator[Node]:
    """Functions, also those in classes and namespaces."""
    waiting = list(reversed(root.children))
    while waiting:
        node = waiting.pop()
        if node.type == "function_definition":
            yield node
        else:
            waiting.extend(reversed(node.children))


def _name_of(function: Node) -> str:
    """The name of a function, without class and namespace."""
    node: Node | None = function
    while node is not None and node.child_by_field_name("declarator") is not None:
        node = node.child_by_field_name("declarator")
    return text_of(node).rsplit("::", 1)[-1] if node else ""


class _CReader:
    def __init__(self, space: Workspace, offset: int) -> None:
        self._space = space
        self._offset = offset
        self._chain = Chain(space)
        self._depth = 0
        self._types: dict[str, str] = {}

    def function(self, node: Node) -> Value:
        """What a function returns."""
        declarator = node
        while (inner := declarator.child_by_field_name("declarator")) is not None:
            declarator = inner
            parameters = declarator.child_by_field_name("parameters")
            for one in named(parameters) if parameters is not None else ():
                name = one.child_by_field_name("declarator")
                if name is not None and name.type == "identifier":
                    self._types[text_of(name)] = text_of(field(one, "type"))
        return self.block(field(node, "body").children)

    def block(self, statements: Sequence[Node]) -> Value:
        """What the statements compute."""
        last: Value | None = None
        for node in self._taken(statements):
            match node.type:
                case "return_statement":
                    return self.value(_only(node))
                case "declaration":
                    self._declare(node)
                    last = None
                case "expression_statement":
                    last = self._statement(node)
                case _ if node.type not in _SKIPPED:
                    raise FormulaError(self._unread(node), span=self._span(node))
        return self._space.result(last)

    def _taken(self, statements: Sequence[Node]) -> Iterator[Node]:
        """The statements, with those of a branch for it where the other one only keeps from dividing by zero."""
        for node in statements:
            is_first = self._branch(node) if node.type == "if_statement" else None
            if is_first is None:
                yield node
                continue
            chosen = node.child_by_field_name("consequence" if is_first else "alternative")
            if chosen is not None and chosen.type == "else_clause":
                chosen = _only(chosen)
            if chosen is not None:
                yield from self._taken(chosen.children if chosen.type == "compound_statement" else [chosen])

    def _branch(self, node: Node) -> bool | None:
        condition = text_of(field(node, "condition"))
        is_whole = condition.startswith("(") and condition.endswith(")")
        other = node.child_by_field_name("alternative")
        branches = text_of(field(node, "consequence")), text_of(other) if other is not None else ""
        return self._space.branch(condition[1:-1] if is_whole else condition, branches, self._span(node))

    def _statement(self, node: Node) -> Value | None:
        parts = named(node)
        if not parts:
            return None
        if parts[0].type == "assignment_expression":
            self._assign(parts[0])
            return None
        if parts[0].type in {"comma_expression", "binary_expression"} and "<<" in text_of(parts[0]):
            self._fill(parts[0])
            return None
        return self.value(parts[0])

    def _declare(self, node: Node) -> None:
        kind = text_of(field(node, "type"))
        for declarator in node.children_by_field_name("declarator"):
            name, sizes = self._declared(declarator)
            value = _made_as(declarator.child_by_field_name("value"))
            self._types[name] = kind
            if value is None or value.type == "argument_list":
                sizes = sizes or class_sizes(kind) or self._constructed(value)
                if value is not None and is_matrix_class(kind) and not _are_places(named(value)):
                    self._space.assign(name, self._laid(named(value), sizes, name, self._span(value)))
                elif sizes:
                    self._space.declare(name, sizes)
            else:
                self._call_entry(name, value)
                found = self.value(value)
                self._store(name, self._space.filled(found, sizes, self._span(value)) if sizes else found)

    def _call_entry(self, name: str, value: Node) -> None:
        """float px = state(0): what is an entry has the name."""
        is_entry = value.type == "subscript_expression" or (
            value.type == "call_expression"
            and field(value, "function").type == "identifier"
            and not is_function(text_of(field(value, "function")))
            and _are_places(named(field(value, "arguments")))
        )
        if is_entry:
            self._space.call_entry(name, *self._place(value))

    def _declared(self, node: Node) -> tuple[str, tuple[int, ...]]:
        """The name that is declared, and the sizes of an array."""
        sizes: list[int] = []
        while (inner := node.child_by_field_name("declarator")) is not None:
            size = node.child_by_field_name("size")
            if size is not None and text_of(size).isdigit() and len(text_of(size)) < 4:
                sizes.insert(0, int(text_of(size)))
            node = inner
        return text_of(node), tuple(sizes)

    def _constructed(self, value: Node | None) -> tuple[int, ...]:
        """The sizes in MatrixXd H(2, 4)."""
        said = [text_of(one) for one in named(value)] if value is not None else []
        if not said or not all(one.isdigit() and len(one) < 4 for one in said):
            return ()
        return tuple(int(one) for one in said)

    def _is_whole(self, name: str) -> bool:
        return not _WHOLE_TYPES.isdisjoint(self._types.get(name, "").split())

    def _store(self, name: str, value: Value) -> None:
        """Assign, in the type of the name: an int keeps whole numbers, a double makes them others."""
        kind = self._types.get(name, "double")
        is_whole = self._is_whole(name)
        if is_whole and not value.whole:
            raise FormulaError(f"{name} is {kind}, which drops the fraction", span=value.tree.span)
        whole = value.whole and (is_whole or kind == "auto")
        self._space.assign(name, Value(value.tree, value.shape, whole, value.size))

    def _assign(self, node: Node) -> None:
        left, right = field(node, "left"), field(node, "right")
        sign = text_of(field(node, "operator")) if node.child_by_field_name("operator") else "="
        if right.type == "assignment_expression":  # a = b = c
            self._assign(right)
            right = field(right, "left")
        if left.type == "identifier" and sign == "=":
            self._call_entry(text_of(left), right)
        value = self.value(right)
        if sign != "=":
            value = self._changed(sign.removesuffix("="), self.value(left), value, self._span(node))
        name, places = self._place(left)
        if not name:
            raise FormulaError("this cannot be assigned to", span=self._span(left))
        if places:
            self._space.assign_entry(name, places, value, self._span(left))
        else:
            self._store(name, value)

    def _changed(self, sign: str, old: Value, new: Value, span: Span) -> Value:
        parts = [("+", old, span), (sign, new, span)]
        if sign in {"+", "-"}:
            return self._chain.sum(parts, span)
        if sign in {"*", "/"}:
            return self._chain.product([("*", old, span), (sign, new, span)], span, entrywise=frozenset())
        raise FormulaError(f"{sign}= is not read", span=span)

    def _fill(self, node: Node) -> None:
        """H << a, b, c, d; of Eigen: the entries row by row."""
        target, entries = self._streamed(node)
        name, span = text_of(target), self._span(node)
        is_sized = self._space.is_defined(name)
        shape = self._space.name(name, span).shape or () if is_sized else ()
        self._space.assign(name, self._laid(entries, shape, name if is_sized else "", span))

    def _streamed(self, node: Node) -> tuple[Node, list[Node]]:
        """What stands before << and the entries behind it."""
        entries = list(_listed(node))
        first = entries[0]
        if first.type != "binary_expression" or text_of(field(first, "operator")) != "<<":
            raise FormulaError("a comma has no meaning here", span=self._span(node))
        return field(first, "left"), [field(first, "right"), *entries[1:]]

    def _laid(self, entries: Sequence[Node], shape: tuple[int, ...], name: str, span: Span) -> Value:
        """An array of entries row by row; of what has no name, or one of no known size, they tell the shape."""
        if not shape and not name:
            shape = laid_out([one.start_point[0] for one in entries])
        count = math.prod(shape)
        if count != len(entries):
            raise FormulaError(f"{name or 'the array'} has {count} entries, here are {len(entries)}", span=span)
        values = [self.value(entry) for entry in entries]
        if len(shape) < 2 or 1 in shape:
            return self._space.array(values, span)
        rows = [self._space.array(values[at : at + shape[1]], span) for at in range(0, count, shape[1])]
        return self._space.array(rows, span)

    def _made(self, node: Node) -> Value:
        """What (Matrix2d() << 1, dt, 0, 1) and OpenCV's (Mat_<float>(2, 2) << 1, dt, 0, 1) make."""
        target, entries = self._streamed(node)
        if not _is_made(target):
            raise FormulaError("a comma has no meaning here", span=self._span(node))
        kind = text_of(field(target, "function"))
        shape = self._constructed(field(target, "arguments")) or class_sizes(kind)
        return self._laid(entries, shape, "", self._span(node))

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
            case "number_literal":
                return self._number(text_of(node), span)
            case "identifier":
                return self._space.name(text_of(node), span, whole=self._is_whole(text_of(node)))
            case "parenthesized_expression" | "conditional_expression":
                return self.value(self._inside(node))
            case "unary_expression" | "binary_expression":
                return self._operation(node, span)
            case "field_expression" | "qualified_identifier" | "pointer_expression":
                return self._member(node, span)
            case "subscript_expression":
                return self._entry(node, span)
            case "call_expression":
                return self._call(node, span)
            case "cast_expression":
                return self._cast(text_of(field(node, "type")), self.value(field(node, "value")), span)
            case "comma_expression" | "initializer_list":
                is_list = node.type == "initializer_list"
                return self._space.array([*map(self.value, named(node))], span) if is_list else self._made(node)
            case _:
                raise FormulaError(self._unread(node), span=span)

    def _inside(self, node: Node) -> Node:
        """What is in brackets, or the branch of a case that is meant."""
        if node.type == "parenthesized_expression":
            return _only(node)
        is_first = self._branch(node)
        if is_first is None:
            raise FormulaError(self._unread(node), span=self._span(node))
        return field(node, "consequence" if is_first else "alternative")

    def _number(self, text: str, span: Span) -> Value:
        if text[0] in "+-":  # a sign that the grammar takes for part of the number
            number = self._number(text[1:], (span[0] + 1, span[1]))
            return self._space.negated(number, span) if text[0] == "-" else number
        found = _NUMBER.fullmatch(text.replace("'", ""))
        if not found or (len(found["digits"]) > 1 and found["digits"].isdigit() and found["digits"][0] == "0"):
            raise FormulaError(f"{text[:40]} is no decimal number", span=span)
        whole = found["digits"].isdigit() and "f" not in found["suffix"].lower()
        return self._space.number(found["digits"], span, whole=whole)

    def _operation(self, node: Node, span: Span) -> Value:
        sign = text_of(field(node, "operator"))
        if node.type == "unary_expression" and sign in {"+", "-"}:
            operand = self.value(field(node, "argument"))
            return operand if sign == "+" else self._space.negated(operand, span)
        if sign in {"+", "-"}:
            return self._chain.sum(self._parts(node, {"+", "-"}), span)
        if sign in {"*", "/"}:
            return self._chain.product(self._parts(node, {"*", "/"}), span, entrywise=frozenset())
        said = _UNREAD_OPERATORS.get(sign, "{sign} has no place in a formula")
        raise FormulaError(said.format(language=self._space.language, sign=sign), span=span)

    def _parts(self, node: Node, signs: set[str]) -> list[tuple[str, Value, Span]]:
        """The operands of a chain with the sign before each; the first one has the first sign."""
        found: list[tuple[str, Value, Span]] = []
        while node.type == "binary_expression" and (sign := text_of(field(node, "operator"))) in signs:
            right = field(node, "right")
            found.append((sign, self.value(right), self._span(right)))
            node = field(node, "left")
        return [("+" if "+" in signs else "*", self.value(node), self._span(node)), *reversed(found)]

    def _member(self, node: Node, span: Span) -> Value:
        """plot.x and plot->x are plot_x, this->x is x, *x is x; std::numbers::pi is pi."""
        if node.type == "pointer_expression" and field(node, "argument").type == "parenthesized_expression":
            return self.value(field(node, "argument"))
        if node.type == "qualified_identifier":
            return self._space.name(text_of(node).rsplit("::", 1)[-1], span)
        name, _ = self._place(node)
        if not name:
            raise FormulaError(self._unread(node), span=span)
        return self._space.name(name, span)

    def _place(self, node: Node) -> tuple[str, list[Place]]:
        """The name of what is assigned to or picked from, and the entry."""
        places: list[Place] = []
        while node.type in {"subscript_expression", "call_expression"}:
            function = node.child_by_field_name("argument") or field(node, "function")
            inside = node.child_by_field_name("index")
            indices = [inside] if inside is not None else named(_arguments(node))
            places[:0] = [self._one_place(one) for one in indices]
            node = function
        if node.type == "pointer_expression" and text_of(node).startswith("*"):
            return self._place(field(node, "argument"))
        if node.type == "field_expression":
            owner, _ = self._place(field(node, "argument"))
            member = text_of(field(node, "field"))
            return (f"{owner}_{member}" if owner else member), places
        if node.type == "this":
            return "", places
        return (text_of(node) if node.type == "identifier" else ""), places

    def _one_place(self, node: Node) -> Place:
        text = text_of(node)
        if not text.isdigit() or len(text) > 3:
            raise FormulaError("an entry is picked by a whole number", span=self._span(node))
        return int(text)

    def _entry(self, node: Node, span: Span) -> Value:
        name, places = self._place(node)
        if not name:
            raise FormulaError("an entry is picked from an array that has a name", span=span)
        return self._space.entry(name, places, span)

    def _call(self, node: Node, span: Span) -> Value:
        function = field(node, "function")
        arguments = named(field(node, "arguments"))
        if _is_made(node):
            return self._space.zeros(self._constructed(_arguments(node)) or class_sizes(text_of(function)), span)
        if function.type == "template_function":
            kind = text_of(field(function, "arguments")).strip("<>")
            if not text_of(field(function, "name")).endswith("_cast") or len(arguments) != 1:
                raise FormulaError("templates are not read", span=span)
            return self._cast(kind, self.value(arguments[0]), span)
        if function.type == "primitive_type" and len(arguments) == 1:
            return self._cast(text_of(function), self.value(arguments[0]), span)
        if function.type == "field_expression":
            return self._method(function, arguments, span)
        owner, _, name = text_of(function).rpartition("::")
        if name in _OF_A_TYPE and not arguments and (sizes := class_sizes(owner)):
            return self._space.of_kind(_OF_A_TYPE[name], sizes, span)
        if function.type == "identifier" and not is_function(name) and arguments and _are_places(arguments):
            return self._entry(node, span)
        return applied(self._space, name, [self.value(one) for one in arguments], span)

    def _method(self, function: Node, arguments: Sequence[Node], span: Span) -> Value:
        """P.transpose(), P.inverse(); F.setIdentity() sets what F is."""
        kind, target = text_of(field(function, "field")), text_of(field(function, "argument"))
        if kind in _SETTING and not arguments and self._space.is_defined(target):
            made = self._space.of_kind(
                _SETTING[kind], self._space.sized(self._space.name(target, span)).shape or (), span
            )
            self._space.assign(target, made)
            return made
        own = self.value(field(function, "argument"))
        if kind == "finished" and not arguments:
            return own
        return applied(self._space, text_of(field(function, "field")), [own, *map(self.value, arguments)], span)

    def _cast(self, kind: str, value: Value, span: Span) -> Value:
        whole = not _WHOLE_TYPES.isdisjoint(kind.split())
        if whole and not value.whole:
            raise FormulaError(f"a cast to {kind} drops the fraction", span=span)
        return Value(value.tree, value.shape, whole, value.size)

    def _unread(self, node: Node) -> str:
        return _UNREAD.get(node.type, f"{node.type.replace('_', ' ')} has no place in a formula")

    def _span(self, node: Node) -> Span:
        return max(node.start_byte - self._offset, 0), max(node.end_byte - self._offset, 0)


def _listed(node: Node) -> Iterator[Node]:
    """What stands between commas."""
    waiting = [node]
    while waiting:
        one = waiting.pop()
        if one.type == "comma_expression":
            waiting += [field(one, "right"), field(one, "left")]
        else:
            yield one


def _only(node: Node) -> Node:
    parts = named(node)
    if not parts:
        raise FormulaError("a value is missing here")
    return parts[0]


def _arguments(node: Node) -> Node:
    return node.child_by_field_name("indices") or field(node, "arguments")


def _are_places(arguments: Sequence[Node]) -> bool:
    return all(one.type == "number_literal" and text_of(one).isdigit() for one in arguments)


def _made_as(value: Node | None) -> Node | None:
    """What a name is declared as; of H = MatrixXd(2, 4), which says the sizes alone, what is in the brackets."""
    return field(value, "arguments") if value is not None and _is_made(value) else value


def _is_made(node: Node) -> bool:
    """Whether this makes an array of some size: MatrixXd(2, 4), or an empty Matrix2d()."""
    if node.type != "call_expression":
        return False
    return is_matrix_class(text_of(field(node, "function"))) and _are_places(named(field(node, "arguments")))
