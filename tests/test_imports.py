"""Everything that radartrack offers needs NumPy alone and costs little more to import; generated code too."""

import ast
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
HEAVY = ("lark", "mpmath", "narwhals", "pandas", "pint", "pyarrow", "rich", "scipy", "stonesoup", "sympy", "typer")
MOST_CALLS = 0.6  # of what NumPy makes: from 0.32 to 0.46 of it, by the versions of Python and NumPy
EVERYTHING = "from radartrack import *"  # parts load when they are named
CALLS = """
import sys
kinds = []
sys.setprofile(lambda frame, kind, argument: kinds.append(kind))
{}
sys.setprofile(None)
print(kinds.count("call") + kinds.count("c_call"))
"""


def run(code: str, *options: str) -> str:
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    command = [sys.executable, *options, "-c", code]
    return subprocess.run(command, capture_output=True, text=True, check=True, env=environment).stdout


def imported(source: str) -> set[str]:
    """The modules that Python code names in its import statements, relative ones with their dots."""
    names = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        if isinstance(node, ast.ImportFrom):
            names.add("." * node.level + (node.module or ""))
    return names


@pytest.mark.parametrize("package", HEAVY)
def test_importing_radartrack_loads_nothing_that_only_commands_need(package: str) -> None:
    assert run(f"{EVERYTHING}\nimport sys; print({package!r} in sys.modules)").strip() == "False"


def test_the_heavy_packages_are_noticed_when_they_are_loaded() -> None:
    assert run("import radartrack.derive.symbolic, sys; print('sympy' in sys.modules)").strip() == "True"


def test_importing_radartrack_makes_few_calls_beside_those_of_importing_numpy(tmp_path: Path) -> None:
    """Counts instead of measuring, so that other work on the machine changes nothing; the benchmarks measure.

    The byte code is in place after the first import, as it is wherever a package was imported once.
    """
    compiled = ("-X", f"pycache_prefix={tmp_path}")
    run(EVERYTHING, *compiled)
    numpy, radartrack = (int(run(CALLS.format(code), *compiled)) for code in ("import numpy", EVERYTHING))
    assert 0 < radartrack - numpy < MOST_CALLS * numpy, (radartrack, numpy)


@pytest.mark.parametrize("path", sorted((ROOT / "generated").rglob("*.py")), ids=lambda path: path.name)
def test_generated_code_imports_numpy_and_no_other_library(path: Path) -> None:
    roots = {name.split(".")[0] for name in imported(path.read_text(encoding="utf-8"))}
    assert roots <= {"__future__", "collections", "math", "numpy"}


def test_every_kind_of_import_is_seen() -> None:
    assert imported("import a.b\nfrom c import d\ndef f():\n    from . import e\n    from .g import h") == {
        "a.b",
        "c",
        ".",
        ".g",
    }
