"""Turns in the plane: the velocity turns at the rate omega, counter-clockwise, and keeps its size but for noise.

Textbooks print sin(ωT)/ω and (1 − cos ωT)/ω, which are 0/0 when nothing turns and lose their digits before. Written
are Stumpff's functions of ωT, which are finite there, and so are all derivatives by the rate, made of them again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
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
sigma_a = Variable(
    "sigma_w",
    "standard deviation of the acceleration along the heading, constant over a period",
    METRE / SECOND**2,
    1e-6,
    1e3,
)
sigma_omega = Variable(
    "sigma_omega",
    "standard deviation of the acceleration of the turn, constant over a period",
    RADIAN / SECOND**2,
    1e-9,
    1.0,
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


def weighed(power: int) -> tuple[Expr, Expr]:
    """The integrals of s^n/n! cos ωs and of s^n/n! sin ωs over a period, as derived."""
    s, at = sp.Symbol("s", positive=True), sp.Integer(factorial(power))
    found = [sp.expand(integrated(s**power / at * wave(omega * s), s, ZERO, T)) for wave in (sp.cos, sp.sin)]
    return found[0], found[1]


def weighed_finitely(power: int) -> tuple[Expr, Expr]:
    """The same in functions that are finite at every rate, by parts: I1 of the wave, less its integrals I2, I3, ..."""
    parts = [(-1) ** n * sp.Rational(1, factorial(power - n)) for n in range(power + 1)]
    cos = sp.Add(*(part * stumpff(n + 1) for n, part in enumerate(parts)))
    sin = sp.Add(*(part * stumpff(n + 2) for n, part in enumerate(parts)))
    return T ** (power + 1) * cos, omega * T ** (power + 2) * sin


Weighed = Callable[[int], tuple[Expr, Expr]]


def bent_aside(weighed: Weighed) -> Vector:
    """What an acceleration of the turn of one leaves of (x, vx, y, vy, omega): it turns the velocity by s^2/2."""
    cos, sin = weighed(2)
    half = T**2 / 2
    return (
        -(vx * sin + vy * cos),
        -half * (vx * SIN + vy * COS),
        vx * cos - vy * sin,
        half * (vx * COS - vy * SIN),
        T,
    )


def pressed_ahead(weighed: Weighed) -> tuple[Vector, Vector]:
    """What accelerations along the heading and of the turn, of one each, leave of (x, y, speed, heading, omega)."""
    along, across = sp.cos(heading), sp.sin(heading)
    (cos, sin), (cos_2, sin_2) = weighed(1), weighed(2)
    ahead = (along * cos - across * sin, across * cos + along * sin, T, ZERO, ZERO)
    aside = (-v * (across * cos_2 + along * sin_2), v * (along * cos_2 - across * sin_2), ZERO, T**2 / 2, T)
    return ahead, aside


def noise_of_unknown_rate(pushes: tuple[Vector, Vector], weighed: Weighed) -> Tensor[Expr]:
    """Accelerations along both axes, and one of the turn, each constant over a period."""
    columns = [(*push, ZERO) for push in pushes]
    return _sum(noise_of(columns, sigma_w), noise_of([bent_aside(weighed)], sigma_omega))


def noise_of_ctrv(weighed: Weighed) -> Tensor[Expr]:
    """Accelerations along the heading and of the turn, each constant over a period."""
    ahead, aside = pressed_ahead(weighed)
    return _sum(noise_of([ahead], sigma_a), noise_of([aside], sigma_omega))


def pushed_as_derived() -> tuple[Vector, Vector]:
    """As `pushed`, in the textbook's functions."""
    ahead, aside = weighed(0)
    drift = [integrated(wave, T, ZERO, T) for wave in (ahead, aside)]
    return (drift[0], ahead, drift[1], aside), (-drift[1], -aside, drift[0], ahead)


def _sum(first: Tensor[Expr], second: Tensor[Expr]) -> Tensor[Expr]:
    return Tensor.build(first.shape, lambda m, n: first[m, n] + second[m, n])


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
    for row in (
        Bent(
            "turn.unknown_rate",
            "(x, vx, y, vy, omega) in a turn of unknown rate, with accelerations along both axes and of the turn",
            (x, vx, y, vy, omega),
            (T, vx, vy, omega, sigma_w, sigma_omega),
            lambda: noise_of_unknown_rate(pushed_as_derived(), weighed),
            lambda: noise_of_unknown_rate(pushed(), weighed_finitely),
        ),
        Bent(
            "ctrv",
            "(x, y, speed, heading, omega) at constant turn rate and velocity, with accelerations along the heading "
            "and of the turn",
            (x, y, v, heading, omega),
            (T, v, heading, omega, sigma_a, sigma_omega),
            lambda: noise_of_ctrv(weighed),
            lambda: noise_of_ctrv(weighed_finitely),
        ),
    ):
        yield row.quantity()


@dataclass(frozen=True)
class Bent:
    """The process noise of a motion that is not linear: of accelerations to first order, exact in all else."""

    motion: str
    text: str
    state: tuple[Variable, ...]
    symbols: tuple[Variable, ...]
    derived: Callable[[], Tensor[Expr]]
    finite: Callable[[], Tensor[Expr]]

    def quantity(self) -> Quantity:
        """The row of the catalogue; a variance may vanish across a heading, so errors are those of the terms."""
        units = tuple(variable.unit for variable in self.state)
        return Quantity(
            name=f"motion.{self.motion}.process_noise.piecewise",
            meaning=f"covariance of the process noise of {self.text} that are noise, constant over a period, to first "
            "order",
            axes=(units, units),
            symbols=self.symbols,
            conditioning=Conditioning.NONE,
            source=SOURCE,
            word="Q = sum of sigma^2 g g', g = d(state a period later)/d(acceleration)",
            derivation=self.derived,
            rewriting=lambda: StableForm({}, self.finite()),
            scale=self._scale,
            measured_against="what its terms are at most at any rate",
        )

    def _scale(self) -> Tensor[Expr]:
        size = self.finite().map(at_most)
        return Tensor.build(size.shape, lambda m, n: sp.sqrt(size[m, m] * size[n, n]))


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
