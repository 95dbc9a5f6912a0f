"""Every map, and every derivative of one, has a second derivation, with which it agrees and a mutant of it does not."""

from dataclasses import replace

import pytest

from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.quantity import Quantity
from radartrack.verification.layers.formula_mutants import mutants
from radartrack.verification.layers.identity import Identity
from radartrack.verification.outcome import Verdict, examined
from tests import conversions

MAPS = [
    q for q in catalogue().values() if q.name.endswith((".map", ".jacobian")) and (q.model or q.module == "observe")
]


def verdict(quantity: Quantity) -> Verdict:
    return examined(Identity(), quantity, lambda: None).verdict


@pytest.mark.parametrize("quantity", MAPS, ids=conversions.ids)
def test_a_map_agrees_with_a_second_derivation_and_its_mutants_do_not(quantity: Quantity):
    assert verdict(quantity) is Verdict.PASSED
    for mutant in mutants(quantity, 2, 1):
        mistaken = replace(quantity, derivation=lambda entries=mutant.entries: entries, rewriting=None)
        assert verdict(mistaken) is Verdict.FAILED, mutant.kind
