"""What another process derived is read, and is what would be derived."""

from dataclasses import replace
from pathlib import Path

import pytest

from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr
from tests import shared_derivations

NAME = "polar.covariance.averaged"


def test_what_was_left_is_read_and_is_the_same(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    known = catalogue()[NAME]
    derived = 0

    def derivation() -> Tensor[Expr]:
        nonlocal derived
        derived += 1
        return known.expression

    def of_another_process() -> Quantity:
        quantity = replace(known, derivation=derivation)
        monkeypatch.setattr(shared_derivations, "catalogue", lambda: {NAME: quantity})
        shared_derivations.share(tmp_path)
        return quantity

    monkeypatch.setattr(shared_derivations, "QUICK", -1)
    for _ in range(2):
        assert of_another_process().expression == known.expression
    assert derived == 1
    assert [path.name for path in tmp_path.iterdir()] == [NAME]


def test_what_is_quickly_derived_is_not_left(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    quantity = replace(catalogue()[NAME], derivation=lambda: Tensor((), ()))
    monkeypatch.setattr(shared_derivations, "catalogue", lambda: {NAME: quantity})
    shared_derivations.share(tmp_path)
    assert quantity.expression == Tensor((), ())
    assert list(tmp_path.iterdir()) == []
