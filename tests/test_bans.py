"""No text is ever evaluated as Python: formulas and claims files come from strangers."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
FOLDERS = ("benchmarks", "derive", "docs", "generated", "notebooks", "radartrack", "tests")
EVALUATE_BY_NAME = {
    "eval",
    "exec",
    "parse_expr",
    "parse_latex",
    "parse_mathematica",
    "parse_maxima",
    "sympify",
}
EVALUATE_TEXT_TOO = {"S", "lambdify", "simplify", "subs"}


def violations(source: str) -> Iterator[str]:
    """What in this Python code evaluates text, or could: `line: name`."""
    for node in ast.walk(ast.parse(source)):
        for name in _names(node):
            if name in EVALUATE_BY_NAME:
                yield f"{getattr(node, 'lineno', 0)}: {name}"
        if isinstance(node, ast.Call) and any(map(_is_text, node.args[:2])):
            function = getattr(node.func, "id", getattr(node.func, "attr", ""))
            if function in EVALUATE_TEXT_TOO:
                yield f"{node.lineno}: {function} of text"


def _names(node: ast.AST) -> tuple[str, ...]:
    """The names that a node reads or imports, `getattr(module, "name")` among them."""
    match node:
        case ast.Name(id=name):
            return (name,)
        case ast.Attribute(value=ast.Name(id="builtins" | "sp" | "sympy"), attr=name):
            return (name,)
        case ast.Attribute(attr=name) if name not in {"eval", "exec"}:
            return (name,)
        case ast.alias(name=name):
            return tuple(name.split("."))
        case ast.Call(func=ast.Name(id="getattr"), args=[_, ast.Constant(value=str(name)), *_]):
            return (name,)
        case _:
            return ()


def _is_text(argument: ast.expr | None) -> bool:
    """Whether an argument is text, or a tuple, list, set or dictionary with text in it."""
    match argument:
        case ast.Constant(value=str()) | ast.JoinedStr():
            return True
        case ast.Tuple(elts=parts) | ast.List(elts=parts) | ast.Set(elts=parts):
            return any(map(_is_text, parts))
        case ast.Dict(keys=keys, values=values):
            return any(map(_is_text, [*keys, *values]))
        case _:
            return False


def python_files() -> list[Path]:
    return sorted(
        path for folder in FOLDERS for path in (ROOT / folder).rglob("*.py*") if path.suffix in {".py", ".pyi"}
    )


@pytest.mark.parametrize("path", python_files(), ids=lambda path: str(path.relative_to(ROOT)))
def test_no_text_is_evaluated(path: Path) -> None:
    assert list(violations(path.read_text(encoding="utf-8"))) == []


@pytest.mark.parametrize(
    "bad",
    [
        "eval(text)",
        "exec(text)",
        "run = eval",
        "import builtins\nbuiltins.exec(text)",
        "getattr(builtins, 'eval')(text)",
        "from sympy import sympify",
        "from sympy import sympify as read\nread(text)",
        "import sympy\nsympy.sympify(text)",
        "import sympy.parsing.sympy_parser as p\np.parse_expr(text)",
        "from sympy.parsing.latex import parse_latex",
        "sp.S('x + 1')",
        "S(f'{a} + 1')",
        "lambdify(x, 'x + 1')",
        "lambdify([x, 'y'], expression)",
        "expression.subs('x', 1)",
        "expression.subs({x: 'y + 1'})",
        "def f():\n    class A:\n        g = lambda t: eval(t)",
    ],
)
def test_what_evaluates_text_is_found(bad: str) -> None:
    assert list(violations(bad))


@pytest.mark.parametrize(
    "good",
    [
        "S(1) / 3",
        "lambdify([x, y], x + y)",
        "lambdify([x, y], x + y, 'mpmath')",
        "expression.subs(symbols['x'], 1)",
        "model.eval()",
        "'eval(text)'",
        "Rational(1, 3)",
        "re.compile(pattern)",
        "def simplify(): return 'text'",
    ],
)
def test_what_evaluates_no_text_is_let_through(good: str) -> None:
    assert list(violations(good)) == []
