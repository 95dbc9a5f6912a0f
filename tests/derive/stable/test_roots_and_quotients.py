"""Numerators are written in factors, so that what vanishes somewhere vanishes there as a factor does."""

import sympy as sp

from radartrack.derive.language.tensor import Tensor
from radartrack.derive.stable.roots_and_quotients import collected_form


def longest_sum(expression: sp.Expr) -> int:
    return max((len(node.args) for node in sp.preorder_traversal(expression) if isinstance(node, sp.Add)), default=1)


def test_the_square_of_a_slope_is_written_as_a_square_though_it_is_shorter_over_sines():
    a, t = sp.symbols("a t", real=True)
    slope = (1 - 2 * a * sp.cos(t) + a**2) * (1 - a * sp.cos(t)) ** 2 * sp.sin(t)
    entry = sp.expand(slope**2) / (2 - 2 * a * sp.cos(t)) ** 4
    (written,) = collected_form(Tensor((), (entry,))).expanded().entries
    assert longest_sum(written) <= 3
    assert sp.expand(written * (2 - 2 * a * sp.cos(t)) ** 4 - sp.expand(slope**2)).equals(0)
