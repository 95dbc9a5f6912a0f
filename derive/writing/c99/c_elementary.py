"""The functions that generated C calls: sine, cosine and exponential of our own, others of math.h under names of ours.

All stand in one header. Whoever has others in place of those of math.h says so by a macro, and the rest follows.
"""

from __future__ import annotations

from functools import cache

from radartrack.derive.writing.c99 import c_sines
from radartrack.derive.writing.c99.c_expression import FUNCTIONS, POWER, PREFIX, ROOT
from radartrack.derive.writing.numpy_writer import VERSION

NAME = "radartrack_elementary.h"
OF_TWO = {"atan2", "hypot", POWER}
HEAD = f"""\
/*
 * The elementary functions that generated code calls, in double and, with f behind the name, single precision.
 *
 * Sine, cosine, exponential and exponential less one need no library: each is within one unit in the last place of
 * the exact value, and the same bits everywhere, where arithmetic is IEEE 754 in the type itself (FLT_EVAL_METHOD is
 * 0) and a product and a sum are not fused to one operation. A zero has no sign.
 *
 * The others are those of math.h. To take others, define RADARTRACK_ELEMENTARY as the name of a header of yours, such
 * as "my_functions.h": it is included in place of math.h, and defines what stands there up to the first helper.
 *
 * Written by radartrack regenerate, generator {VERSION}; not to be edited.
 */
#ifndef RADARTRACK_ELEMENTARY_H
#define RADARTRACK_ELEMENTARY_H

#include <stddef.h>
#include <stdint.h>

#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif

#ifdef __cplusplus
#define RADARTRACK_RESTRICT __restrict
#else
#define RADARTRACK_RESTRICT restrict
#endif

#ifdef __GNUC__
#define RADARTRACK_INLINE static inline __attribute__((always_inline))
#else
#define RADARTRACK_INLINE static inline
#endif

/* Loops over many points: GCC computes several at once only where it is told so, which changes no result. */
#if defined(__GNUC__) && !defined(__clang__)
#define RADARTRACK_BATCH static inline __attribute__((optimize("O3", "no-trapping-math")))
#else
#define RADARTRACK_BATCH static inline
#endif

"""
TAIL = "#endif\n"
OWN = "#ifdef RADARTRACK_ELEMENTARY\n#include RADARTRACK_ELEMENTARY\n#else\n#include <math.h>\n\n"

SQUARE = """\
/* x times x, rounded once */
static inline {real} radartrack_square{f}({real} x)
{{
    return x * x;
}}
"""
BELOW = """\
/* one where a is less than b, else zero */
static inline {real} radartrack_below{f}({real} a, {real} b)
{{
    return a < b ? 1.0{f} : 0.0{f};
}}
"""
RATIO = """\
/* above / below, and zero where below is zero */
static inline {real} radartrack_ratio{f}({real} above, {real} below)
{{
    return below < 0.0{f} || below > 0.0{f} || below != below ? above / below : 0.0{f};
}}
"""
REMAINDER = """\
/* e^x less the terms of its series below the order; where these would cancel, by the rest of the series */
static inline {real} radartrack_remainder{f}({real} x, int order)
{{
    {real} rest = 1.0{f}, series = 0.0{f}, term = 1.0{f};
    int n;
    for (n = order + 30; n > order; --n)
        rest = 1.0{f} + x * rest / ({real})n;
    for (n = 0; n < order; ++n) {{
        series = series + term;
        term = term * x / ({real})(n + 1);
    }}
    return {abs}(x) < ({real})order ? rest * term : {exp}(x) - series;
}}
"""
STUMPFF = """\
/* 1/n! - x^2/(n+2)! + x^4/(n+4)! - ..., by this series; where it is long, by cosine or sine less its beginning */
static inline {real} radartrack_stumpff{f}({real} x, int order)
{{
    {real} series = 1.0{f}, closed, term = 1.0{f};
    const {real} x_squared = x * x;
    int n;
    for (n = order + 30; n > order; n -= 2)
        series = 1.0{f} - x_squared * series / ({real})(n * (n - 1));
    closed = order % 2 != 0 ? {sin}(x) / x : {cos}(x);
    for (n = order % 2; n < order; n += 2) {{
        closed = (term - closed) / x_squared;
        term /= ({real})((n + 1) * (n + 2));
    }}
    return {abs}(x) < ({real})order ? series * term : closed;
}}
"""
THIRD = """\
/* the positive root c of 4 c^3 - 3 c = x, a cosine or hyperbolic cosine and a step of Newton's */
static inline {real} radartrack_third{f}({real} x)
{{
    const {real} c = x > 1.0{f} ? {cosh}({acosh}(x) / 3.0{f}) : {cos}({acos}(x) / 3.0{f});
    return c - ((4.0{f} * (c * c) - 3.0{f}) * c - x) / (12.0{f} * (c * c) - 3.0{f});
}}
"""
HELPERS = {
    "square": SQUARE,
    "below": BELOW,
    "ratio": RATIO,
    "remainder": REMAINDER,
    "stumpff": STUMPFF,
    "third": THIRD,
}
CALLED = ("abs", "acos", "acosh", "cos", "cosh", "exp", "sin")  # by helpers


@cache
def header() -> str:
    """The header."""
    wrapped = [_wrapper(name, suffix) for name in sorted(_of_math()) for suffix in ("", "f")]
    return (
        f"{HEAD}{c_sines.functions()}\n{OWN}{''.join(wrapped)}\n#endif\n\n"
        f"{helpers('', PREFIX)}\n{helpers('f', PREFIX)}\n{TAIL}"
    )


def helpers(suffix: str, prefix: str, statements: str | None = None) -> str:
    """The helpers in one precision, or those of them that statements call; they call what has this prefix."""
    real = "float" if suffix else "double"
    names = {name: f"{prefix}{'fabs' if name == 'abs' else name}{suffix}" for name in CALLED}
    wanted = (text for name, text in HELPERS.items() if statements is None or f"{PREFIX}{name}{suffix}(" in statements)
    return "\n".join(text.format(real=real, f=suffix, **names) for text in wanted)


def _of_math() -> set[str]:
    return {*FUNCTIONS.values(), ROOT, POWER, "acosh"} - c_sines.NAMES


def _wrapper(name: str, suffix: str) -> str:
    real = "float" if suffix else "double"
    names = ("x", "y") if name in OF_TWO else ("x",)
    arguments = ", ".join(f"{real} {each}" for each in names)
    called = f"{name}{suffix}({', '.join(names)})"
    return f"static inline {real} {PREFIX}{name}{suffix}({arguments}) {{ return {called}; }}\n"
