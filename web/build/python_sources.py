"""Gathers the Python that runs in the browser, as it is installed here: `python python_sources.py FILE.zip`.

All of the library that needs neither processes nor arrays, and the packages that it imports, without their tests and
without what draws and talks to other programs.
"""

from __future__ import annotations

import sys
import zipfile
from collections.abc import Iterator
from importlib.metadata import files
from importlib.util import find_spec
from pathlib import Path, PurePosixPath

DISTRIBUTIONS = ("sympy", "mpmath", "lark")
NOT_NEEDED = {
    "tests", "benchmarks", "testing", "physics", "diffgeom", "crypto", "categories", "stats", "sandbox", "vector",
    "liealgebras", "holonomic", "codegen", "autolev", "fortran", "latex", "c", "tools", "__pyinstaller",
}  # fmt: skip
OF_LIBRARY = ("derive", "_page", "_reports", "_system", "generated")
CODE_TO_IMPORT = {"generated"}  # NumPy, which the page does without
SUFFIXES = {".py", ".lark", ".toml", ".json", ".css"}


def main(target: Path) -> None:
    """Write the archive."""
    with zipfile.ZipFile(target, "w") as archive:
        for place, path in sorted([*_of_distributions(), *_of_library()]):
            archive.writestr(zipfile.ZipInfo(place), path.read_bytes())  # without times: the same bytes each time


def _of_distributions() -> Iterator[tuple[str, Path]]:
    for name in DISTRIBUTIONS:
        for file in files(name) or []:
            place = PurePosixPath(str(file))
            if place.suffix in SUFFIXES and place.parts[0] == name and not NOT_NEEDED.intersection(place.parts):
                yield str(place), Path(str(file.locate()))


def _of_library() -> Iterator[tuple[str, Path]]:
    yield "radartrack/__init__.py", _folder("radartrack") / "__init__.py"
    for part in OF_LIBRARY:
        folder = _folder(f"radartrack.{part}")
        for path in folder.rglob("*"):
            is_needed = path.suffix in SUFFIXES and "__pycache__" not in path.parts
            if is_needed and not (part in CODE_TO_IMPORT and path.suffix == ".py" and path.name != "__init__.py"):
                yield f"radartrack/{part}/{path.relative_to(folder).as_posix()}", path


def _folder(package: str) -> Path:
    spec = find_spec(package)
    if spec is None or spec.origin is None:
        raise SystemExit(f"{package} is not installed")
    return Path(spec.origin).parent


if __name__ == "__main__":
    main(Path(sys.argv[1]))
