"""What the checker knows of elementary functions of intermediate results."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

from radartrack.verification.rounding.checker.arithmetic import Box
from radartrack.verification.rounding.checker.known_numbers import Number, Refused
from radartrack.verification.rounding.checker.sums.ball_ends import largest, upper_float
from radartrack.verification.rounding.checker.sums.products_of_powers import (
    Polynomial,
    Signed,
    half,
    plus,
    product_of,
    scaled,
)


def root(box: Box, a: Number | None) -> Number | None:
    """√a."""
    if a is None:
        return None
    if a.sign <= 0 or a.relative is None:
        raise Refused("a root of what may be negative")
    part = box.small(a.relative)
    relative = box.rounded(a.relative / (1 + (1 - part).sqrt()), 1.0)
    (value, exactly), ends = _root_of(box, a), ((a.low / 2).lower(), (a.high / 2).upper())
    return box.made(1, exactly, None, relative, a.tiny / 2 - 1e-3, value, ends=ends, may_underflow=False)


def _root_of(box: Box, a: Number) -> tuple[Signed, Polynomial]:
    if len(a.value) == 1 and len(a.exactly) == 1:
        ((key, c),) = a.value.items()
        above, below = math.isqrt(int(c.p)), math.isqrt(int(c.q))
        if above**2 == int(c.p) and below**2 == int(c.q) and not any(n in box.carriers for n, _ in key):
            root = box.rational(Fraction(above, below))
            return {half(key): root}, {half(key): box.flint.arb(root)}
    return box.whole({(*key, (-2, 1.0)): c for key, c in a.value.items()}, 1, (a.low / 2).lower(), (a.high / 2).upper())


def hypotenuse(box: Box, a: Number | None, b: Number | None) -> Number | None:
    """√(a² + b²)."""
    if a is None or b is None:
        return magnitude(box, a or b)
    if a.relative is None or b.relative is None:
        raise Refused("the length of a vector whose entries may vanish")
    relative = box.rounded(largest([a.relative, b.relative]), 2.0 * box.precision.ulps["hypot"])
    low, high = (((2 * x).exp() + (2 * y).exp()).log() / 2 for x, y in ((a.low, b.low), (a.high, b.high)))
    return box.fresh(1, low.lower(), high.upper(), relative, max(a.tiny, b.tiny) - 1e-3)


def magnitude(box: Box, a: Number | None) -> Number | None:
    """|a|."""
    if a is None or a.sign > 0:
        return a
    if a.sign < 0:
        return box.by_power_of_two(a, -1.0)
    if len(a.exactly) == 1 and len(a.value) == 1:
        value: Signed = {box.bare(key): abs(c) for key, c in a.value.items()}
    else:
        value, _ = box.whole({(*key, (-3, 1.0)): c for key, c in a.value.items()}, 1, a.low, a.high)
    return replace(a, sign=1, value=value)


def wave(box: Box, a: Number | None, *, is_sine: bool) -> Number | None:
    """Sine or cosine of a result: as far off as that, and never more than 1; a sine no more than what it is of."""
    if a is None:
        return None if is_sine else box.constant(1)
    high = min(a.high, box.ball(0)) if is_sine else box.ball(0)
    own = box.ball(2.0 * box.precision.ulps["sin" if is_sine else "cos"])
    key, least = box.atom(box.ball(-math.inf), high), box.ball(-math.inf)
    value = box.with_sign(key, 0)
    error = plus(scaled(a.error, 1 + box.unit * own), {key: own})
    tiny = float(box.precision.normal - box.precision.bits)
    return box.made(0, {key: box.one}, error, None, tiny, value, ends=(least, high), may_underflow=False)


def direction(box: Box, y: Number | None, x: Number | None) -> Number | None:
    """The angle of (x, y): half the sine of twice the angle, which is below the angle, is its condition."""
    known = [one for one in (y, x) if one is not None]
    if not known:
        return None
    relatives = [one.relative for one in known if one.relative is not None]
    if len(relatives) < len(known):
        raise Refused("the direction of a vector whose entries may vanish")
    both = sum(relatives, box.ball(0)) * (1 + box.ball(2.0**-10))
    box.small(both)
    tiny = min(one.tiny for one in known) - max(float(one.high.upper()) for one in known) / math.log(2) - 2
    relative = box.rounded(both, 2.0 * box.precision.ulps["arctan2"])
    return box.fresh(0, box.ball(-math.inf), box.flint.arb.pi().log().upper(), relative, tiny)


def exponential(box: Box, a: Number | None) -> Number | None:
    """e^a."""
    if a is None:
        return box.constant(1)
    if not a.sign:
        raise Refused("an exponential of either sign")
    ends = [a.sign * a.low.exp(), a.sign * a.high.exp()]
    low, high = (ends[0].lower(), ends[1].upper()) if a.sign > 0 else (ends[1].lower(), ends[0].upper())
    off = box.bounds(a.error)[1].exp() if a.error else box.ball(0)
    off = off if a.relative is None else min(off, a.relative * a.high.exp(), key=upper_float)
    change = (box.unit * off).expm1() / box.unit
    relative = box.rounded(change.upper(), 2.0 * box.precision.ulps["exp"])
    found = box.fresh(1, low, high, relative, float(low.lower()) / math.log(2) - 1e-3)
    box.follows(next(iter(found.exactly)), a, lambda low, high: ((a.sign * low).exp(), (a.sign * high).exp()))
    return found


def exponential_less_one(box: Box, a: Number | None) -> Number | None:
    """e^a − 1; its condition is below 1 on the left, a/(1 − e^−a) on the right."""
    if a is None:
        return None
    if not a.sign or a.relative is None:
        raise Refused("expm1 of either sign")
    low, high = ((a.sign * end.exp()).expm1() * a.sign for end in (a.low, a.high))
    low, high = low.log().lower(), high.log().upper()
    part = box.small(a.relative)
    farthest = a.high.exp() * (1 + part)
    condition = farthest / -(-farthest).expm1() if a.sign > 0 else box.ball(1)
    change = ((condition * -(1 - part).log()).expm1()) / box.unit
    relative = box.rounded(change.upper(), 2.0 * box.precision.ulps["expm1"])
    tiny = float(low.lower()) / math.log(2) - 1e-3
    if not box.by_argument or not a.low.is_finite() or len(a.value) > 1 or len(a.exactly) > 1:
        return box.fresh(a.sign, low, high, relative, tiny)
    ends = [((a.sign * end.exp()).expm1() / end.exp() * a.sign).log() for end in (a.low, a.high)]
    share = box.atom(min(ends, key=upper_float).lower(), max(ends, key=upper_float).upper())
    box.follows(share, a, lambda low, high: ((a.sign * low).expm1() / low, (a.sign * high).expm1() / high))
    of_a, size = ({product_of(key, share): c for key, c in one.items()} for one in (a.value, a.exactly))
    return box.made(a.sign, size, None, relative, tiny, of_a, ends=(low, high))


FUNCTIONS: dict[str, Callable[..., Number | None]] = {
    "abs": magnitude, "arctan2": direction, "exp": exponential, "expm1": exponential_less_one, "hypot": hypotenuse,
    "sqrt": root,
}  # fmt: skip
