"""Formulas in which print leaves open where the argument of a function ends: what they say is found by trial."""

import pytest

from radartrack.derive import check
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.formula.error import FormulaError

RIGHT = [
    ("polar.map", r"[\cos\theta\, r, \sin\theta\, r]^T"),
    ("polar.map[0]", r"\cos\alpha d"),
    ("polar.map[0]", "cos θ ρ"),
    ("polar.jacobian[0,1]", r"-\sin\beta\, r"),
    ("polar.covariance.linear[0,0]", r"\cos^2\theta\, q + \sin^2\theta\, r^2\sigma_\theta^2"),
    ("polar.covariance.linear[0,1]", r"\sin\theta\cos\theta (\sigma_r^2 - r^2\sigma_\theta^2)"),
    ("spherical.map[0]", r"\cos\epsilon\sin\beta r"),
    ("spherical.jacobian", r"""\begin{bmatrix} \sin\theta\cos\phi & \cos\phi\cos\theta\, r & -\sin\theta\sin\phi\, r \\
        \cos\theta\cos\phi & -\cos\phi\sin\theta\, r & -\cos\theta\sin\phi\, r \\ \sin\phi & 0 & \cos\phi\, r
        \end{bmatrix}"""),
    ("motion.turn.known_rate.transition[0,1]", r"\frac{\sin\omega\, T_s}{\omega}"),
    ("motion.turn.known_rate.transition[0,1]", r"T\frac{1}{T\omega}\sin w T, w = \omega"),
]  # fmt: skip


def verdict(name: str, formula: str) -> Outcome:
    return check(name, formula, latex="\\" in formula, given={} if "covariance" not in name else {"rho": "0"}).verdict


@pytest.mark.parametrize(("name", "formula"), RIGHT)
def test_the_way_that_makes_it_right_is_taken(name: str, formula: str) -> None:
    assert verdict(name, formula) is Outcome.EQUAL


@pytest.mark.parametrize(
    ("name", "formula", "edit"),
    [
        ("polar.map[0]", r"\sin\theta\, r", "sin should be cos"),
        ("polar.jacobian[0,1]", r"\sin\beta\, r", "sign"),
        ("polar.covariance.linear[0,0]", r"\cos\theta\, q + \sin^2\theta\, r^2\sigma_\theta^2", "cos(theta)**2"),
        ("motion.turn.known_rate.transition[0,1]", r"\frac{\cos\omega\, T_s}{\omega}", "cos should be sin"),
    ],
)
def test_what_is_wrong_in_every_way_is_told_in_the_way_that_leaves_least_to_explain(
    name: str, formula: str, edit: str
) -> None:
    found = check(name, formula, latex=True, given={} if "covariance" not in name else {"rho": "0"})
    assert found.verdict in {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}
    assert edit in f"{found.reason} {[one.edit for one in found.suggestions]}"


@pytest.mark.parametrize("formula", [r"\cos\theta^2 r", r"\cos\theta\, k m n", r"r + \cos\beta\sin q\beta\, r^3"])
def test_what_no_way_explains_is_refused(formula: str) -> None:
    with pytest.raises(FormulaError):
        verdict("polar.map[0]", formula)
