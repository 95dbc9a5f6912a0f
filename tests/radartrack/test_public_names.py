"""What a user sees of a module when he asks for its names: what it offers, and nothing that serves it."""

import inspect
from importlib import import_module
from types import ModuleType

import pytest

import radartrack

MODULES = [value for name in radartrack.__all__ if isinstance(value := getattr(radartrack, name), ModuleType)]
PUBLIC = [radartrack, *MODULES, import_module("radartrack.testing")]


@pytest.mark.parametrize("module", PUBLIC, ids=lambda module: module.__name__)
def test_a_module_shows_what_it_offers_and_nothing_else(module: ModuleType) -> None:
    assert dir(module) == sorted(module.__all__)
    assert [name for name in dir(module) if not hasattr(module, name)] == []


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.__name__)
def test_what_a_module_offers_is_explained(module: ModuleType) -> None:
    offered = {name: getattr(module, name) for name in dir(module)}
    explicable = {name: value for name, value in offered.items() if inspect.isclass(value) or inspect.isfunction(value)}
    assert explicable
    assert [name for name, value in explicable.items() if not inspect.getdoc(value)] == []


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.__name__)
def test_a_module_offers_every_function_of_its_own_that_is_not_used_by_others_alone(module: ModuleType) -> None:
    own = {
        name
        for name, value in vars(module).items()
        if inspect.isfunction(value) and value.__module__ == module.__name__ and not name.startswith("_")
    }
    assert own - {*dir(module)} <= {"bounded_product", "position_std", "scatter"}
