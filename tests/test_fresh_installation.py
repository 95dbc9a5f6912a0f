"""What is built for a release works in an environment that has never seen this checkout."""

import os
import subprocess
import sys
import venv
from importlib.metadata import distributions
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
COMMANDS = (
    ("list", "polar.map"),
    ("show", "polar.map"),
    ("check", "polar.map[0]", "r*cos(beta)"),
    ("find", "r*cos(beta)"),
    ("regenerate", "--help"),
    ("audit", "--help"),
    ("verify", "--help"),
    ("reproduce", "--help"),
    ("draft", "--help"),
    ("points", "polar.map", "--out", "points.csv"),
)


def run(*command: str | Path, folder: Path) -> str:
    finished = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, env=_environment())
    assert finished.returncode == 0, finished.stdout + finished.stderr
    return finished.stdout


def _environment() -> dict[str, str]:
    return {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "VIRTUAL_ENV"))}


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A source distribution from what git tracks, and a wheel from nothing but that."""
    folder = tmp_path_factory.mktemp("release")
    build = "from setuptools import build_meta as b; import sys; print(getattr(b, sys.argv[1])(sys.argv[2]))"
    source = folder / "source"
    run("git", "clone", "--quiet", "--depth=1", ROOT.as_uri(), source, folder=folder)
    name = run(sys.executable, "-c", build, "build_sdist", folder, folder=source).splitlines()[-1]
    run(sys.executable, "-m", "tarfile", "-e", folder / name, folder / "unpacked", folder=folder)
    (unpacked,) = (folder / "unpacked").iterdir()
    run(sys.executable, "-c", build, "build_wheel", folder, folder=unpacked)
    return folder


def fresh(release: Path, folder: Path) -> Path:
    """The programs of an environment with this distribution, and with what it needs from the one of the tests."""
    venv.create(folder / "env")
    (site,) = (folder / "env" / "lib").glob("python*/site-packages")
    needed = {str(one.locate_file("")) for one in distributions() if one.metadata["Name"] in {"sympy", "setuptools"}}
    (site / "needed.pth").write_text("\n".join(sorted(needed)))  # directories alone: no installation of this checkout
    pip = (sys.executable, "-m", "pip", "--python", folder / "env", "--quiet", "--disable-pip-version-check")
    run(*pip, "install", "--no-deps", "--no-index", "--no-build-isolation", release, folder=folder)
    return folder / "env" / "bin"


def test_every_command_of_the_wheel_works_outside_a_checkout(built: Path, tmp_path: Path) -> None:
    programs = fresh(next(built.glob("*.whl")), tmp_path)
    said = {command[0]: run(programs / "radartrack", *command, folder=tmp_path) for command in COMMANDS}
    assert said["check"].startswith("equal, proved")
    assert "r*cos(beta)" in said["show"]
    assert "polar.map[0]" in said["find"]
    where = run(programs / "python", "-c", "import radartrack; print(radartrack.__file__)", folder=tmp_path)
    assert Path(where.strip()).is_relative_to(tmp_path)


def test_the_source_distribution_installs_and_converts_plots(built: Path, tmp_path: Path) -> None:
    programs = fresh(next(built.glob("*.tar.gz")), tmp_path)
    convert = "import radartrack as rt; print(rt.convert.polar(1e4, 0.5, 50.0, 0.02).mean)"
    assert "8777" in run(programs / "python", "-c", convert, folder=tmp_path)
    assert run(programs / "radartrack", "check", "polar.map[0]", "r*cos(beta)", folder=tmp_path).startswith("equal")
