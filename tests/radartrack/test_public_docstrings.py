"""Every public function of tracks says what it takes, gives and refuses, and where its formula stands."""

import inspect
import re
from collections.abc import Callable, Iterator
from types import ModuleType
from typing import Any

import pytest

from radartrack import consistency, fixed_gain, frames, fusion, initiate, kalman, observe

MODULES = (consistency, fixed_gain, frames, fusion, initiate, kalman, observe)
SECTIONS = ("Args:", "Returns:", "Raises:", "Source:")
A_YEAR = re.compile(r"[A-Z][\w.-]+(?: [A-Z][\w.-]+)*,? (?:et al\. )?\d{4}|Prosov")


def functions(module: ModuleType) -> Iterator[tuple[str, Callable[..., Any]]]:
    """What a module offers."""
    for name, value in inspect.getmembers(module, inspect.isfunction):
        yield f"{module.__name__.removeprefix('radartrack.')}.{name}", value


PUBLIC = {name: function for module in MODULES for name, function in functions(module)}


def test_there_are_public_functions_in_each_module() -> None:
    assert {name.split(".")[0] for name in PUBLIC} == {module.__name__.split(".")[1] for module in MODULES}


@pytest.mark.parametrize("name", PUBLIC)
def test_a_public_function_says_everything(name: str) -> None:
    text = inspect.getdoc(PUBLIC[name]) or ""
    assert [section for section in SECTIONS if not re.search(rf"^{section}", text, re.MULTILINE)] == []
    parameters = inspect.signature(PUBLIC[name]).parameters
    assert [word for word in parameters if not re.search(rf"^    \**{word}: ", text, re.MULTILINE)] == []
    assert A_YEAR.search(text[text.index("Source:") :])
