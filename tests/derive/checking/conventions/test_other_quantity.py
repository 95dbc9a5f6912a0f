"""What equals another known quantity is said to be that, under which condition, and is never corrected into ours."""

import re
from collections.abc import Mapping
from itertools import permutations

import pytest

from radartrack.derive import catalogue as catalogues
from radartrack.derive import check
from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.source import Source
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import METRE, SECOND

NO_CORRELATION: dict[str, Expr | str] = {"rho": sp.Integer(0), "predicted_rho": sp.Integer(0)}


def _decorrelated(module: str, changed: Mapping[str, Expr | str]) -> str:
    """The decorrelated covariance with symbols replaced by others, or by numbers."""
    quantity = catalogue()[f"{module}.decorrelated.covariance"]
    known: dict[str, Symbol] = {symbol.name: symbol for symbol in quantity.symbols}
    changes = {known[name]: known[value] if isinstance(value, str) else value for name, value in changed.items()}
    return shown(quantity.expression.map(lambda entry: entry.xreplace(changes)))


@pytest.mark.parametrize("kind", ["measured", "zero"])
@pytest.mark.parametrize("module", ["polar", "spherical"])
def test_the_covariance_given_a_measurement_or_the_truth_is_the_decorrelated_one(module: str, kind: str) -> None:
    symbols = [one.name for one in catalogue()[f"{module}.decorrelated.covariance"].symbols]
    predicted = [name for name in symbols if name.startswith("predicted_sigma")]
    values: dict[str, Expr | str] = {
        name: name.removeprefix("predicted_") if kind == "measured" else sp.Integer(0) for name in predicted
    }
    verdict = check(f"{module}.unbiased.covariance", _decorrelated(module, values | NO_CORRELATION))
    words = "a prediction as good as the measurement" if kind == "measured" else "a perfect prediction"
    own, general = verdict.suggestions
    assert own.formula == f"{module}.unbiased.covariance.{'averaged' if kind == 'measured' else 'truth'} when rho = 0"
    assert general.formula == f"{module}.decorrelated.covariance with {words} when rho = 0"
    assert own.edit in verdict.reason


def test_another_quantity_is_known_in_another_convention() -> None:
    truth = catalogue()["polar.bias.truth"]
    beta = next(symbol for symbol in truth.symbols if symbol.name == "beta")
    turned = shown(truth.expression.map(lambda entry: entry.xreplace({beta: sp.pi / 2 - beta})))
    (only,) = check("polar.bias.averaged", turned).suggestions
    assert only.formula.startswith("polar.bias.truth with pi/2 - beta for beta")


def test_an_entry_is_not_said_to_be_its_own_mirror_image() -> None:
    formula = "r*rho*sigma_r*sigma_beta*cos(beta)**2 + (sigma_r**2 - r**2*sigma_beta**2)*sin(beta)*cos(beta)"
    suggestions = check("polar.covariance.linear[0,1]", formula).suggestions
    assert not any(one.formula.startswith("polar.covariance.linear[1,0]") for one in suggestions)


def test_the_same_thing_in_another_model_is_known_in_whatever_letters(monkeypatch: pytest.MonkeyPatch) -> None:
    sigma_w = Variable("sigma_w", "deviation of the jerk over a period", METRE / SECOND**3, 1e-3, 1e3)
    response = (T**3 / 6, T**2 / 2, T)
    piecewise = Quantity(
        name="motion.constant_acceleration.process_noise.piecewise",
        meaning="process noise of a jerk that is constant over a period",
        axes=((METRE, METRE / SECOND, METRE / SECOND**2),) * 2,
        symbols=(T, sigma_w),
        conditioning=Conditioning.NONE,
        source=Source("somebody", None, ""),
        word="sigma_w^2 g g'",
        derivation=lambda: Tensor.build((3, 3), lambda i, j: sigma_w**2 * response[i] * response[j]),
    )
    known = catalogues.catalogue() | {piecewise.name: piecewise}
    for module in ("catalogue", "checking.conventions.other_quantity", "checking.answers"):
        monkeypatch.setattr(f"radartrack.derive.{module}.catalogue", lambda: known)
    g = ("dt^3/6", "dt^2/2", "dt")
    printed = "[" + ", ".join("[" + ", ".join(f"sigma^2*{a}*{b}" for b in g) + "]" for a in g) + "]"
    verdict = check("motion.constant_acceleration.process_noise.continuous", printed)
    assert verdict.verdict in {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}
    (only,) = verdict.suggestions
    assert only.formula == piecewise.name
    assert "sigma for sigma_w" in only.edit


NOISES = ("continuous", "piecewise", "wiener_sequence")


@pytest.mark.parametrize("motion", ["constant_velocity", "constant_acceleration"])
@pytest.mark.parametrize(("meant", "printed"), list(permutations(NOISES, 2)))
@pytest.mark.parametrize("letter", ["", "q", "sigma_w**2", "sigma_a**2"])
def test_another_model_in_letters_of_ours_is_that(motion: str, meant: str, printed: str, letter: str) -> None:
    """The deviation of a jump is called sigma_w in one model of process noise as that of a constant is in another."""
    names = [f"motion.{motion}.process_noise.{kind}" for kind in (meant, printed)]
    formula = shown(catalogue()[names[1]].expression)
    for own in ("sigma_w**2", "q"):
        formula = re.sub(rf"(?<![\w.]){re.escape(own)}(?!\w)", letter or own, formula)
    verdict = check(names[0], formula)
    assert verdict.verdict is Outcome.WRONG_DIMENSIONS
    assert f"but this is {names[1]}" in verdict.reason
    assert [one.formula for one in verdict.suggestions] == [names[1]]
