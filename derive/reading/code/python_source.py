"""Lines of Python as a formula: parsed by Python's own parser, never compiled and never run."""

from __future__ import annotations

import ast
import textwrap
import warnings
from collections.abc import Iterator, Sequence

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.limits import MAX_DEPTH
from radartrack.derive.formula.tree import Place, Tree
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.reading.code.code_functions import applied, of_blocks
from radartrack.derive.reading.code.workspace import Remark, Value, Workspace

_MODULES = frozenset(
    (
        "np",
        "numpy",
        "math",
        "cmath",
        "jnp",
        "jax",
        "torch",
        "sp",
        "sympy",
        "scipy",
        "linalg",
        "la",
        "casadi",
        "ca",
        "cp",
    )
)
_OF_NO_EFFECT = {"dtype", "order", "copy"}  # arguments that change no value
_CONSTANTS = {"pi": "pi", "e": "e"}
_XOR = "^ is exclusive or in Python, and a power in mathematics: write ** for the power"
_UNREAD: dict[type[ast.AST], str] = {
    ast.BitXor: _XOR,
    ast.FloorDiv: "// drops the fraction in Python: write / for the quotient",
    ast.Mod: "% is a remainder in Python, which formulas do not have",
    ast.If: "formulas have no cases: give the lines of the branch that is meant",
    ast.IfExp: "formulas have no cases: give the branch that is meant",
    ast.For: "loops are not read: write the lines out",
    ast.While: "loops are not read: write the lines out",
    ast.Constant: "only numbers stand in a formula",
    ast.ListComp: "loops are not read: write the entries out",
    ast.GeneratorExp: "loops are not read: write the terms out",
}
_SKIPPED = (ast.Import, ast.ImportFrom, ast.Pass, ast.Assert, ast.Global, ast.Nonlocal)


def read_python(text: str, space: Workspace, function: str = "") -> Value:
    """What Python code computes.

    Args:
        text: an expression, a block of assignments, or functions.
        space: where names have values.
        function: the one to read, by its name.

    Raises:
        FormulaError: for what formulas do not have, and what is not Python.
    """
    return _PythonReader(text, space).block(_body(_parsed(text), function))


def _parsed(text: str) -> ast.Module:
    dedented = textwrap.dedent(text).strip("\n") if "\n" in text.strip() else text.strip()
    offset = _first_line(text)
    source = "\n" * offset + dedented
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # that 1(x) is no call is said by the reader
            return ast.parse(source)
    except SyntaxError as error:
        raise FormulaError(f"this is not Python: {error.msg}", span=_place(text, error.lineno, error.offset)) from None
    except (ValueError, RecursionError, MemoryError, OverflowError):
        raise FormulaError("this is nested too deeply to be read") from None


def _first_line(text: str) -> int:
    """How many lines are blank before the first one that is not."""
    return len(text) - len(text.lstrip("\n"))


def _place(text: str, line: int | None, column: int | None) -> Span:
    lines = text.split("\n")
    line = min(max(line or 1, 1), len(lines))
    start = sum(len(one) + 1 for one in lines[: line - 1]) + min(max((column or 1) - 1, 0), len(lines[line - 1]))
    return start, start + 1


def _body(module: ast.Module, function: str) -> Sequence[ast.stmt]:
    functions = [node for node in _functions(module.body) if not function or node.name == function]
    if function and not functions:
        raise FormulaError(f"there is no function {function} here")
    outside = [node for node in module.body if not isinstance(node, (*_SKIPPED, ast.FunctionDef, ast.ClassDef))]
    if functions and (function or not outside):
        return functions[-1].body
    return module.body


def _functions(body: Sequence[ast.stmt]) -> list[ast.FunctionDef]:
    """The functions at the top and those of classes there."""
    found: list[ast.FunctionDef] = []
    for node in body:
        if isinstance(node, ast.ClassDef):
            found += [inner for inner in node.body if isinstance(inner, ast.FunctionDef)]
        elif isinstance(node, ast.FunctionDef):
            found.append(node)
    return found


class _PythonReader:
    def __init__(self, text: str, space: Workspace) -> None:
        self._space = space
        lines = text.split("\n")
        margin = min((len(line) - len(line.lstrip()) for line in lines if line.strip()), default=0)
        self._margins = [0 if not line.strip() else margin for line in lines]
        self._starts = [0]
        for line in lines:
            self._starts.append(self._starts[-1] + len(line) + 1)
        self._length = len(text)
        self._depth = 0

    def block(self, body: Sequence[ast.stmt]) -> Value:
        """What the statements compute."""
        last: Value | None = None
        for node in self._taken(body):
            match node:
                case ast.Return(ast.Tuple(entries) as value):
                    return self._space.fitting([self.value(entry) for entry in entries]) or self.value(value)
                case ast.Return(value) if value is not None:
                    return self.value(value)
                case ast.Expr(ast.Constant(str())) | ast.FunctionDef() | ast.ClassDef():
                    continue
                case ast.Expr(value):
                    last = self.value(value)
                case ast.Assign(targets, ast.Lambda(_, value)) | ast.Assign(targets, value):
                    self._assign(targets, value)
                    last = None
                case ast.AnnAssign(target, _, value) if value is not None:
                    self._assign([target], value)
                    last = None
                case ast.AugAssign(target, operator, value):
                    self._space.check_alone(self._subscripts(target)[0], self._span(node))
                    changed = ast.copy_location(ast.BinOp(target, operator, value), node)
                    self._assign([target], changed)
                    last = None
                case _ if not isinstance(node, _SKIPPED):
                    raise FormulaError(self._unread(node), span=self._span(node))
        return self._space.result(last)

    def _taken(self, body: Sequence[ast.stmt]) -> Iterator[ast.stmt]:
        """The statements, with those of a branch for it where the other one only keeps from dividing by zero."""
        for node in body:
            is_first = self._branch(node) if isinstance(node, ast.If) else None
            if not isinstance(node, ast.If) or is_first is None:
                yield node
            else:
                yield from self._taken(node.body if is_first else node.orelse)

    def _branch(self, node: ast.If | ast.IfExp) -> bool | None:
        both = [part if isinstance(part, list) else [part] for part in (node.body, node.orelse)]
        first, other = ("\n".join(map(ast.unparse, part)) for part in both)
        return self._space.branch(ast.unparse(node.test), (first, other), self._span(node))

    def _assign(self, targets: Sequence[ast.expr], value: ast.expr) -> None:
        for target in targets:
            if isinstance(target, ast.Tuple | ast.List):
                for one, its in zip(target.elts, self._unpacked(target, value), strict=True):
                    self._assign_value(one, its)
            else:
                if isinstance(target, ast.Name) and isinstance(value, ast.Subscript):
                    self._space.call_entry(target.id, *self._subscripts(value))
                self._assign_value(target, self.value(value))
                if isinstance(target, ast.Name) and (other := self._looked_at(value)):
                    self._space.share(target.id, other)

    def _looked_at(self, node: ast.expr) -> str:
        """The array of which an expression is all, a part or the transpose, and no copy."""
        while isinstance(node, ast.Subscript) or (isinstance(node, ast.Attribute) and node.attr == "T"):
            node = node.value
        return node.id if isinstance(node, ast.Name) else ""

    def _unpacked(self, target: ast.Tuple | ast.List, value: ast.expr) -> list[Value]:
        """What the names in `x, y = state` are worth: its entries, or themselves where the array is not known."""
        if isinstance(value, ast.Tuple | ast.List):
            found = [self.value(one) for one in value.elts]
        elif self._is_unknown(value):
            found = [self._space.named_anew(self._name(one), self._span(one)) for one in target.elts]
        else:
            array = self.value(value)
            shape = self._space.sized(array).shape or ()
            found = [self._space.picked(array, [at], self._span(value)) for at in range(shape[0] if shape else 0)]
        if len(found) != len(target.elts):
            raise FormulaError("as many values as names are needed here", span=self._span(target))
        return found

    def _is_unknown(self, node: ast.expr) -> bool:
        """Whether this is an array, or a slice of one, of which nothing is known here; a symbol is a number."""
        while isinstance(node, ast.Subscript):
            node = node.value
        name = self._name(node) if isinstance(node, ast.Name | ast.Attribute) else ""
        return bool(name) and not (self._space.is_defined(name) or name in self._space.shapes)

    def _assign_value(self, target: ast.expr, value: Value) -> None:
        if isinstance(target, ast.Subscript):
            name, places = self._subscripts(target)
            if not name:
                raise FormulaError("this cannot be assigned to", span=self._span(target))
            self._space.assign_entry(name, places, value, self._span(target))
        else:
            name = self._name(target)
            if not name:
                raise FormulaError("this cannot be assigned to", span=self._span(target))
            self._space.assign(name, value)

    def value(self, node: ast.expr) -> Value:
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

    def _value(self, node: ast.expr) -> Value:
        span = self._span(node)
        match node:
            case ast.Constant(value) if isinstance(value, int | float) and not isinstance(value, bool):
                return self._space.number(_digits(value, span), span)
            case ast.Name(name):
                return self._space.name(name, span)
            case ast.UnaryOp(ast.USub() | ast.UAdd() as sign, operand):
                found = self.value(operand)
                return found if isinstance(sign, ast.UAdd) else self._space.negated(found, span)
            case ast.BinOp():
                return self._operation(node, span)
            case ast.List(entries) | ast.Tuple(entries):
                return self._space.array([self.value(entry) for entry in entries], span)
            case ast.Attribute():
                return self._attribute(node, span)
            case ast.Subscript():
                return self._entry(node, span)
            case ast.Call():
                return self._call(node, span)
            case ast.IfExp(_, first, other) if (is_first := self._branch(node)) is not None:
                return self.value(first if is_first else other)
            case _:
                raise FormulaError(self._unread(node), span=span)

    def _operation(self, node: ast.BinOp, span: Span) -> Value:
        match node.op:
            case ast.Add() | ast.Sub():
                return self._space.sum(self._terms(node), span)
            case ast.Mult() | ast.Div() | ast.MatMult():
                return self._factors(node, span)
            case ast.Pow():
                return self._space.power(self.value(node.left), self.value(node.right), span, of_entries=True)
        raise FormulaError(self._unread(node.op), span=span)

    def _terms(self, node: ast.expr) -> list[Value]:
        """The terms of a sum, however many: they hang on each other's left."""
        terms: list[Value] = []
        while isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
            term = self.value(node.right)
            terms.append(self._space.negated(term, self._span(node.right)) if isinstance(node.op, ast.Sub) else term)
            node = node.left
        return [self.value(node), *reversed(terms)]

    def _factors(self, node: ast.expr, span: Span) -> Value:
        chain: list[tuple[ast.operator, ast.expr]] = []
        while isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult | ast.Div | ast.MatMult):
            chain.append((node.op, node.right))
            node = node.left
        factors = [self.value(node)]
        for operator, right in reversed(chain):
            value = self.value(right)
            here = (span[0], self._span(right)[1])
            if isinstance(operator, ast.Div):
                factors = [self._space.quotient(self._joined(factors, here), value, here)]
            elif isinstance(operator, ast.MatMult) and self._space.are_vectors([self._joined(factors, here)]):
                factors = [applied(self._space, "dot", [self._joined(factors, here), value], here)]
            elif isinstance(operator, ast.Mult) and self._space.both_arrays(factors, value):
                factors = [self._space.product([self._joined(factors, here), value], here, of_entries=True)]
            else:
                factors.append(value)
        return self._joined(factors, span)

    def _joined(self, factors: Sequence[Value], span: Span) -> Value:
        return factors[0] if len(factors) == 1 else self._space.product(factors, span)

    def _attribute(self, node: ast.Attribute, span: Span) -> Value:
        if node.attr == "T":
            return self._transposed(self.value(node.value), span)
        path = _path(node)
        if path[0] in _MODULES and node.attr in _CONSTANTS:
            return self._space.constant(_CONSTANTS[node.attr], span)
        name = self._name(node)
        if not name:
            raise FormulaError(f".{node.attr} is not read", span=span)
        return self._space.name(name, span)

    def _transposed(self, value: Value, span: Span) -> Value:
        """A transpose; NumPy's vectors neither stand nor lie."""
        if len(self._space.sized(value).shape or ()) != 1 or value.is_matrix:
            return self._space.call("transpose", [value], span)
        self._space.remarks.append(Remark(span, "the transpose of a vector is itself in Python: np.outer is a v v^T"))
        return value

    def _name(self, node: ast.expr) -> str:
        """A name, or that of an attribute: self.x is x, plot.x is plot_x; of a module, nothing."""
        path = _path(node)
        is_module = path[0] in _MODULES and len(path) > 1
        return "" if is_module else "_".join(part for part in path if part != "self")

    def _entry(self, node: ast.Subscript, span: Span) -> Value:
        name, places = self._subscripts(node)
        if name:
            return self._space.entry(name, places, span)
        return self._space.picked(self.value(node.value), self._places(node.slice), span)

    def _subscripts(self, node: ast.expr) -> tuple[str, list[Place]]:
        """The name of an array, and which entry is picked from it: x[0][1] is x[0, 1]."""
        places: list[Place] = []
        while isinstance(node, ast.Subscript):
            places[:0] = self._places(node.slice)
            node = node.value
        is_named = isinstance(node, ast.Name) or (isinstance(node, ast.Attribute) and node.attr != "T")
        return (self._name(node) if is_named else ""), places

    def _places(self, node: ast.expr) -> list[Place]:
        return [self._one_place(one) for one in (node.elts if isinstance(node, ast.Tuple) else [node])]

    def _one_place(self, node: ast.expr) -> Place:
        match node:
            case ast.Constant(int(at)) if 0 <= at < 1000:
                return at
            case ast.Slice(lower, upper, None):
                ends = [None if one is None else self._one_place(one) for one in (lower, upper)]
                return _end(ends[0]), _end(ends[1])
        raise FormulaError("an entry is picked by a whole number", span=self._span(node))

    def _call(self, node: ast.Call, span: Span) -> Value:
        if not {one.arg for one in node.keywords} <= _OF_NO_EFFECT or any(
            isinstance(one, ast.Starred) for one in node.args
        ):
            raise FormulaError("arguments are given by their places", span=span)
        if isinstance(node.func, ast.Attribute) and _path(node.func)[0] not in _MODULES:
            own = self.value(node.func.value)  # a method: P.dot(Q), a.transpose()
            if node.func.attr == "transpose" and not node.args:
                return self._transposed(own, span)
            return applied(self._space, node.func.attr, [own, *map(self.value, node.args)], span)
        function = _path(node.func)[-1]
        if function == "transpose" and len(node.args) == 1:
            return self._transposed(self.value(node.args[0]), span)
        if function == "block" and len(node.args) == 1 and isinstance(node.args[0], ast.List):
            return self._blocks(node.args[0], span)
        return applied(self._space, function, [self.value(one) for one in node.args], span)

    def _blocks(self, node: ast.List, span: Span) -> Value:
        """The matrix that rows of matrices and numbers make."""
        rows = [[self.value(one) for one in row.elts] for row in node.elts if isinstance(row, ast.List)]
        parts = [part for row in rows for part in row]
        if len(rows) < len(node.elts) or any(len(self._space.sized(part).shape or ()) == 1 for part in parts):
            raise FormulaError("block takes rows of matrices: [[A, B], [C, D]]", span=span)
        return of_blocks(self._space, [[self._block_of(part, span) for part in row] for row in rows], parts, span)

    def _block_of(self, value: Value, span: Span) -> Tensor[Tree]:
        is_array = bool(self._space.sized(value).shape)
        return self._space.opened(value, span) if is_array else Tensor((), (value.tree,))

    def _unread(self, node: ast.AST) -> str:
        said = _UNREAD.get(type(node))
        return said or f"{type(node).__name__} of Python has no place in a formula"

    def _span(self, node: ast.AST) -> Span:
        return self._offset(node, "lineno", "col_offset"), self._offset(node, "end_lineno", "end_col_offset")

    def _offset(self, node: ast.AST, line: str, column: str) -> int:
        at = getattr(node, line, 1) - 1
        if at >= len(self._margins):
            return self._length
        return min(self._starts[at] + self._margins[at] + getattr(node, column, 0), self._length)


def _path(node: ast.expr) -> list[str]:
    """The parts of a dotted name; an empty one where something else is."""
    parts: list[str] = []
    while isinstance(node, ast.Attribute):
        parts.append(node.attr)
        node = node.value
    return [node.id if isinstance(node, ast.Name) else "", *reversed(parts)]


def _end(place: Place | None) -> int | None:
    return place if isinstance(place, int) else None


def _digits(value: float, span: Span) -> str:
    text = repr(value)
    if text in {"inf", "nan"} or len(text) > 400:
        raise FormulaError("this number is not read", span=span)
    return text
