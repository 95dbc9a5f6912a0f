"""Verification of models of one's own: the same layers, in any process, and faults in their code are found."""

import pickle
import re
import tomllib
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from radartrack.derive.reading.model_table import read_models
from radartrack.verification.campaign import Campaign, Effort
from radartrack.verification.engines import Local
from radartrack.verification.own_models import NotWritten, OwnModels, tables_of, written
from tests import own_models

FEW = Effort(points=20, nodes=1, draws=1, mutants=1)
HERE = Local(1)


def steps(*_: object) -> None:
    """What a progress bar would show."""


def declared(text: str = own_models.TOML) -> OwnModels:
    return OwnModels(tables_of(read_models(tomllib.loads(text))))


def verdicts(own: OwnModels, names: list[str], engine: Any = HERE) -> dict[str, dict[str, str]]:
    records = Campaign(names, FEW, None, own).run(engine, steps)
    return {one["quantity"]: {layer["layer"]: layer["verdict"] for layer in one["layers"]} for one in records}


ARC = """
[symbols]
S = { unit = "m", low = 10, high = 1e4 }
b = { unit = "rad", low = 0.1, high = 3 }
k = { unit = "1", low = 0.2, high = 0.8 }
s_S = { unit = "m" }
s_b = { unit = "rad", high = 0.1 }
[[model]]
name = "arc"
measured = ["S", "b"]
parameters = ["k"]
outputs = { l = "S*b", c = "S^2*k", h = "2*sin(b/2)" }
units = { l = "m*rad", c = "m^2", h = "1" }
deviations = { S = "s_S", b = "s_b" }
[[model]]
name = "bent"
measured = ["S", "b"]
parameters = ["k"]
outputs = { x = "S*sqrt(1 - k*cos(b)^2)", y = "S*asin(k*sin(b))" }
units = { x = "m", y = "m" }
deviations = { S = "s_S", b = "s_b" }
[[model]]
name = "swing"
measured = ["S", "b"]
outputs = { x = "S*cos(b)", y = "S*log(1 + b)" }
units = { x = "m", y = "m" }
"""


def test_waves_arcs_powers_roots_inverse_functions_and_motions_pass_every_layer():
    names = ["arc.bias.truth", "arc.covariance.second_order", "arc.std.linear"]
    names += ["bent.map", "bent.covariance.linear", "bent.bias.truth.second_order", "swing.map", "swing.hessian"]
    own = written(declared(ARC), names, HERE, steps)
    found = verdicts(own, names)
    assert {name: layers for name, layers in found.items() if "failed" in layers.values()} == {}
    assert {layer: one for layer, one in found["arc.bias.truth"].items() if one != "passed"} == {
        "rounding": "not applicable"  # proofs come with the code of the catalogue alone
    }


PLAIN = """
[symbols]
r = { unit = "m", low = 1e3, high = 1e5 }
b = { unit = "rad" }
p = { unit = "m", low = -1e5, high = 1e5 }
q = { unit = "m", low = -1e5, high = 1e5 }
H = { unit = "m", low = 10, high = 900 }
s_r = { unit = "m", low = 1, high = 100 }
s_b = { unit = "rad", low = 1e-6, high = 0.1 }
s_p = { unit = "m", low = 1, high = 100 }
s_q = { unit = "m", low = 1, high = 100 }
[[model]]
name = "of_known_height"
measured = ["r", "b"]
parameters = ["H"]
outputs = { x = "r*cos(b)", y = "r*sin(b)", z = "H" }
units = { x = "m", y = "m", z = "m" }
deviations = { r = "s_r", b = "s_b" }
[[model]]
name = "flat"
measured = ["r", "b"]
outputs = { x = "r*cos(b)", y = "r*sin(b)", z = "0" }
units = { x = "m", y = "m", z = "m" }
deviations = { r = "s_r", b = "s_b" }
[[model]]
name = "shifted"
measured = ["r", "b"]
outputs = { x = "r*cos(b) + 1500", y = "(r + 2)*sin(b) - 800" }
units = { x = "m", y = "m" }
deviations = { r = "s_r", b = "s_b" }
[[model]]
name = "turned"
measured = ["p", "q"]
outputs = { x = "0.8*p - 0.6*q", y = "0.6*p + 0.8*q" }
units = { x = "m", y = "m" }
deviations = { p = "s_p", q = "s_q" }
correlations = { c = ["p", "q"] }
[[model]]
name = "level"
measured = ["p"]
outputs = { h = "p + 30" }
units = { h = "m" }
"""


@pytest.mark.parametrize("seed", [0, 5])
def test_coordinates_that_are_linear_constant_or_shifted_by_a_number_pass_every_layer(seed: int):
    rows = ["map", "bias.truth", "covariance.second_order", "covariance.truth", "unbiased.estimate"]
    models = ["of_known_height", "flat", "shifted", "turned"]
    names = [*(f"{model}.{row}" for model in models for row in rows), "level.map"]
    own = written(declared(PLAIN), names, HERE, steps)
    records = Campaign(names, replace(FEW, seed=seed, draws=1 << 20), None, own).run(HERE, steps)
    wrong = [(one["quantity"], layer) for one in records for layer in one["layers"] if layer["verdict"] == "failed"]
    assert wrong == []


def test_a_number_in_place_of_nothing_is_found():
    own = written(declared(PLAIN), names := ["flat.map", "flat.bias.truth", "flat.covariance.truth"], HERE, steps)
    zeros = re.compile(r"^( +result\[\.\.\.(?:, \d)+\] = )0\.0$", re.MULTILINE)
    found = verdicts(spoilt(own, lambda text: zeros.sub(r"\g<1>1.0", text)), names)
    assert all(layers["ulp"] == "failed" for layers in found.values())
    assert all(found[name][layer] == "failed" for name in names[1:] for layer in ("quadrature", "Monte Carlo"))


GROWING = """
[symbols]
b = { unit = "rad" }
w = { unit = "1", low = -0.9, high = 0.9 }
s_b = { unit = "rad", low = 1e-6, high = 0.1 }
s_w = { unit = "1", low = 1e-4, high = 0.05 }
[[model]]
name = "growing"
measured = ["b", "w"]
outputs = { p = "cos(b)*exp(w)", q = "sin(b)*exp(-w)" }
units = { p = "1", q = "1" }
deviations = { b = "s_b", w = "s_w" }
"""


def test_next_to_a_pole_an_error_is_no_more_than_the_arguments_have():
    names = ["growing.validity.linear", "growing.validity.second_order"]
    own = written(declared(GROWING), names, HERE, steps)
    records = Campaign(names, replace(FEW, points=200, mutants=0), None, own).run(HERE, steps)
    ulp = [layer for one in records for layer in one["layers"] if layer["layer"] == "ulp"]
    assert [layer["verdict"] for layer in ulp] == ["passed", "passed"], ulp


def spoilt(own: OwnModels, change: Callable[[str], str]) -> OwnModels:
    return replace(own, modules=tuple((name, change(text)) for name, text in own.modules))


def test_a_fault_in_the_code_of_a_model_is_found():
    names = ["rotor.covariance.linear", "rotor.bias.truth"]
    own = written(declared(), names, HERE, steps)
    assert not any("failed" in layers.values() for layers in verdicts(own, names).values())
    wrong = spoilt(own, lambda text: text.replace("np.cos(", "np.sin("))
    found = verdicts(wrong, names)
    assert all(layers["ulp"] == layers["quadrature"] == "failed" for layers in found.values())
    assert found["rotor.bias.truth"]["Monte Carlo"] == "failed"


def test_a_function_that_was_not_written_fails():
    found = verdicts(declared(), ["rotor.map"])
    assert found["rotor.map"]["ulp"] == "failed"


def test_an_edited_model_of_the_same_name_is_another_model():
    names = ["rotor.covariance.linear"]
    own = written(declared(), names, HERE, steps)
    edited = declared(own_models.TOML.replace("r*cos(w*T)", "r*cos(2*w*T)"))
    assert not any("failed" in layers.values() for layers in verdicts(own, names).values())
    assert "failed" in verdicts(replace(edited, modules=own.modules), names)[names[0]].values()
    again = written(edited, names, HERE, steps)
    assert not any("failed" in layers.values() for layers in verdicts(again, names).values())


def test_other_processes_are_given_models_and_code_as_data():
    names = ["rotor.map", "rotor.unbiased.estimate"]
    own = written(declared(), names, Local(2), steps)
    assert verdicts(own, names, Local(2)) == verdicts(own, names)
    tasks = list(Campaign(names, FEW, None, own)._tasks())
    for task in tasks[:3] + tasks[-1:]:
        assert pickle.loads(pickle.dumps(task))() == task()  # noqa: S301 - what was written here


def test_what_cannot_be_derived_is_named(monkeypatch: pytest.MonkeyPatch):
    def fail(_: object) -> None:
        raise ArithmeticError("no such form")

    monkeypatch.setattr("radartrack.verification.own_models.form_of", fail)
    with pytest.raises(NotWritten, match=r"rotor\.map cannot be derived: no such form"):
        written(declared(), ["rotor.map"], HERE, steps)
