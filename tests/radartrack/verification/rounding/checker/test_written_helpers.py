"""Rests of series, Stumpff's functions and a root: bounds from their statements, and what they are off by."""

import ast
from importlib import import_module
from inspect import getsource
from typing import Any

import numpy as np
import pytest

flint = pytest.importorskip("flint")

from radartrack.verification.rounding.checker.arithmetic import Box  # noqa: E402 - they need python-flint
from radartrack.verification.rounding.checker.known_numbers import DOUBLE, SINGLE, Number, Refused  # noqa: E402
from radartrack.verification.rounding.checker.written_helpers import helped  # noqa: E402
from radartrack.verification.rounding.exact_statements import _remainder, _stumpff, _third  # noqa: E402

EXACT: dict[str, Any] = {"_remainder": _remainder, "_stumpff": _stumpff, "_third": lambda x, _: _third(x)}
CALLS = [
    ("motion", "_stumpff", 1, 1e-6, 5.0), ("motion", "_stumpff", 3, 1e-6, 5.0), ("motion", "_stumpff", 6, 2.0, 5.0),
    ("motion", "_remainder", 2, -1e3, -1e-6), ("motion", "_remainder", 5, -9.0, -3.0),
    ("steady_state", "_third", 0, 0.02, 1e10),
]  # fmt: skip


def module(name: str) -> Any:
    return import_module(f"radartrack.generated.{name}")


def definition(text: str, name: str) -> ast.FunctionDef:
    return next(node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef) and node.name == name)


def bound(text: str, name: str, order: int, ends: tuple[float, float], precision: Any = DOUBLE) -> Number:
    box = Box(flint, precision)
    low, high = sorted(map(abs, ends))
    x = box.argument(1 if ends[0] > 0 else -1, *(flint.arb(end).log() for end in (low, high)))
    return helped(box, definition(text, name), x, order)


@pytest.mark.parametrize(("where", "name", "order", "low", "high"), CALLS)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_no_helper_is_farther_off_than_is_proved(
    where: str, name: str, order: int, low: float, high: float, dtype: type[np.floating[Any]]
):
    generator = np.random.default_rng(3)
    sign = np.sign(low)
    x = (
        sign * np.exp(generator.uniform(np.log(min(abs(low), abs(high))), np.log(max(abs(low), abs(high))), 300))
    ).astype(dtype)
    order_given = () if name == "_third" else (order,)
    computed = getattr(module(where), name)(x, *order_given)
    assert computed.dtype == dtype
    unit = flint.arb(2) ** (-53 if dtype is np.float64 else -24)
    proved = bound(getsource(module(where)), name, order, (low, high), DOUBLE if dtype is np.float64 else SINGLE)
    with flint.ctx.workprec(300):
        exact = [EXACT[name](flint.arb(float(at)), flint.arb(order)) for at in x]
        off = [abs(flint.arb(float(c)) - e) / unit for c, e in zip(computed, exact, strict=True)]
        if proved.relative is not None:
            worst = max(float(o / abs(e)) for o, e in zip(off, exact, strict=True))
            assert worst <= float(proved.relative.upper()) < 100
        else:
            assert max(map(float, off)) <= float(proved.error[()].upper()) < 10
        assert all(proved.low < abs(e).log() + 1e-12 and abs(e).log() < proved.high + 1e-12 for e in exact)


def test_a_helper_that_is_written_in_another_way_is_followed_in_that():
    text = getsource(module("motion"))
    spoilt = text.replace("np.where(is_small, series * term, closed)", "np.where(is_small, closed, closed)")
    before, after = (bound(written, "_stumpff", 3, (2.0, 5.0)) for written in (text, spoilt))
    assert text != spoilt
    assert before.relative is not None
    assert after.relative is not None
    assert after.relative > before.relative


def test_a_helper_with_a_statement_that_there_is_no_rule_for_is_refused():
    spoilt = getsource(module("motion")).replace("rest = 1.0 + small * rest / n", "rest = np.gamma(rest)")
    with pytest.raises(Refused, match="no rule"):
        bound(spoilt, "_remainder", 3, (-9.0, -1.0))


def test_a_root_without_its_last_step_is_refused():
    text = getsource(module("steady_state"))
    with pytest.raises(Refused, match="Newton"):
        bound(text.replace("(12.0 * c**2 - 3.0)", "(12.0 * c**2 + 3.0)"), "_third", 0, (0.5, 4.0))


def test_stumpffs_functions_are_not_known_beyond_a_turn():
    with pytest.raises(Refused, match="turn"):
        bound(getsource(module("motion")), "_stumpff", 2, (1.0, 7.0))
