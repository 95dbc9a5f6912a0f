"""Runs the tests with the oldest and with the newest of what pyproject.toml allows, and with nothing optional.

python tests/version_matrix.py [ENVIRONMENT ...] [-- WHAT PYTEST IS TOLD ...]    for example: oldest -- tests/derive
"""

import re
import subprocess
import sys
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[1]
ENVIRONMENTS_FOLDER = ROOT / "build" / "matrix"
OPTIONAL = {
    "dask",
    "distributed",
    "gmpy2",
    "matplotlib",
    "narwhals",
    "numba",
    "pandas",
    "pint",
    "polars",
    "pyarrow",
    "python-flint",
    "stonesoup",
    "tree-sitter",
    "tree-sitter-c",
    "tree-sitter-cpp",
    "tree-sitter-matlab",
    "xarray",
}


class Environment(NamedTuple):
    """A Python, which end of the versions, and whether what is optional is there."""

    python: str
    oldest: bool = False
    bare: bool = False


ENVIRONMENTS = {
    "oldest": Environment("python3.11", oldest=True),
    "bare": Environment("python3.12", bare=True),
    "newest": Environment("python3.13"),
    "next": Environment("python3.14"),  # no version of Python that is promised; it tells early what will break
}


def requirements(environment: Environment) -> list[str]:
    """What pip is to install: each requirement at its lower bound, or the newest version that there is."""
    stated = tomllib.loads((ROOT / "pyproject.toml").read_text())
    wanted = [*stated["project"]["dependencies"], *stated["dependency-groups"]["test"]]
    if environment.bare:
        return [text for text in wanted if re.split(r"[^\w-]", text, maxsplit=1)[0] not in OPTIONAL]
    return [re.sub(r">=([\d.]+).*", r"==\1", text) for text in wanted] if environment.oldest else [*wanted, "gmpy2"]


def build(name: str) -> Path | None:
    """The interpreter of a new environment; None where its version of Python is not there."""
    environment, folder = ENVIRONMENTS[name], ENVIRONMENTS_FOLDER / name
    try:
        subprocess.run([environment.python, "-m", "venv", "--clear", folder], check=True)
    except (FileNotFoundError, subprocess.CalledProcessError):
        return None
    python = folder / "bin" / "python"
    install: list[str | Path] = [python, "-m", "pip", "install", "-qq", "--upgrade"]
    subprocess.run([*install, "pip"], check=True)
    subprocess.run([*install, *requirements(environment), "--editable", ROOT], check=True)
    return python


def outcome(name: str, told: Sequence[str]) -> str:
    """How the tests ended in one environment."""
    print(f"=== {name}: {ENVIRONMENTS[name]}", flush=True)
    python = build(name)
    if python is None:
        return f"{ENVIRONMENTS[name].python} is not there"
    subprocess.run([python, "-m", "pip", "list"], check=True)
    tests: list[str | Path] = [python, "-m", "pytest", "-n", "auto", "--dist", "worksteal", *told]
    warned = ["--override-ini", "filterwarnings=default"] if ENVIRONMENTS[name].oldest else []  # of what is newer
    return "failed" if subprocess.run([*tests, *warned], cwd=ROOT, check=False).returncode else "passed"


def main(arguments: list[str]) -> int:
    """Run the environments that are named, or all, and say at the end how each went."""
    split = arguments.index("--") if "--" in arguments else len(arguments)
    outcomes = {name: outcome(name, arguments[split + 1 :]) for name in arguments[:split] or ENVIRONMENTS}
    print(*(f"=== {name}: {said}" for name, said in outcomes.items()), sep="\n")
    return "failed" in outcomes.values()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
