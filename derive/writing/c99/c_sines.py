"""Sine, cosine, e^x and e^x − 1 in C, in both precisions, without a library."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import mpmath

from radartrack.derive.elementary.coefficients import pieces_of_right_angle
from radartrack.derive.elementary.precision import DOUBLE, SINGLE, Precision
from radartrack.derive.elementary.straight_line import (
    ARGUMENT,
    Steps,
    angle_less_quarters,
    exponential,
    exponential_less_one,
    sine_and_cosine,
)
from radartrack.derive.writing.c99.c_expression import PREFIX
from radartrack.derive.writing.numpy_writer import INDENT

NAMES = frozenset({"sin", "cos", "exp", "expm1"})
ZEROS, WORDS = 2, 37  # of 2/π, each of 32 bits: enough for the largest exponent, and 192 bits behind it

POWER = """\
/* 2 to a whole power, read off a sum whose last digit is one */
RADARTRACK_INLINE {real} {prefix}power_of_two{f}({real} exponent)
{{
    union {{
        {real} value;
        {bits} bits;
    }} number;
    number.value = exponent + {whole};
    number.bits = (number.bits << {mantissa}) + (({bits}){bias} << {mantissa});
    return number.value;
}}
"""
FAR = """\
/*
 * Quarters of a turn, modulo four, in m 2^exponent radians, m of at most 53 bits, exponent from -60 to 971. What is
 * left is (high 2^64 + low) 2^(scale - 128) of a quarter, or minus that; high is at least 2^63 unless it is zero
 * (Payne & Hanek 1983): of m 2/pi, 192 bits that are neither multiples of four quarters nor too small to matter.
 */
static inline int {prefix}far_quarters(
    uint64_t m, int exponent, uint64_t *high, uint64_t *low, int *scale, int *is_negative)
{{
    static const uint32_t digits[{words}] = {{
{digits}
    }};
    const int start = exponent + 62; /* above, digits count multiples of four quarters; two words of zeros come first */
    uint64_t product[6], carry = 0, above = 0; /* no initial zeros: compilers would call memset for them */
    int i, quarters;
    for (i = 5; i >= 0; --i) {{ /* word i of the window times both words of m; words above the first are dropped */
        const int place = start / 32 + i;
        const uint64_t both = ((uint64_t)digits[place] << 32) | digits[place + 1];
        const uint64_t word = (both >> (32 - start % 32)) & 0xffffffffu;
        const uint64_t first = word * (m & 0xffffffffu), second = word * (m >> 32);
        const uint64_t sum = (first & 0xffffffffu) + carry;
        product[i] = sum & 0xffffffffu;
        carry = (sum >> 32) + (first >> 32) + (second & 0xffffffffu) + above;
        above = second >> 32;
    }}
    quarters = (int)(product[0] >> 30);
    *is_negative = (int)((product[0] >> 29) & 1u);
    product[0] &= 0x3fffffffu;
    if (*is_negative) {{ /* the nearest quarter is the next one */
        quarters = (quarters + 1) & 3;
        carry = 1;
        for (i = 5; i >= 0; --i) {{
            product[i] = (product[i] ^ (i > 0 ? 0xffffffffu : 0x3fffffffu)) + carry;
            carry = product[i] >> 32;
            product[i] &= 0xffffffffu;
        }}
    }}
    *scale = 2;
    for (i = 0; i < 191 && !(product[0] >> 31); ++i) {{ /* to the left, until the first bit is one */
        int k;
        for (k = 0; k < 5; ++k)
            product[k] = ((product[k] << 1) | (product[k + 1] >> 31)) & 0xffffffffu;
        product[5] = (product[5] << 1) & 0xffffffffu;
        --*scale;
    }}
    *high = (product[0] << 32) | product[1];
    *low = (product[2] << 32) | product[3];
    return quarters;
}}
"""
FAR_ANGLE = """\
/* the same of an angle: quarters, and the rest in radians as y + y_low */
static inline {real} {prefix}far_angle{f}({real} x, {real} *y, {real} *y_low)
{{
    union {{
        {real} value;
        {bits} bits;
    }} number;
    uint64_t high, low;
    int exponent, scale, is_negative, quarters;
    {real} a, b, c, unit, rest, small;
    number.value = x;
    exponent = (int)((number.bits >> {mantissa}) & {exponents}u);
    if (exponent == {exponents}) {{ /* an infinity has no sine */
        *y = *y_low = x - x;
        return x - x;
    }}
    number.bits &= (({bits})1 << {mantissa}) - 1u;
    quarters = {prefix}far_quarters(
        (uint64_t)number.bits | ((uint64_t)1 << {mantissa}), exponent - {bias} - {mantissa},
        &high, &low, &scale, &is_negative);
    a = ({real})(uint32_t)(high >> {shift_a});
    b = ({real})(uint32_t)((high >> {shift_b}) & {mask}u);
    c = ({real})(uint32_t)({third} & {mask}u);
    unit = {prefix}power_of_two{f}(({real})(scale - {piece}));
    b *= {finer};
    c *= {finest};
    rest = {p1} * a;
    small = ({p2} * a + {p1} * b) + ({p3} * a + {p2} * b + {p1} * c);
    *y = rest + small;
    *y_low = ((rest - *y) + small) * unit;
    *y *= unit;
    if (is_negative == (x > {zero})) {{
        *y = -*y;
        *y_low = -*y_low;
    }}
    return ({real})(x < {zero} ? -quarters : quarters);
}}
"""

MANY = """\
/* of n angles; those that are far come last, one by one */
RADARTRACK_BATCH void {prefix}sin_and_cos_n{f}(
    size_t n, const {real} *x, {real} *RADARTRACK_RESTRICT sine, {real} *RADARTRACK_RESTRICT cosine)
{{
    size_t i;
    for (i = 0; i < n; ++i) {{
        const {real} size = x[i] < {zero} ? -x[i] : x[i];
        {prefix}near_sin_and_cos{f}(size <= {largest} ? x[i] : {zero}, sine + i, cosine + i);
    }}
    for (i = 0; i < n; ++i)
        if (!(x[i] >= -{largest} && x[i] <= {largest}))
            {prefix}sin_and_cos{f}(x[i], sine + i, cosine + i);
}}
"""


@dataclass(frozen=True)
class C:
    """How C writes the steps."""

    precision: Precision

    @property
    def suffix(self) -> str:
        """Of functions and numbers."""
        return "" if self.precision is DOUBLE else "f"

    @property
    def real(self) -> str:
        """The type."""
        return "float" if self.suffix else "double"

    def number(self, value: float) -> str:
        """With the suffix of the type, by digits that are read as the number in that type."""
        return f"{value!r}{self.suffix}"

    def absolute(self, value: str) -> str:
        """Without a function."""
        return f"({value} < {self.number(0.0)} ? -{value} : {value})"

    def chosen(self, condition: str, first: str, second: str) -> str:
        """A choice between what costs nothing to compute."""
        return f"({condition} ? {first} : {second})"

    def power_of_two(self, exponent: str) -> str:
        """Our own function."""
        return f"{PREFIX}power_of_two{self.suffix}({exponent})"

    def in_type(self, value: str) -> str:
        """A cast takes what is wider to the type."""
        return f"({self.real})({value})"


def functions() -> str:
    """All, in both precisions."""
    return "\n".join([_power(DOUBLE), _power(SINGLE), _far(), *_functions(DOUBLE), *_functions(SINGLE)])


def _functions(precision: Precision) -> Iterator[str]:
    say = C(precision)
    yield _far_angle(precision)
    yield from _both(precision)
    for name in ("sin", "cos"):
        lines = [f"{say.real} sine, cosine;", f"{PREFIX}sin_and_cos{say.suffix}({ARGUMENT}, &sine, &cosine);"]
        yield _one(say, name, [*lines, f"return {'sine' if name == 'sin' else 'cosine'};"])
    for name, steps in (("exp", exponential(precision, say)), ("expm1", exponential_less_one(precision, say))):
        yield _one(say, name, [*_constants(say, steps), f"return {steps.results[0]};"])


def _both(precision: Precision) -> Iterator[str]:
    """Of a reduced angle, of one in range, of any, and of many; the loop over many has no branch."""
    say = C(precision)
    near, both = angle_less_quarters(precision, say), sine_and_cosine(precision, say)
    real, f, within = say.real, say.suffix, f"{say.absolute(ARGUMENT)} <= {say.number(precision.largest_angle)}"
    returned = f"{real} *sine, {real} *cosine"
    results = [f"*{name} = {value};" for name, value in zip(("sine", "cosine"), both.results, strict=True)]
    reduced = ", ".join(near.results)
    yield _function(
        f"RADARTRACK_INLINE void {PREFIX}of_quarters{f}({real} quarters, {real} y, {real} y_low, {returned})",
        [*_constants(say, both), *results],
    )
    yield _function(
        f"RADARTRACK_INLINE void {PREFIX}near_sin_and_cos{f}({real} {ARGUMENT}, {returned})",
        [*_constants(say, near), f"{PREFIX}of_quarters{f}({reduced}, sine, cosine);"],
    )
    yield _function(
        f"static inline void {PREFIX}sin_and_cos{f}({real} {ARGUMENT}, {returned})",
        [
            f"if ({within}) {{",
            f"{INDENT}{PREFIX}near_sin_and_cos{f}({ARGUMENT}, sine, cosine);",
            "} else {",
            f"{INDENT}{real} y, y_low;",
            f"{INDENT}const {real} quarters = {PREFIX}far_angle{f}({ARGUMENT}, &y, &y_low);",
            f"{INDENT}{PREFIX}of_quarters{f}({reduced}, sine, cosine);",
            "}",
        ],
    )
    yield MANY.format(real=real, f=f, prefix=PREFIX, zero=say.number(0.0), largest=say.number(precision.largest_angle))


def _constants(say: C, steps: Steps) -> Iterator[str]:
    for name, value in steps.assignments:
        yield f"const {say.real} {name} = {value};"


def _one(say: C, name: str, lines: list[str]) -> str:
    return _function(f"RADARTRACK_INLINE {say.real} {PREFIX}{name}{say.suffix}({say.real} {ARGUMENT})", lines)


def _function(signature: str, lines: Iterable[str]) -> str:
    return f"{signature}\n{{\n{textwrap.indent(chr(10).join(lines), INDENT)}\n}}\n"


def _power(precision: Precision) -> str:
    say = C(precision)
    return POWER.format(
        real=say.real, f=say.suffix, prefix=PREFIX, whole=say.number(precision.to_whole), **_layout(precision)
    )


def _far() -> str:
    with mpmath.workprec(32 * (WORDS + 2)):
        digits = int(mpmath.floor(2 / mpmath.pi * mpmath.mpf(2) ** (32 * WORDS)))
    words = [0] * ZEROS + [(digits >> (32 * (WORDS - 1 - n))) & 0xFFFFFFFF for n in range(WORDS)]
    text = textwrap.fill(", ".join(f"0x{word:08x}u" for word in words), 96)
    return FAR.format(prefix=PREFIX, words=ZEROS + WORDS, digits=textwrap.indent(text, 2 * INDENT))


def _far_angle(precision: Precision) -> str:
    say, piece = C(precision), precision.bits // 2
    shifts = (64 - piece, 64 - 2 * piece, 64 - 3 * piece)
    third = f"(high >> {shifts[2]})" if shifts[2] >= 0 else f"((high << {-shifts[2]}) | (low >> {64 + shifts[2]}))"
    first, second, last = (say.number(part) for part in pieces_of_right_angle(piece))
    return FAR_ANGLE.format(
        real=say.real, f=say.suffix, prefix=PREFIX, zero=say.number(0.0), piece=piece, mask=f"0x{(1 << piece) - 1:x}",
        shift_a=shifts[0], shift_b=shifts[1], third=third, finer=say.number(2.0**-piece),
        finest=say.number(2.0 ** (-2 * piece)), p1=first, p2=second, p3=last, **_layout(precision),
    )  # fmt: skip


def _layout(precision: Precision) -> dict[str, str | int]:
    """Of the bits of a number."""
    if precision is DOUBLE:
        return {"bits": "uint64_t", "mantissa": 52, "exponents": 2047, "bias": 1023}
    return {"bits": "uint32_t", "mantissa": 23, "exponents": 255, "bias": 127}
