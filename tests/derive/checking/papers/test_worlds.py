"""Papers with a sensor, a motion or a filter of their own: three right claims each and three wrong ones.

What is right was not found by this engine: it comes from numerical derivatives, exponentials and integrals of mpmath,
and from recursions that are run until they settle.
"""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import mpmath
import pytest
from mpmath import cos, diff, matrix, mpf, sin, sqrt

from radartrack.derive.checking.papers.audit import decisions
from radartrack.derive.checking.papers.claim import Claim
from radartrack.derive.checking.papers.claims_file import read_claims
from radartrack.derive.checking.question.declared_world import world_of
from radartrack.derive.formula.tree import Array, Name, Tree, names, parts
from radartrack.derive.reading.text import read_text
from tests.derive.checking.own_values import worth

WORLDS = sorted((Path(__file__).parents[1] / "worlds").glob("*.toml"))
Point = Mapping[str, Any]
CLAIMS = [(path, claim) for path in WORLDS for claim in read_claims(path).claims]


def evaluated(text: str, point: Point, let: Mapping[str, str]) -> Any:
    """A formula without verbs at a point, with definitions put in, by the evaluator of the tests."""
    tree = read_text(text, {*point, *let, *(name for name in _words(text))})
    known = dict(point)
    for name in names(tree) - known.keys():
        known[name] = evaluated(let[name], point, let)
    return _nested(tree, known)


def _words(text: str) -> Iterator[str]:
    return (word for word in ("lambda",) if word in text)


def _nested(tree: Tree, point: Point) -> Any:
    if isinstance(tree, Array):
        return [_nested(entry, point) for entry in tree.entries]
    assert all(node.name in point for node in parts(tree) if isinstance(node, Name))
    return worth(tree, point)


def partial(function: Callable[..., Any], point: Point, *by: str) -> Any:
    """Numerical derivatives of a function of a point: one, or a list; of a vector one row an entry."""

    def of(one: Callable[[Point], Any], name: str) -> Any:
        return diff(lambda value: one({**point, name: value}), point[name])

    def gradient(one: Callable[[Point], Any]) -> Any:
        found = [of(one, name) for name in by]
        return found if len(found) > 1 else found[0]

    value = function(point)
    if not isinstance(value, list):
        return gradient(function)
    return [gradient(_entry(function, place)) for place in range(len(value))]


def _entry(function: Callable[..., Any], place: int) -> Callable[[Point], Any]:
    return lambda at: function(at)[place]


def bistatic(p: Point) -> Any:
    """The range of the receiver by the law of cosines: where transmitter and receiver together make the sum."""
    return mpmath.findroot(
        lambda r: r + sqrt(r**2 + p["L"] ** 2 - 2 * r * p["L"] * cos(p["theta"])) - p["S"], p["S"] / 2
    )


def rate(p: Point) -> Any:
    return diff(lambda t: sqrt(sum((p[i] + t * p[f"v{i}"]) ** 2 for i in "xyz")), 0)


def legs(p: Point) -> tuple[Any, Any]:
    first, second = (sqrt((p["x"] + side * p["a"]) ** 2 + p["y"] ** 2) for side in (-1, 1))
    return first, second


def rates(p: Point) -> Any:
    first, second = (
        ((p["x"] + side * p["a"]) * p["vx"] + p["y"] * p["vy"]) / leg
        for side, leg in zip((-1, 1), legs(p), strict=True)
    )
    return first - second


def turned(p: Point) -> list[Any]:
    """The state after a turn, from the velocity that turns, integrated."""

    def velocity(t: Any) -> tuple[Any, Any]:
        c, s = cos(p["omega"] * t), sin(p["omega"] * t)
        return p["vx"] * c - p["vy"] * s, p["vx"] * s + p["vy"] * c

    path = [mpmath.quad(lambda t, i=i: velocity(t)[i], [0, p["T"]]) for i in (0, 1)]
    end = velocity(p["T"])
    return [p["x"] + path[0], end[0], p["y"] + path[1], end[1], p["omega"]]


def turn_matrix(p: Point) -> Any:
    w = p["omega"]
    return mpmath.expm(matrix([[0, 1, 0, 0], [0, 0, 0, -w], [0, 0, 0, 1], [0, w, 0, 0]]) * p["T"]).tolist()


def straight(p: Point) -> Any:
    """The derivative of x by the turn rate where that is small."""
    return partial(lambda at: turned(at)[0], {**p, "omega": mpf("1e-9")}, "omega")


def singer(p: Point, t: Any) -> Any:
    return mpmath.expm(matrix([[0, 1, 0], [0, 0, 1], [0, 0, -p["alpha"]]]) * t)


def singer_noise(row: int, column: int) -> Callable[[Point], Any]:
    def integral(p: Point) -> Any:
        intensity = 2 * p["alpha"] * p["sigma_m"] ** 2
        return intensity * mpmath.quad(lambda t: singer(p, t)[row, 2] * singer(p, t)[column, 2], [0, p["T"]])

    return integral


def steady_gains(p: Point) -> list[Any]:
    """The gains of a Kalman filter with unit period and unit errors, run until they settle."""
    transition, noise = matrix([[1, 1], [0, 1]]), p["lambda"] ** 2 * matrix([[0.25, 0.5], [0.5, 1]])
    predicted = matrix([[1, 0], [0, 1]])
    for _ in range(400):
        gain = predicted[:, 0] / (predicted[0, 0] + 1)
        predicted = transition * (predicted - gain * predicted[0, :]) * transition.T + noise
    gain = predicted[:, 0] / (predicted[0, 0] + 1)
    return [gain[0], gain[1]]


def ecef(p: Point) -> list[Any]:
    """A point above the ellipse: its foot is where the normal has the latitude; found by the slope of the ellipse."""
    b = p["a"] * sqrt(1 - p["ee"])
    u = mpmath.atan(b / p["a"] * mpmath.tan(p["phi"]))  # the eccentric angle of the foot
    out, up = p["a"] * cos(u) + p["h"] * cos(p["phi"]), b * sin(u) + p["h"] * sin(p["phi"])
    return [out * cos(p["lon"]), out * sin(p["lon"]), up]


def normal_radius(p: Point) -> Any:
    """From the foot along the normal to the axis."""
    at = {**p, "h": mpf(0), "lon": mpf(0)}
    return ecef(at)[0] / cos(p["phi"])


def fused(p: Point) -> Any:
    """The variance of the best unbiased combination of two tracks, by its definition."""

    def variance(k: Any) -> Any:
        return (1 - k) ** 2 * p["p"] + k**2 * p["q"] + 2 * k * (1 - k) * p["c"]

    best = mpmath.findroot(lambda k: diff(variance, k), 0.5)
    return variance(best)


def fused_matrix(p: Point) -> Any:
    first, second = matrix([[p["p"], p["s"]], [p["s"], p["t"]]]), matrix([[p["q"], 0], [0, p["t"]]])
    cross = matrix([[p["c"], 0], [0, 0]])
    gain = (first - cross) * mpmath.inverse(first + second - cross - cross.T)
    left = mpmath.eye(2) - gain
    whole = left * first * left.T + gain * second * gain.T + left * cross * gain.T + gain * cross.T * left.T
    return whole[0, 0]


def weights(p: Point, power: int) -> Any:
    return sum(mpf(n) ** power * p["theta"] ** n for n in range(int(p["k"])))


def at_point(numbers: str) -> dict[str, Any]:
    return {name: mpf(value) for name, value in (pair.split("=") for pair in numbers.split())}


JACOBIAN = ("x", "vx", "y", "vy", "omega")
POINTS = {
    "bistatic_radar": at_point("S=70000 L=9000 theta=0.7"),
    "range_rate": at_point("x=3000 y=-4000 z=1000 vx=100 vy=50 vz=-20"),
    "tdoa_fdoa": at_point("x=3000 y=-4000 vx=100 vy=50 a=700"),
    "coordinated_turn": at_point("x=3000 y=-4000 vx=100 vy=50 omega=0.2 T=3"),
    "singer": at_point("alpha=0.4 T=2 sigma_m=3"),
    "kalata": at_point("lambda=0.7"),
    "geodetic": at_point("phi=0.6 lon=-0.9 h=5000 a=6378137 ee=0.1"),
    "correlated_tracks": at_point("p=4 q=7 c=0.5 s=0.6 t=3"),
    "discounted_least_squares": at_point("theta=0.8 k=9"),
}
TRUTH: dict[str, Callable[[Point], Any]] = {
    "bistatic.range.by_sum": lambda p: partial(bistatic, p, "S"),
    "bistatic.range.by_angle": lambda p: partial(bistatic, p, "theta"),
    "bistatic.other_leg": lambda p: bistatic(p) ** 2 + p["L"] ** 2 - 2 * bistatic(p) * p["L"] * cos(p["theta"]),
    "bistatic.wrong.sign": lambda p: partial(bistatic, p, "S"),
    "bistatic.wrong.square": lambda p: partial(bistatic, p, "theta"),
    "bistatic.wrong.function": lambda p: partial(lambda at: bistatic(at) * sin(at["theta"]), p, "S"),
    "rate.gradient": lambda p: partial(rate, p, "x", "y", "z", "vx", "vy", "vz"),
    "rate.wrong.index": lambda p: partial(rate, p, "x", "y", "z", "vx", "vy", "vz"),
    **dict.fromkeys(
        ("rate.by_x", "rate.by_x.components", "rate.wrong.sign", "rate.wrong.power"), lambda p: partial(rate, p, "x")
    ),
    **dict.fromkeys(
        ("tdoa.gradient", "tdoa.wrong.sign"), lambda p: partial(lambda at: legs(at)[0] - legs(at)[1], p, "x", "y")
    ),
    **dict.fromkeys(("fdoa.by_x", "fdoa.wrong.square", "fdoa.wrong.index"), lambda p: partial(rates, p, "x")),
    "fdoa.by_velocity": lambda p: partial(rates, p, "vx", "vy"),
    "turn.jacobian": lambda p: partial(turned, p, *JACOBIAN),
    "turn.transition": turn_matrix,
    "turn.straight": straight,
    "turn.wrong.sign": lambda p: partial(turned, p, "omega")[0],
    "turn.wrong.square": lambda p: partial(turned, p, "omega")[2],
    "turn.wrong.index": lambda p: partial(turned, p, "omega")[3],
    "singer.F": lambda p: singer(p, p["T"]).tolist(),
    "singer.wrong.sign": lambda p: singer(p, p["T"])[0, 2],
    "singer.q11": singer_noise(0, 0),
    "singer.q12": singer_noise(0, 1),
    "singer.wrong.square": singer_noise(0, 1),
    "singer.wrong.index": singer_noise(1, 1),
    **dict.fromkeys(
        ("kalata.gains", "kalata.gains.by_root", "kalata.wrong.sign", "kalata.wrong.square", "kalata.wrong.index"),
        steady_gains,
    ),
    "kalata.beta": lambda p: steady_gains(p)[1],
    "ecef.jacobian": lambda p: partial(ecef, p, "phi", "lon", "h"),
    "ecef.volume": lambda p: mpmath.det(matrix(partial(ecef, p, "phi", "lon", "h"))),
    "ecef.normal_radius": lambda p: partial(normal_radius, p, "phi"),
    "ecef.wrong.square": lambda p: partial(normal_radius, p, "phi"),
    "ecef.wrong.sign": lambda p: partial(ecef, p, "phi")[0],
    "ecef.wrong.radius": lambda p: partial(ecef, p, "phi")[2],
    **dict.fromkeys(("campo.covariance", "campo.wrong.sign", "campo.wrong.square", "campo.wrong.index"), fused),
    "campo.weights": lambda p: [fused(p)],
    "campo.matrix": fused_matrix,
    **dict.fromkeys(
        ("fading.weight", "fading.equivalent", "fading.wrong.sign", "fading.wrong.index"), lambda p: weights(p, 0)
    ),
    **dict.fromkeys(("fading.moment", "fading.wrong.square"), lambda p: weights(p, 1)),
}


def close(first: Any, second: Any) -> bool:
    if isinstance(first, list):
        return len(first) == len(second) and all(map(close, first, second))
    return bool(abs(first - second) <= mpf("1e-6") * max(abs(first), abs(second)) + mpf("1e-12"))


@pytest.mark.parametrize(("path", "claim"), CLAIMS, ids=[claim.id for _, claim in CLAIMS])
def test_a_claim_is_right_where_other_means_say_so_and_wrong_where_they_do_not(path: Path, claim: Claim):
    data = tomllib.loads(path.read_text())
    printed = evaluated(claim.right or claim.formula, POINTS[path.stem], data["let"])
    with mpmath.workdps(20):
        is_right = close(printed, TRUTH[claim.id](POINTS[path.stem]))
    assert is_right is (".wrong." not in claim.id)
    verdict = next(decisions(claim, world_of([data])))
    assert verdict.verdict in ({"equal"} if is_right else {"differs", "wrong_dimensions"})


def test_every_world_has_three_right_claims_and_three_wrong_ones():
    assert len(WORLDS) == 9
    for path in WORLDS:
        wrong = [".wrong." in claim.id for claim in read_claims(path).claims]
        assert (wrong.count(False), wrong.count(True)) == (3, 3)


@pytest.mark.parametrize("letter", ["theta", "phi", "az"])
def test_a_declared_letter_is_the_symbol_of_a_quantity_of_ours_where_it_means_that(letter: str, tmp_path: Path) -> None:
    file = tmp_path / "claims.toml"
    file.write_text(
        f"""paper = "P"
[symbols]
{letter} = {{ unit = "rad", low = -3, high = 3, meaning = "angle" }}
[[claim]]
id = "right"
quantity = "polar.map"
formula = "[r*cos({letter}), r*sin({letter})]"
[[claim]]
id = "wrong"
quantity = "polar.map"
formula = "[r*cos({letter}), -r*sin({letter})]"
"""
    )
    claims = read_claims(file).claims
    right, wrong = ([*decisions(claim, world_of([tomllib.loads(file.read_text())]))][-1] for claim in claims)
    assert right.is_equal
    assert wrong.suggestions[0].edit == f"the sign of r*sin({letter})"
