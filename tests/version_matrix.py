"""Runs the tests with the oldest and the newest of what pyproject.toml allows, and without what is optional.

python tests/version_matrix.py [ENVIRONMENT ...] [-- WHAT PYTEST IS TOLD ...]     for example: oldest -- tests/derive
"""

import re
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import NamedTuple

HERE = Path(__file__).parents[1]
OPTIONAL = ("dask", "distributed", "gmpy2", "matplotlib", "numba", "python-flint")
NEEDED_BY_TESTS = ("hypothesis", "pytest", "pytest-xdist", "scipy", "setuptools")


class Environment(NamedTuple):
    """A Python, which end of the versions, and what of the optional packages is there."""

    python: str
    oldest: bool = False
    optional: tuple[str, ...] = OPTIONAL


ENVIRONMENTS = {
    "oldest": Environment("python3.11", oldest=True),
    "bare": Environment("python3.12", optional=()),
    "newest": Environment("python3.13"),
    "next": Environment("python3.14"),  # no Python that the project promises; it tells early what will break
}


def requirements(environment: Environment) -> list[str]:
    """What pip is to install: every requirement of pyproject.toml, at its lower bound or free to be the newest."""
    project = tomllib.loads((HERE / "pyproject.toml").read_text())
    stated = {
        name_of(text): text for text in (*project["project"]["dependencies"], *project["dependency-groups"]["test"])
    }
    left_out = set(OPTIONAL) - set(environment.optional)
    wanted = [text for name, text in stated.items() if name not in left_out]
    if environment.oldest:
        return [re.sub(r">=([\d.]+).*", r"==\1", text) for text in wanted]
    return [*wanted, *(name for name in environment.optional if name not in stated)]


def name_of(requirement: str) -> str:
    """The package that a requirement is about."""
    return re.split(r"[^\w-]", requirement, maxsplit=1)[0]


def main(arguments: list[str]) -> int:
    split = arguments.index("--") if "--" in arguments else len(arguments)
    names, told = arguments[:split] or list(ENVIRONMENTS), arguments[split + 1 :]
    failed = []
    for name in names:
        environment = ENVIRONMENTS[name]
        folder = HERE / "build" / "matrix" / name
        print(
            f"=== {name}: {environment.python}, {'' if environment.optional else 'nothing optional, '}{folder}",
            flush=True,
        )
        try:
            subprocess.run([environment.python, "-m", "venv", "--clear", folder], check=True)
        except FileNotFoundError:
            print("not there")
            continue
        python = folder / "bin/python"
        install = [python, "-m", "pip", "install", "-qq", "--upgrade"]
        subprocess.run([*install, "pip"], check=True)
        subprocess.run([*install, *requirements(environment), "--editable", HERE], check=True)
        print(
            subprocess.run(
                [python, "-m", "pip", "freeze", "--exclude-editable"], check=True, capture_output=True, text=True
            ).stdout
        )
        if (
            told != ["none"]
            and subprocess.run([python, "-m", "pytest", "-n", "auto", *told], cwd=HERE, check=False).returncode
        ):
            failed.append(name)
    print("=== failed:", ", ".join(failed) or "none")
    return bool(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
