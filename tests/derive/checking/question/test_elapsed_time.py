"""A period that is printed as the difference of two times, over notations and orders of these."""

import pytest

from radartrack.derive.checking.check import check
from radartrack.derive.checking.reporting.verdict import Outcome, Verdict
from radartrack.derive.formula.error import FormulaError

TIMES = [
    ("t_{k+1}", "t_k"),
    ("t_k", "t_{k-1}"),
    ("t_{n}", "t_{n-1}"),
    ("t_2", "t_1"),
    ("t_1", "t_0"),
    ("t", "t_0"),
    ("t", "t_k"),
]
TIMES += [("t(k+1)", "t(k)"), ("t_{k+2}", "t_{k+1}")]
TYPED = [("t2", "t1"), ("t_k", "t_km1"), ("t", "t0"), ("t_kp1", "t_k")]


def transition(period: str) -> Verdict:
    rows = rf"1 & {period} & \frac{{1}}{{2}}({period})^2 \\ 0 & 1 & {period} \\ 0 & 0 & 1"
    latex = rf"\begin{{bmatrix}} {rows} \end{{bmatrix}}"
    return check("motion.constant_acceleration.transition", latex, latex=True)


@pytest.mark.parametrize(("later", "earlier"), TIMES)
def test_the_difference_of_two_times_is_a_period_in_the_right_order(later: str, earlier: str):
    right = transition(f"{later} - {earlier}")
    assert right.verdict is Outcome.EQUAL
    assert sorted(words.partition(" for ")[2] for words in right.reading) == ["0", "T"]
    assert transition(f"-{earlier} + {later}").verdict is Outcome.EQUAL
    wrong = transition(f"{earlier} - {later}")
    assert wrong.verdict is Outcome.DIFFERS
    assert wrong.reading == right.reading


@pytest.mark.parametrize(("later", "earlier"), TYPED)
def test_so_it_is_where_it_is_typed_or_defined(later: str, earlier: str):
    name = "motion.singer.transition[2,2]"
    assert check(name, f"exp(-alpha*({later} - {earlier}))").verdict is Outcome.EQUAL
    assert check(name, "exp(-alpha*h)", let={"h": f"{later} - {earlier}"}).verdict is Outcome.EQUAL
    assert check(name, "exp(-alpha*T)", let={"T": f"{later} - {earlier}"}).verdict is Outcome.EQUAL
    assert check(name, f"exp(-alpha*({earlier} - {later}))").verdict is not Outcome.EQUAL
    code = f"dt = {later} - {earlier}\nF = np.exp(-alpha*dt)"
    assert check(name, code, code="python").verdict is Outcome.EQUAL


@pytest.mark.parametrize(
    "formula",
    [
        "exp(-alpha*(t2 - t1))*t2/t2",
        "exp(-alpha*t2)*exp(alpha*t1)",
        "exp(-alpha*(t_k - t_1))",
        "exp(-alpha*(t2 - t1 + t3))",
    ],
)
def test_times_of_which_more_is_said_are_asked_for(formula: str):
    with pytest.raises(FormulaError):
        check("motion.singer.transition[2,2]", formula)


@pytest.mark.parametrize(
    ("newer", "older"), [("z_k", "z_{k-1}"), ("z(k)", "z(k-1)"), ("z_{k+1}", "z_k"), ("z_2", "z_1"), ("z(1)", "z(0)")]
)
def test_plots_that_are_counted_by_time_are_not_exchanged(newer: str, older: str):
    name = "initiation.two_plots.estimate[1]"
    assert check(name, rf"\frac{{{newer} - {older}}}{{T}}", latex=True).verdict is Outcome.EQUAL
    assert check(name, rf"\frac{{{older} - {newer}}}{{T}}", latex=True).verdict is Outcome.DIFFERS
