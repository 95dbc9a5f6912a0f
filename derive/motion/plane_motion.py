"""Motion at constant velocity in the plane, state (x, vx, y, vy): each axis moves on its own."""

from __future__ import annotations

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.motion import polynomial_motion
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import METRE, METRE_PER_SECOND

AXES = 2
SIZE = 2
UNITS = (METRE, METRE_PER_SECOND) * AXES


def transition() -> Tensor[Expr]:
    """One block for each axis."""
    block = polynomial_motion.transition(SIZE)

    def entry(m: int, n: int) -> Expr:
        return block[m % SIZE, n % SIZE] if m // SIZE == n // SIZE else sp.Integer(0)

    return Tensor.build((AXES * SIZE, AXES * SIZE), entry)


def observation() -> Tensor[Expr]:
    """The position of each axis."""
    return Tensor.build((AXES, AXES * SIZE), lambda a, n: sp.Integer(int(n == a * SIZE)))


# fmt: off - a table reads best with few lines a row
QUANTITIES = (
    Quantity(
        name="motion.plane.transition",
        meaning="transition of (x, vx, y, vy) from scan to scan at constant velocity",
        axes=(UNITS, tuple(unit**-1 for unit in UNITS)),
        symbols=(T,),
        conditioning=Conditioning.NONE,
        source=cite("prosov", "F"),
        word="one block e^(AT) for each axis",
        derivation=transition,
    ),
    Quantity(
        name="motion.plane.observation",
        meaning="position (x, y) from the state (x, vx, y, vy)",
        axes=((METRE,) * AXES, tuple(unit**-1 for unit in UNITS)),
        symbols=(),
        conditioning=Conditioning.NONE,
        source=cite("prosov", "H_2"),
        word="the derivative of the position by the state",
        derivation=observation,
    ),
)
# fmt: on


def quantities() -> tuple[Quantity, ...]:
    """Transition and observation of the state (x, vx, y, vy)."""
    return QUANTITIES
