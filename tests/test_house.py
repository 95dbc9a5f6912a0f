"""What the documents say of the house is so: files and names that they mention are there, and rooms are not crowded."""

import ast
import re
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
WAY = ROOT / "docs" / "way_of_a_formula.md"
GLOSSARY = ROOT / "CONTRIBUTING.md"
PATH = re.compile(r"`((?:derive|generated|radartrack|tests|docs|notebooks)/[\w./]*)`")
NAME_IN_FILE = re.compile(r"`(\w+)`\s+(?:in\s+|\()`([\w/]+\.py)`")
MOST_FILES = 15  # of a room; what a reader can take in at a glance
A_COMMAND_AND_WHAT_IT_RUNS = {"audit.py", "check.py"}


def defined(path: Path) -> set[str]:
    """The names that a module defines at its top."""
    found: set[str] = set()
    for node in ast.parse(path.read_text()).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            found.add(node.name)
        elif isinstance(node, ast.Assign):
            found |= {target.id for target in node.targets if isinstance(target, ast.Name)}
    return found


@pytest.mark.parametrize("document", [WAY, GLOSSARY], ids=lambda path: path.name)
def test_every_file_and_room_that_is_named_is_there(document: Path):
    named = PATH.findall(document.read_text())
    assert len(named) > 20
    assert [path for path in named if "NAME" not in path and not (ROOT / path).exists()] == []


def test_the_way_names_functions_and_classes_where_they_are_defined():
    pairs = NAME_IN_FILE.findall(WAY.read_text())
    assert len(pairs) >= 12
    assert [(name, path) for name, path in pairs if name not in defined(ROOT / path)] == []


def modules(folder: str) -> list[Path]:
    return [path for path in sorted((ROOT / folder).rglob("*.py")) if path.name != "__init__.py"]


def test_no_room_is_crowded():
    rooms = Counter(path.parent for folder in ("derive", "radartrack") for path in modules(folder))
    assert {str(room.relative_to(ROOT)): count for room, count in rooms.items() if count > MOST_FILES} == {}


def test_every_room_says_what_it_holds():
    rooms = {path.parent for folder in ("derive", "radartrack") for path in modules(folder)}
    silent = [room for room in rooms if not ast.get_docstring(ast.parse((room / "__init__.py").read_text()))]
    assert silent == []


def test_no_two_files_share_a_name_but_a_command_and_what_it_runs():
    names = Counter(path.name for folder in ("derive", "radartrack") for path in modules(folder))
    assert {name for name, count in names.items() if count > 1} <= A_COMMAND_AND_WHAT_IT_RUNS
