"""Imports the modules that the build compiled, from memory; files that they read lie beside where they were.

What is loaded then may be kept by the browser and taken up again by another Python, in which there is all that is in
memory, and no file.
"""

from __future__ import annotations

import gc
import marshal
import sys
from collections.abc import Callable, Iterator
from importlib import import_module
from importlib.machinery import ModuleSpec
from importlib.readers import FileReader
from pathlib import Path
from types import ModuleType
from typing import Any

ROOT = "/packages"
MODULES: dict[str, tuple[bool, str, bytes]] = {}  # by name: whether it is a package, its place, its code
FILES: dict[str, bytes] = {}  # by place


class Folder:
    """Finds the modules of one folder below the root, as Python's own finder does on a disk."""

    def __init__(self, path: str) -> None:
        if path != ROOT and not path.startswith(f"{ROOT}/"):
            raise ImportError(path)
        self.package = path.removeprefix(ROOT).strip("/").replace("/", ".")

    def find_spec(self, name: str, _: ModuleType | None = None) -> ModuleSpec | None:
        """The module of this name, if there is one."""
        if name not in MODULES:
            return None
        is_package, place, code = MODULES[name]
        path = f"{ROOT}/{place}"
        spec = ModuleSpec(name, Compiled(path, code), origin=path, is_package=is_package)
        spec.has_location = True
        if is_package:
            spec.submodule_search_locations = [path.removesuffix("/__init__.py")]
        return spec

    def iter_modules(self, prefix: str = "") -> Iterator[tuple[str, bool]]:
        """What this folder holds, for `pkgutil`: sensors are found so."""
        for name, (is_package, _, _) in MODULES.items():
            parent, _, last = name.rpartition(".")
            if parent == self.package:
                yield f"{prefix}{last}", is_package


class Compiled:
    """Loads a module from its code."""

    def __init__(self, path: str, code: bytes) -> None:
        self.path = path
        self.code = code

    def create_module(self, _: ModuleSpec) -> None:
        """A module like any other."""

    def get_resource_reader(self, _: str) -> FileReader:
        """What reads the files beside the module."""
        return FileReader(self)

    def exec_module(self, module: ModuleType) -> None:
        """Run what the build compiled."""
        exec(marshal.loads(self.code), module.__dict__)


def install(packed: Any) -> None:
    """Put the modules where `import` finds them, and the files that they read beside them."""
    modules, files = marshal.loads(packed.to_bytes())
    MODULES.update(modules)
    FILES.update(files)
    _write_files()
    sys.path_hooks.insert(0, Folder)
    sys.path.insert(0, ROOT)
    sys.path_importer_cache.clear()


def prepare() -> None:
    """Load what a first verdict needs; what is loaded is no garbage, and SymPy makes little."""
    gc.disable()
    import_module("radartrack._page.answering").prepare()
    gc.freeze()
    gc.set_threshold(200_000, 50, 50)
    gc.enable()


def begin() -> Callable[[str, Callable[[str], None]], None]:
    """What answers, in the Python that was prepared or in one that took up its memory."""
    _write_files()
    answer: Callable[[str, Callable[[str], None]], None] = import_module("radartrack._page.answering").answer
    return answer


def _write_files() -> None:
    for place, content in FILES.items():
        path = Path(f"{ROOT}/{place}")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
