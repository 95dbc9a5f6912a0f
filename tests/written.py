"""Python code in a file, imported: what the generator writes is tried as what it is, a module."""

import importlib.util
from itertools import count
from pathlib import Path
from types import ModuleType
from typing import Any

NUMBERS = count()


def module_of(source: str, folder: Path) -> ModuleType:
    """The module with this source."""
    path = folder / f"written_{next(NUMBERS)}.py"
    path.write_text(source)
    spec: Any = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
