"""The verdicts on formulas of the literature and of libraries, and whether what is called wrong is wrong.

What differs is computed a second time without the engine: the printed formula in NumPy, and the truth by quadrature,
differences, sums over fine steps or random draws.
"""

import re
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
import pytest

from radartrack.derive.checking.papers.audit import decide, decisions
from radartrack.derive.checking.papers.claim import Claim
from radartrack.derive.checking.papers.claims_file import ClaimsFile, read_claims, shipped
from radartrack.derive.checking.question.declared_world import world_of
from radartrack.derive.checking.question.world import CATALOGUE, World
from radartrack.derive.checking.reporting.verdict import Verdict

Point = Mapping[str, float]
Values = tuple[np.ndarray, np.ndarray]  # as printed, and as it is

FILES = [*shipped("literature"), *shipped("libraries")]
OTHER_CONVENTION = {
    "tcl.turn.transition": "wrong_dimensions",
    "tcl.turn.jacobian": "wrong_dimensions",
    "tcl.jacobian.spherical.from_x": "differs",
}
NOT_PROVED = {  # roots within a cube root, which the algebra does not decide
    "kalata.alpha_beta_gamma.relations",
    "kalata.alpha_beta_gamma.cubic",
    "kalata.alpha_beta_gamma.root",
    "tracklib.alpha_beta",
    "tracklib.alpha_beta_gamma",
}
WRONG = {
    "tcl.ruv.half_range": "differs",
    "tcl.ruv.cm2.zz": "differs",
    "tcl.ruv.cm2.original.zz": "wrong_dimensions",
    "tcl.ruv.cm2.original.xz": "differs",
    "lankhorst.tracking_index": "differs",
    "tcl.turn.mean_rate": "wrong_dimensions",
    "tcl.turn.simple_mean": "wrong_dimensions",
    "tcl.turn.jacobian.straight": "differs",
    "tcl.turn.noise": "differs",
    "stone_soup.known_turn.equation": "differs",
    "stone_soup.constant_turn.transition": "differs",
    "stone_soup.elevation_rate.documentation": "wrong_dimensions",
    "filterpy.fading.variances.1": "wrong_dimensions",
    "filterpy.fading.lag.1": "wrong_dimensions",
    "filterpy.ghk.variance.x": "differs",
    "filterpy.ghk.variance.dx": "wrong_dimensions",
    "filterpy.ghk.variance.prediction": "differs",
    "filterpy.ghk.batch": "differs",
    "python_robotics.ekf.jacobian": "differs",
    "python_robotics.ekf_scale.jacobian": "differs",
    "python_robotics.slam.covariance": "wrong_dimensions",
    "autoware.bicycle.map": "differs",
    "autoware.bicycle.noise": "differs",
}
ALL_CLAIMS = {claim.id: (paper, claim) for paper in map(read_claims, FILES) for claim in paper.claims}


def expected(claim: Claim) -> str:
    """The verdict that a claim must have."""
    if claim.undecided:
        return "undecided"
    return {**WRONG, **OTHER_CONVENTION, **dict.fromkeys(NOT_PROVED, "equal_numerically")}.get(claim.id, "equal")


def world(paper: ClaimsFile) -> World:
    return world_of(paper.declared) if paper.declared else CATALOGUE


def verdict_on(name: str) -> Verdict:
    paper, claim = ALL_CLAIMS[name]
    return decide(claim, world(paper))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_the_verdict_on_every_claim(path: Path) -> None:
    paper = read_claims(path)
    its_world = world(paper)
    for claim in paper.claims:
        assert (claim.id, next(decisions(claim, its_world)).verdict) == (claim.id, expected(claim))


@pytest.mark.parametrize("name", sorted(OTHER_CONVENTION))
def test_what_is_right_in_another_convention_is_said_to_be(name: str) -> None:
    assert any(remark.startswith("equal with") for remark in verdict_on(name).remarks)


def test_all_claims_say_where_they_were_seen() -> None:
    for path in FILES:
        paper = read_claims(path)
        assert paper.seen or all(claim.seen for claim in paper.claims)
        assert paper.kind == ("library" if path.parent.name == "libraries" else "paper")
        assert all(claim.file for claim in paper.claims) or paper.kind == "paper"


def test_what_is_wrong_says_what_a_radar_sees_and_has_a_page() -> None:
    for name in WRONG:
        claim: Claim = ALL_CLAIMS[name][1]
        assert claim.matters
        assert (Path(__file__).parents[4] / "docs" / "findings" / f"{claim.finding}.md").is_file()


def test_the_scoreboard_of_the_documents_has_these_verdicts() -> None:
    page = (Path(__file__).parents[4] / "docs" / "scoreboard.html").read_text(encoding="utf-8")
    told = {name: verdict for verdict, name in re.findall(r'<article class="(\w+)" id="([^"]+)">', page)}
    assert told == {name: expected(claim) for name, (_, claim) in ALL_CLAIMS.items()}, (
        "make scoreboard writes the page anew"
    )


# What is called wrong, computed without the engine.


def half_range(at: Point) -> Values:
    measured = np.array([[at["r_1"], at["r_2"]], [0.1, 0.2], [0.3, 0.1]])
    elements = measured.ravel(order="F").copy()
    elements[0] /= 2  # zMeas(1)=zMeas(1)/2
    return elements.reshape(measured.shape, order="F")[0], measured[0] / 2


def second_order_covariance(at: Point) -> np.ndarray:
    """Of the position cut off after its second-order terms, by quadrature; the derivatives are central differences."""

    def position(r: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray:
        return r * np.array([u, v, np.sqrt(1 - u**2 - v**2)])

    centre = np.array([at["r"], at["u"], at["v"]])
    steps = np.array([at["r"], 1.0, 1.0]) * 1e-4
    moves = np.diag(steps)
    first = np.array([position(*(centre + one)) - position(*(centre - one)) for one in moves]) / (2 * steps[:, None])
    second = np.array(
        [
            [
                position(*(centre + a + b))
                - position(*(centre + a - b))
                - position(*(centre - a + b))
                + position(*(centre - a - b))
                for b in moves
            ]
            for a in moves
        ]
    ) / (4 * np.outer(steps, steps)[..., None])
    nodes, weights = np.polynomial.hermite_e.hermegauss(5)
    errors = np.stack(np.meshgrid(nodes, nodes, nodes, indexing="ij"), -1).reshape(-1, 3)
    errors = errors * [at["sigma_r"], at["sigma_u"], at["sigma_v"]]
    weight = np.einsum("i,j,k->ijk", weights, weights, weights).ravel() / weights.sum() ** 3
    values = errors @ first + np.einsum("ni,ijk,nj->nk", errors, second, errors) / 2
    apart = values - weight @ values
    return np.einsum("n,ni,nj->ij", weight, apart, apart)


def second_order(at: Point) -> Values:
    r, u, v = at["r"], at["u"], at["v"]
    s_r, s_u, s_v = at["sigma_r"] ** 2, at["sigma_u"] ** 2, at["sigma_v"] ** 2
    w = np.sqrt(1 - u**2 - v**2)
    linear = w**2 * s_r + (r * u / w) ** 2 * s_u + (r * v / w) ** 2 * s_v
    with_range = (u / w) ** 2 * s_r * s_u + (v / w) ** 2 * s_r * s_v
    mixed = r**2 / 2 * (u**2 * v**2 / w**6 - (u**2 + v**2) / w**4 - 1 / w**2) * s_u * s_v
    squares = [r**2 / 2 * (one**4 / w**6 + 2 * one**2 / w**4 + 1 / w**2) for one in (u, v)]
    printed = linear + with_range + mixed + squares[0] * s_u**2 + squares[1] * s_v**2
    return np.array(printed), second_order_covariance(at)[2, 2]


def second_order_of_2009(at: Point) -> Values:
    r, u, v = at["r"], at["u"], at["v"]
    s_r, s_u, s_v = at["sigma_r"] ** 2, at["sigma_u"] ** 2, at["sigma_v"] ** 2
    w = np.sqrt(1 - u**2 - v**2)
    z_uu, z_vv, z_uv = r * (v**2 - 1) / w**3, r * (u**2 - 1) / w**3, -r * u * v / w**3
    c_z = z_uu * s_u / 2 + z_vv * s_v / 2
    printed = c_z**2 + w**2 * s_r + (r * u / w) ** 2 * s_u + (r * v / w) ** 2 * s_v + c_z * (z_uu * s_u + z_vv * s_v)
    printed += 0.75 * z_uu * s_u**2 + 0.75 * z_vv * s_v**2
    printed += (u / w) ** 2 * s_r * s_u + (v / w) ** 2 * s_r * s_v + z_uv**2 * s_u * s_v
    return np.array(printed), second_order_covariance(at)[2, 2]


def covariances_with_z(at: Point) -> Values:
    r, u, v = at["r"], at["u"], at["v"]
    w = np.sqrt(1 - u**2 - v**2)
    printed = [
        w * one * at["sigma_r"] ** 2 - r**2 * one / w * at[f"sigma_{name}"] ** 2 for one, name in ((u, "u"), (v, "v"))
    ]
    return np.array(printed), second_order_covariance(at)[:2, 2]


def tracking_index(at: Point) -> Values:
    """The gains of the Kalman filter, scan by scan until they stay."""
    index = at["index"]
    b, c = index / 2 - 3, index / 2 + 3
    p, q = c - b**2 / 3, 2 * b**3 / 27 - b * c / 3 - 1
    z = -((q + np.sqrt(q**2 + 4 * p**3 / 27) / 2) ** (1 / 3))
    s = z - p / (3 * z) - b / 3
    motion, jump = np.array([[1, 1, 0.5], [0, 1, 1], [0, 0, 1]]), index * np.array([0.5, 1, 1])
    covariance = np.eye(3)
    for _ in range(3000):
        filtered = covariance - np.outer(covariance[0], covariance[0]) / (covariance[0, 0] + 1)
        covariance = motion @ filtered @ motion.T + np.outer(jump, jump)
    printed = np.array([1 - s**2, 2 * (1 - s) ** 2, 2 * (1 - s) ** 4 / (1 - s**2)])
    return printed, covariance[0] / (covariance[0, 0] + 1)


def mean_rate(at: Point) -> Values:
    T, tau, omega = at["T"], at["tau"], at["omega"]
    t = (np.arange(100_000) + 0.5) * T / 100_000
    return np.array((tau - np.exp(-T / tau) * tau + T * omega) / T), np.array(np.mean(omega * np.exp(-t / tau)))


def simple_mean(at: Point) -> Values:
    T, tau, omega = at["T"], at["tau"], at["omega"]
    return np.array((np.exp(-T / tau) + 1) * omega / T), np.array(np.mean([omega, omega * np.exp(-T / tau)]))


def straight_turn(at: Point) -> Values:
    """Of y by the turn rate at zero, for a velocity of -1 along x."""
    step = 1e-4 / at["T"]
    y = [-(1 - np.cos(rate * at["T"])) / rate for rate in (step, -step)]
    return np.array(at["T"] ** 2 / 2), np.array((y[0] - y[1]) / (2 * step))


def turn_noise(at: Point) -> Values:
    T, draws = at["T"], np.sqrt(3) * np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    deviations = np.array([at["sigma_V"], at["sigma_V"], at["sigma_turn"]])
    # three accelerations that are independent: points ± √3 σ along each axis have their covariance
    moved = []
    for draw in [*draws, *-draws]:
        a_x, a_y, a_turn = draw * deviations
        moved.append([a_x * T**2 / 2, a_y * T**2 / 2, a_x * T, a_y * T, a_turn * T])
    column = np.array([T**2 / 2 * at["sigma_V"]] * 2 + [T * at["sigma_V"]] * 2 + [T * at["sigma_turn"]])
    return np.outer(column, column), np.array(moved).T @ np.array(moved) / 6


def turned(at: Point, T: float) -> np.ndarray:
    """Where unit states come in a turn, step by step by its differential equation, with midpoints."""

    def rate(state: np.ndarray) -> np.ndarray:
        _, vx, _, vy = state
        return np.array([vx, -at["omega"] * vy, vy, at["omega"] * vx])

    steps = 20_000
    state = np.eye(4)
    for _ in range(steps if T else 0):
        state = state + T / steps * rate(state + T / steps / 2 * rate(state))
    return state


def equation_of_turn(at: Point) -> Values:
    omega = at["omega"]
    printed = np.array([[0, 1, 0, 0], [0, 0, -omega, 0], [0, 0, 0, 1], [omega, 0, 0, 0]])
    step = 1e-6
    s, c = np.sin(omega * step), np.cos(omega * step)
    after = np.array(
        [[1, s / omega, 0, (c - 1) / omega], [0, c, 0, -s], [0, (1 - c) / omega, 1, s / omega], [0, s, 0, c]]
    )
    assert after == pytest.approx(turned(at, step), abs=1e-12)
    return printed, (after - np.eye(4)) / step


def transition_of_turn(at: Point) -> Values:
    omega, T = at["omega"], at["T"]
    s, c = np.sin(omega * T), np.cos(omega * T)
    printed = [[1, s / omega, 0, (c - 1) / omega], [0, c, 0, -s], [0, (1 - c) / omega, 1, s / omega], [0, s, 0, s]]
    return np.array(printed), turned(at, T)


def elevation_rate(at: Point) -> Values:
    position, velocity = np.array([at["x"], at["y"], at["z"]]), np.array([at["vx"], at["vy"], at["vz"]])
    p = np.hypot(at["x"], at["y"])
    printed = at["vy"] * p - (at["x"] * at["vx"] + at["y"] * at["vy"]) / p * at["z"]
    step = 1e-4 * np.linalg.norm(position) / np.linalg.norm(velocity)
    ahead, behind = position + step * velocity, position - step * velocity
    angles = [np.arctan2(one[2], np.hypot(one[0], one[1])) for one in (ahead, behind)]
    return np.array(printed / np.linalg.norm(position)), np.array((angles[0] - angles[1]) / (2 * step))


def fading_gains(at: Point) -> np.ndarray:
    """Of the filter of order 1: the matrix that carries its state on, and beside it what a residual adds."""
    b, T = at["theta"], at["T"]
    gain = np.array([1 - b**2, (1 - b) ** 2 / T])
    return np.column_stack([(np.eye(2) - np.outer(gain, [1, 0])) @ [[1, T], [0, 1]], gain])


def fading_variances(at: Point) -> Values:
    b = at["theta"]
    carried = fading_gains(at)
    covariance = np.zeros((2, 2))
    for _ in range(3000):
        covariance = carried[:, :2] @ covariance @ carried[:, :2].T + np.outer(carried[:, 2], carried[:, 2])
    printed = [(1 - b) * (1 + 4 * b + 5 * b**2) / (1 + b) ** 3, 2 * (1 - b) ** 3 / (1 + b) ** 3]
    return np.array(printed), np.diag(covariance)


def ghk_variances(at: Point) -> Values:
    """Of position, velocity and predicted position, of a filter that ran long; the period is none of some examples."""
    g, h, k, T = at["g"], at["h_g"], at["k_g"], at.get("T", 2.0)
    motion, gain = np.array([[1, T, T**2 / 2], [0, 1, T], [0, 0, 1]]), np.array([g, h / T, 2 * k / T**2])
    carried = (np.eye(3) - np.outer(gain, [1, 0, 0])) @ motion
    covariance = np.zeros((3, 3))
    for _ in range(5000):
        covariance = carried @ covariance @ carried.T + np.outer(gain, gain)
    u, y, s = 4 - 2 * g - h, g * h + g * k - 2 * k, 2 * g + h
    printed = [
        (2 * h * (2 * g**2 + 2 * h - 3 * g * h) - 2 * g * k * u) / (2 * k - g * (h + k) * u),
        (2 * h**3 - 4 * h**2 * k + 4 * k**2 * (2 - g)) / (2 * u * y),
        (g * k * (s - 4) + h * (g * s + 2 * h)) / (2 * k - (g * (h + k) * (s - 4))),
    ]
    return np.array(printed), np.array([*np.diag(covariance)[:2], (motion @ covariance @ motion.T)[0, 0]])


def one_of(values: Callable[[Point], Values], place: int) -> Callable[[Point], Values]:
    return lambda at: (values(at)[0][place], values(at)[1][place])


def batch(at: Point) -> Values:
    T = at["T"]
    t = (np.arange(1000) + 0.5) * T / 1000
    return np.array(at["x"] + at["dx"] * T), np.array(at["x"] + np.mean(at["dx"] + at["ddx"] * t) * T)


def robot_jacobian(at: Point) -> Values:
    """Of a state whose last component scales the speed, or is one that nothing rests on."""
    T, yaw, v, scale = at["T"], at["yaw"], at["speed_in"], at.get("scale", 1.0)
    c, s = np.cos(yaw), np.sin(yaw)

    def motion(state: np.ndarray) -> np.ndarray:
        step = T * v * state[4]
        return np.array([state[0] + step * np.cos(state[2]), state[1] + step * np.sin(state[2]), state[2], v, state[4]])

    state, step = np.array([0.0, 0.0, yaw, 1.0, scale]), 1e-5
    columns = [(motion(state + step * one) - motion(state - step * one)) / (2 * step) for one in np.eye(5)]
    along, across = [T * scale * c, T * v * c], [T * scale * s, T * v * s]
    printed = [[1, 0, -T * v * scale * s, *along], [0, 1, T * v * scale * c, *across]]
    kept = slice(5 if "scale" in at else 4)
    return np.array([*printed, *np.eye(5)[2:]])[kept, kept], np.array(columns).T[kept, kept]


def slam_covariance(at: Point) -> Values:
    """By points at ± √3 deviations along each axis, which a linear motion carries on."""
    T, yaw, v = at["T"], at["yaw"], at["speed_in"]
    deviations = np.diag([at["s_x"], at["s_y"], at["s_yaw"]])
    G = np.array([[1, 0, -T * v * np.sin(yaw)], [0, 1, T * v * np.cos(yaw)], [0, 0, 1]])
    side = T * v * np.array([-np.sin(yaw), np.cos(yaw), 0])
    moved = [sign * np.sqrt(3) * (one + one[2] * side) for one in deviations for sign in (1, -1)]
    return G.T @ deviations**2 @ G, np.array(moved).T @ np.array(moved) / 6


def bicycle(at: Point) -> Values:
    """To second order in the period: the second difference of the circle at its beginning."""
    T, v, course = at["T"], at["speed"], at["yaw"] + at["slip"]
    w = v * np.sin(at["slip"]) / at["l_r"]

    def place(t: float) -> np.ndarray:
        angle = course + w * (np.arange(2_000) + 0.5) * t / 2_000
        return v * t * np.array([np.mean(np.cos(angle)), np.mean(np.sin(angle))])

    step = 1e-3 / (1 + abs(w))
    speed, push = (place(step) - place(-step)) / (2 * step), (place(step) + place(-step)) / step**2
    side = np.array([-np.sin(at["slip"]), np.cos(at["slip"])])
    return v * T * np.array([np.cos(course), np.sin(course)]) + v * w * T**2 / 2 * side, speed * T + push * T**2 / 2


def bicycle_noise(at: Point) -> Values:
    c, s, long, across = np.cos(at["yaw"] + at["slip"]), np.sin(at["yaw"] + at["slip"]), at["q_long"], at["q_lat"]
    mixed = (long - across) * np.sin(2 * at["yaw"]) / 2
    axes = [np.sqrt(long) * np.array([c, s]), np.sqrt(across) * np.array([-s, c])]  # along the course and across
    printed = np.array([[long * c**2 + across * s**2, mixed], [mixed, long * s**2 + across * c**2]])
    return printed, np.sum([np.outer(axis, axis) for axis in axes], axis=0)


ORACLES: Mapping[str, Callable[[Point], Values]] = {
    "tcl.ruv.half_range": half_range,
    "tcl.ruv.cm2.zz": second_order,
    "tcl.ruv.cm2.original.zz": second_order_of_2009,
    "tcl.ruv.cm2.original.xz": covariances_with_z,
    "lankhorst.tracking_index": tracking_index,
    "tcl.turn.mean_rate": mean_rate,
    "tcl.turn.simple_mean": simple_mean,
    "tcl.turn.jacobian.straight": straight_turn,
    "tcl.turn.noise": turn_noise,
    "stone_soup.known_turn.equation": equation_of_turn,
    "stone_soup.constant_turn.transition": transition_of_turn,
    "stone_soup.elevation_rate.documentation": elevation_rate,
    "filterpy.fading.variances.1": fading_variances,
    "filterpy.ghk.variance.x": one_of(ghk_variances, 0),
    "filterpy.ghk.variance.dx": one_of(ghk_variances, 1),
    "filterpy.ghk.variance.prediction": one_of(ghk_variances, 2),
    "filterpy.ghk.batch": batch,
    "python_robotics.ekf.jacobian": robot_jacobian,
    "python_robotics.ekf_scale.jacobian": robot_jacobian,
    "python_robotics.slam.covariance": slam_covariance,
    "autoware.bicycle.map": bicycle,
    "autoware.bicycle.noise": bicycle_noise,
}


@pytest.mark.parametrize("name", sorted(ORACLES))
def test_what_differs_differs_without_the_engine(name: str) -> None:
    paper, claim = ALL_CLAIMS[name]
    example = next(decisions(claim, world(paper))).counterexample
    assert example is not None
    assert example.printed is not None
    printed, right = (np.asarray(values)[example.entry] for values in ORACLES[name](example.point))
    near = 2e-5 * max(abs(example.printed), abs(example.derived))
    assert float(printed) == pytest.approx(example.printed, abs=near)
    assert float(right) == pytest.approx(example.derived, abs=near)
    assert abs(printed - right) > 10 * near


def test_the_lag_of_a_fading_memory_filter_without_the_engine() -> None:
    """The only one that the engine decides by equations: a filter that runs behind x = a_2 t^2."""
    at = {"theta": 0.7, "T": 0.5, "a_2": 3.0}
    carried = fading_gains(at)
    state = np.zeros(2)
    for n in range(1, 400):
        state = carried[:, :2] @ state + carried[:, 2] * at["a_2"] * (n * at["T"]) ** 2
    truth = np.array([at["a_2"] * (399 * at["T"]) ** 2, 2 * at["a_2"] * 399 * at["T"]])
    b = at["theta"]
    printed = at["a_2"] * np.array([2 * at["T"] * 2 * (b / (1 - b)) ** 2, at["T"] * (1 + 3 * b) / (1 - b)])
    repaired = at["a_2"] * 2 * at["T"] ** 2 * (b / (1 - b)) ** 2
    lag = truth - state
    assert lag == pytest.approx([repaired, printed[1]], rel=1e-8)
    assert abs(lag[0] - printed[0]) > 1.0
    assert set(ORACLES) | {"filterpy.fading.lag.1"} == set(WRONG)
