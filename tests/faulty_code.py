"""Single faults in the source of generated modules: one operator, number, function, sign, index or name is another."""

import ast
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from importlib.abc import InspectLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path

import numpy as np
import pytest

import radartrack.generated

FOLDER = Path(radartrack.generated.__path__[0])
OPERATORS: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.Pow: ast.Mult,
}
PROVED = "elementary"  # it computes no quantity; faults in it are for the checker of its proof
FUNCTIONS = {"sin": "cos", "cos": "sin", "exp": "expm1", "expm1": "exp", "sinh": "cosh", "cosh": "sinh"}


@dataclass(frozen=True)
class Fault:
    """One changed place.

    Attributes:
        module: the name of the generated module.
        function: in which the place is.
        kind: what is changed.
        line: where.
        place: the number of the node among those of the module, in the order in which `ast.walk` meets them.
    """

    module: str
    function: str
    kind: str
    line: int
    place: int

    def __str__(self) -> str:
        return f"{self.module}.{self.function}:{self.line}:{self.kind}:{self.place}"

    def source(self) -> str:
        """The module with the fault in it."""
        tree = parsed(self.module)
        function = next(f for f in functions_of(tree) if f.name == self.function)
        node = list(inside(function))[self.place]
        _change(node, self.kind, _names(function))
        return ast.unparse(ast.fix_missing_locations(tree))

    def put_in(self, patch: pytest.MonkeyPatch) -> None:
        """Let whoever imports the module have the one with the fault."""
        put_in(self.module, self.source(), patch)


def put_in(module: str, source: str, patch: pytest.MonkeyPatch) -> None:
    """Let whoever imports a generated module have this source of it."""
    name = f"radartrack.generated.{module}"
    written = _Written(source)
    spec = spec_from_loader(name, written)
    assert spec is not None
    loaded = module_from_spec(spec)
    written.exec_module(loaded)
    patch.setitem(sys.modules, name, loaded)


@dataclass(frozen=True)
class _Written(InspectLoader):
    """Loads a module from its source."""

    source: str

    def get_source(self, fullname: str) -> str:  # noqa: ARG002 - one module
        return self.source


@cache
def faults(count: int, seed: int) -> list[Fault]:
    """So many different ones, more of a function the longer it is, the same for the same seed."""
    modules = [path.stem for path in sorted(FOLDER.glob("*.py")) if path.stem != PROVED]
    functions = [(module, *each) for module in modules for each in _with_lengths(module)]
    lengths = np.array([length for *_, length in functions])
    generator = np.random.Generator(np.random.Philox(seed))
    found: dict[Fault, None] = {}
    while len(found) < count:
        module, function, _ = functions[generator.choice(len(functions), p=lengths / lengths.sum())]
        if places := list(faults_in(module, function)):
            found[places[generator.integers(len(places))]] = None
    return list(found)


def _with_lengths(module: str) -> Iterator[tuple[ast.FunctionDef, int]]:
    """The functions of a module, and how many characters each has."""
    lines = (FOLDER / f"{module}.py").read_text().splitlines()
    for function in functions_of(parsed(module)):
        yield function, sum(map(len, lines[function.lineno : function.end_lineno]))


def parsed(module: str) -> ast.Module:
    return ast.parse((FOLDER / f"{module}.py").read_text())


def functions_of(tree: ast.Module) -> list[ast.FunctionDef]:
    return [node for node in tree.body if isinstance(node, ast.FunctionDef)]


def inside(function: ast.FunctionDef) -> Iterator[ast.AST]:
    """The nodes of the statements; the docstring is none."""
    for statement in function.body[1:]:
        yield from ast.walk(statement)


def faults_of(module: str) -> Iterator[Fault]:
    """Every single fault of a module, in the order of their places."""
    for function in functions_of(parsed(module)):
        yield from faults_in(module, function)


def faults_in(module: str, function: ast.FunctionDef) -> Iterator[Fault]:
    """Every single fault of one function."""
    names = _names(function)
    for place, node in enumerate(inside(function)):
        for kind in _kinds(node, names):
            yield Fault(module, function.name, kind, getattr(node, "lineno", 0), place)


def _kinds(node: ast.AST, names: list[str]) -> Iterator[str]:
    if isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
        yield "operator"
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        yield "sign"
    if isinstance(node, ast.Constant) and type(node.value) in {int, float}:
        yield "number"
    if isinstance(node, ast.Attribute) and node.attr in FUNCTIONS:
        yield "function"
    if isinstance(node, ast.Subscript) and _index(node) is not None:
        yield "index"
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) and node.id in names and len(names) > 1:
        yield "name"


def _change(node: ast.AST, kind: str, names: list[str]) -> None:
    if isinstance(node, ast.BinOp):
        node.op = OPERATORS[type(node.op)]()
    elif isinstance(node, ast.UnaryOp):
        node.op = ast.UAdd()
    elif isinstance(node, ast.Constant):
        assert isinstance(node.value, int | float)
        node.value += 1
    elif isinstance(node, ast.Attribute):
        node.attr = FUNCTIONS[node.attr]
    elif isinstance(node, ast.Subscript):
        last = _index(node)
        assert last is not None
        assert isinstance(last.value, int)
        last.value = last.value - 1 if last.value else 1
    elif isinstance(node, ast.Name):
        node.id = names[names.index(node.id) - 1]
    else:
        raise TypeError(kind)


def _index(node: ast.Subscript) -> ast.Constant | None:
    """The last whole number between the brackets."""
    parts = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
    numbers = [part for part in parts if isinstance(part, ast.Constant) and type(part.value) is int]
    return numbers[-1] if numbers else None


def _names(function: ast.FunctionDef) -> list[str]:
    """The plain numbers of a function: its arguments and intermediates."""
    given = [argument.arg for argument in (*function.args.args, *function.args.kwonlyargs)]
    made = [n.id for n in inside(function) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)]
    arrays = {"arguments", "result", "given", "mean", "covariance", "i"}
    return [name for name in dict.fromkeys([*given, *made]) if name not in arrays]
