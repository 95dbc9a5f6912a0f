"""Turns in the plane: the velocity turns at the rate omega, counter-clockwise, and keeps its size but for noise.

Textbooks print sin(ωT)/ω and (1 − cos ωT)/ω, which are 0/0 when nothing turns and lose their digits before. Written
are Stumpff's functions of ωT, which are finite there, and so are all derivatives by the rate, made of them again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from math import factorial

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.language.matrix import ONE, ZERO, Vector
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.shared_symbols import T as PERIOD
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable, angle, speed
from radartrack.derive.moments import taylor
from radartrack.derive.motion.linear_motion import LinearMotion, noise_of
from radartrack.derive.motion.motion_quantities import CONTINUOUS, PIECEWISE, State
from radartrack.derive.stable.term_sizes import term_sizes
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import METRE, METRE_PER_SECOND, RADIAN, SECOND, Unit
from radartrack.derive.verbs.integrals import integrated

T = PERIOD.below(10.0)  # less than a whole turn between scans: after one a position is as uncertain as ωT is rounded
SOURCE = cite("barshalom2001", "11.7")
PLANE = (METRE, METRE_PER_SECOND) * 2

omega = Variable("omega", "rate of the turn, counter-clockwise", RADIAN / SECOND, -0.5, 0.5)
q = Variable("q", "intensity of the white noise in the acceleration along each axis", METRE**2 / SECOND**3, 1e-9, 1e6)
sigma_w = Variable(
    "sigma_w",
    "standard deviation of the acceleration along each axis, constant over a period",
    METRE / SECOND**2,
    1e-6,
    1e3,
)
x, y = (Variable(name, f"position along the {name} axis", METRE, -1e6, 1e6) for name in "xy")
vx, vy = (speed(f"v{axis}", f"velocity along the {axis} axis", -1e3, 1e3) for axis in "xy")
v = speed("speed", "speed along the heading", -1e3, 1e3)
heading = angle("heading", "direction of the velocity, counter-clockwise from the x axis")

KNOWN = LinearMotion(
    (
        (ZERO, ONE, ZERO, ZERO),
        (ZERO, ZERO, ZERO, -omega),
        (ZERO, ZERO, ZERO, ONE),
        (ZERO, omega, ZERO, ZERO),
    ),
    (1, 3),
    omega,
)


def stumpff(order: int) -> Expr:
    """c_n of the angle turned through in a period."""
    return sp.stumpff(omega * T, sp.Integer(order))


COS, SIN = sp.cos(omega * T), sp.sin(omega * T)
AHEAD, ASIDE = T * stumpff(1), omega * T**2 * stumpff(2)  # ∫ cos ωs ds and ∫ sin ωs ds
LAG, DRIFT = T**2 * stumpff(2), omega * T**3 * stumpff(3)  # their integrals
WHITE = {  # ∫ over the period of products of what noise along the axes leaves; all others are zero
    (0, 0): 2 * T**3 * stumpff(3),
    (0, 1): LAG,
    (0, 3): DRIFT,
    (1, 1): T,
    (1, 2): -DRIFT,
    (2, 2): 2 * T**3 * stumpff(3),
    (2, 3): LAG,
    (3, 3): T,
}


def at_most(entry: Expr) -> Expr:
    """The sizes of the terms with every wave of ωT as large as it can be: c_n is never more than 1/n!."""
    size = term_sizes(entry)
    waves = (wave for wave in size.atoms(sp.cos, sp.sin) if omega in wave.free_symbols)
    tallest = dict.fromkeys(waves, ONE)
    tallest |= {wave: sp.Rational(1, factorial(int(wave.args[1]))) for wave in size.atoms(sp.stumpff)}
    return size.xreplace(tallest)


def turned() -> Tensor[Expr]:
    """F in functions that are finite at every rate."""
    rows = ((ONE, AHEAD, ZERO, -ASIDE), (ZERO, COS, ZERO, -SIN), (ZERO, ASIDE, ONE, AHEAD), (ZERO, SIN, ZERO, COS))
    return Tensor.build((4, 4), lambda m, n: rows[m][n])


def pushed() -> tuple[Vector, Vector]:
    """What a constant acceleration along x, and one along y, leaves after a period."""
    return (LAG, AHEAD, DRIFT, ASIDE), (-DRIFT, -ASIDE, LAG, AHEAD)


def moved(transition: Tensor[Expr]) -> Tensor[Expr]:
    """The state (x, vx, y, vy, omega) after a period."""
    state = (x, vx, y, vy)
    rows = (sp.Add(*(transition[m, n] * state[n] for n in range(4))) for m in range(4))
    return Tensor((5,), (*rows, omega))


@cache
def driven_ahead() -> Tensor[Expr]:
    """The state (x, y, speed, heading, omega) after a period: the integral of the velocity."""

    def along(wave: Callable[[Expr], Expr]) -> Expr:
        return sp.expand(integrated(sp.expand(omega * v * wave(heading + omega * T)), T, ZERO, T) / omega)

    return Tensor((5,), (x + along(sp.cos), y + along(sp.sin), v, heading + omega * T, omega))


def driven_finitely() -> Tensor[Expr]:
    """The same in functions that are finite at every rate."""
    cos, sin = sp.cos(heading), sp.sin(heading)
    moves = v * (AHEAD * cos - ASIDE * sin), v * (AHEAD * sin + ASIDE * cos)
    return Tensor((5,), (x + moves[0], y + moves[1], v, heading + omega * T, omega))


def quantities() -> Iterator[Quantity]:
    """F and Q of a turn at a known rate, and maps with their derivatives where the rate belongs to the state."""
    state = State("turn.known_rate", "(x, vx, y, vy) in a turn of known rate", PLANE, SOURCE)
    yield state.transition((T, omega), lambda: KNOWN.transition, lambda: StableForm({}, turned()))
    yield state.noise(
        ".continuous",
        "white noise in the acceleration along both axes",
        CONTINUOUS,
        (T, omega, q),
        lambda: KNOWN.continuous_noise(q),
        lambda: StableForm({}, Tensor.build((4, 4), lambda m, n: q * WHITE.get((min(m, n), max(m, n)), ZERO))),
    )
    yield state.noise(
        ".piecewise",
        "accelerations along both axes that are noise, constant over a period",
        PIECEWISE,
        (T, omega, sigma_w),
        lambda: KNOWN.piecewise_noise(sigma_w),
        lambda: StableForm({}, noise_of(pushed(), sigma_w)),
    )
    yield from _mapped(
        "turn.unknown_rate",
        "(x, vx, y, vy, omega) in a turn of unknown rate",
        (x, vx, y, vy, omega),
        lambda: moved(KNOWN.transition),
        lambda: moved(turned()),
    )
    yield from _mapped(
        "ctrv",
        "(x, y, speed, heading, omega) at constant turn rate and velocity",
        (x, y, v, heading, omega),
        driven_ahead,
        driven_finitely,
    )


def _mapped(
    name: str,
    text: str,
    state: tuple[Variable, ...],
    derived: Callable[[], Tensor[Expr]],
    finite: Callable[[], Tensor[Expr]],
) -> Iterator[Quantity]:
    """A map from scan to scan, its Jacobian and Hessian, each derived from the map and written from the finite one."""
    outward: tuple[Unit, ...] = tuple(variable.unit for variable in state)
    inward = tuple(variable.unit**-1 for variable in state)
    rows: tuple[tuple[str, str, str, int, Callable[[Tensor[Expr]], Tensor[Expr]]], ...] = (
        ("map", "f", f"{text}, a period later", 0, lambda f: f),
        ("jacobian", "df/dstate", f"first derivatives of {text}, a period later, [out, in]", 1,
         lambda f: taylor.jacobian(f, state)),
        ("hessian", "d2f/dstate2", f"second derivatives of {text}, a period later, [out, in, in]", 2,
         lambda f: taylor.hessian(f, state)),
    )  # fmt: skip
    for row, word, meaning, order, of in rows:
        yield Quantity(
            name=f"motion.{name}.{row}",
            meaning=meaning,
            axes=(outward, *(inward,) * order),
            symbols=(*state, T),
            conditioning=Conditioning.NONE,
            source=SOURCE,
            word=word,
            derivation=lambda of=of: of(derived()),  # type: ignore[misc]
            rewriting=lambda of=of: StableForm({}, of(finite())),  # type: ignore[misc]
            scale=lambda of=of: of(finite()).map(at_most),  # type: ignore[misc]
            measured_against="what its terms are at most at any rate",
        )
