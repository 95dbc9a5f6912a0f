"""What is built for installation holds every module and every data file of the three folders."""

import json
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
CONSTRAINTS = dict(
    line.split("==") for line in (ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines() if "==" in line
)
FOLDERS: dict[str, str] = PROJECT["tool"]["setuptools"]["package-dir"]
JUNK = ("__pycache__", "*.egg-info", "*.pyc")
IMPORT_EVERYTHING = """
import json, pkgutil, sys
from importlib import import_module
sys.path.insert(0, sys.argv[1])
import radartrack
files = []
for found in pkgutil.walk_packages(radartrack.__path__, "radartrack."):
    try:
        files.append(import_module(found.name).__file__)
    except ModuleNotFoundError as error:
        if error.name not in sys.argv[2:]:
            raise
print(json.dumps(files))
"""
OPTIONAL = (
    "dask",
    "distributed",
    "flint",
    "llvmlite",
    "matplotlib",
    "narwhals",
    "numba",
    "pint",
    "pyarrow",
    "stonesoup",
)  # modules that need these may say so


def package_files() -> dict[str, Path]:
    """Each file of the three folders by its place in an installation, `radartrack/derive/...`."""
    files = {}
    for package, folder in FOLDERS.items():
        for path in (ROOT / folder).rglob("*"):
            if path.is_file() and "__pycache__" not in path.parts and not path.name.startswith("."):
                files[f"{package.replace('.', '/')}/{path.relative_to(ROOT / folder).as_posix()}"] = path
    return files


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A wheel built from a copy, so that the tree stays as it is."""
    source = tmp_path_factory.mktemp("source")
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, source)
    for folder in FOLDERS.values():
        shutil.copytree(ROOT / folder, source / folder, ignore=shutil.ignore_patterns(*JUNK))
    built = tmp_path_factory.mktemp("built")
    pip = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check"]
    build = [
        "wheel",
        "--no-deps",
        "--no-build-isolation",
        "--no-index",
        "--wheel-dir",
        str(built),
        str(source),
    ]
    result = subprocess.run([*pip, *build], capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout + result.stderr
    [path] = built.glob("*.whl")
    return path


def test_every_folder_with_modules_or_data_is_a_declared_package() -> None:
    folders = {str(Path(name).parent).replace("/", ".") for name in package_files()}
    assert PROJECT["tool"]["setuptools"]["packages"] == sorted(folders)


def test_the_wheel_holds_every_file_of_the_three_folders_and_nothing_else(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        held = {name for name in archive.namelist() if not name.split("/")[0].endswith(".dist-info")}
    assert held == set(package_files())


def test_every_module_of_the_wheel_can_be_imported_from_it(wheel: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path)
    result = subprocess.run(
        [sys.executable, "-P", "-c", IMPORT_EVERYTHING, str(tmp_path), *OPTIONAL],
        cwd=tmp_path, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert result.returncode == 0, result.stderr
    files = json.loads(result.stdout)
    assert files
    assert all(Path(file).is_relative_to(tmp_path) for file in files)


def test_the_license_goes_with_the_wheel(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        assert any(name.endswith(".dist-info/licenses/LICENSE") for name in archive.namelist())


def test_everything_that_is_installed_by_name_has_one_version() -> None:
    project = PROJECT["project"]
    lists = [
        project["dependencies"],
        *project["optional-dependencies"].values(),
        *PROJECT["dependency-groups"].values(),
    ]
    wanted = {re.split(r"[\[<=>]", entry)[0] for entries in lists for entry in entries if isinstance(entry, str)}
    assert wanted <= set(CONSTRAINTS)


def test_ruff_has_the_same_version_in_both_places() -> None:
    assert PROJECT["dependency-groups"]["lint"] == [f"ruff=={CONSTRAINTS['ruff']}"]
