"""Every map, and every derivative of one, has a second derivation, with which it agrees and a mutant of it does not."""

from dataclasses import replace
from functools import partial

import pytest

from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr
from radartrack.verification.layers.formula_mutants import mutants
from radartrack.verification.layers.identity import Identity
from radartrack.verification.outcome import Verdict, examined
from tests import conversions

MAPS = [
    q for q in catalogue().values() if q.name.endswith((".map", ".jacobian")) and (q.model or q.module == "observe")
]


def verdict(quantity: Quantity) -> Verdict:
    return examined(Identity(), quantity, lambda: None).verdict


def _as_it_is(entries: Tensor[Expr]) -> Tensor[Expr]:
    return entries


@pytest.mark.parametrize("quantity", MAPS, ids=conversions.ids)
def test_a_map_agrees_with_a_second_derivation_and_its_mutants_do_not(quantity: Quantity):
    assert verdict(quantity) is Verdict.PASSED
    for mutant in mutants(quantity, 2, 1):
        mistaken = replace(quantity, derivation=partial(_as_it_is, mutant.entries), rewriting=None)
        assert verdict(mistaken) is Verdict.FAILED, mutant.kind


OBSERVED_POSITIONS = [quantity for quantity in MAPS if quantity.module == "observe" and quantity.name.endswith(".map")]


@pytest.mark.parametrize("quantity", OBSERVED_POSITIONS, ids=conversions.ids)
def test_every_sign_of_what_is_observed_matters(quantity: Quantity):
    """A path that is the difference of two distances is undone by the conversion all the same: it must not pass."""
    signs = [mutant for mutant in mutants(quantity, 60, 1) if mutant.kind == "sign"]
    for mutant in signs:
        mistaken = replace(quantity, derivation=partial(_as_it_is, mutant.entries), rewriting=None)
        assert verdict(mistaken) is Verdict.FAILED, mutant.entries
