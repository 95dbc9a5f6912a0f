"""How often a Gaussian error stays within so many standard deviations; NumPy has no error function to write it with."""

from __future__ import annotations

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.language.quantity import Conditioning, Quantity, scalar
from radartrack.derive.language.stable_form import NotProved
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import ONE

n = Variable("n", "how many standard deviations to either side", ONE, 1e-3, 10.0)


def coverage() -> Expr:
    """The integral of the normal density from −n to n.

    Raises:
        NotProved: when its derivative is not twice the density, or it is not zero at n = 0.
    """
    within = sp.erf(n / sp.sqrt(2))
    density = sp.exp(-(n**2) / 2) / sp.sqrt(2 * sp.pi)
    zero = sp.Integer(0)
    if sp.expand(sp.diff(within, n) - 2 * density) != zero or within.xreplace({n: zero}) != zero:
        raise NotProved("the coverage should be the integral of the normal density")
    return within


COVERAGE: Quantity = scalar(
    "gaussian.coverage",
    "probability that a Gaussian error is within n standard deviations",
    ONE,
    (n,),
    cite("gauss1809"),
    "the integral of the normal density from -n to n",
    coverage,
    conditioning=Conditioning.TRUTH,
)
