"""Polynomials in a count, written in what it exceeds its least value by.

There a polynomial that grows with the count mostly has coefficients of one sign, and then nothing cancels in it, not
even where the count is at its least.
"""

from __future__ import annotations

from radartrack.derive import symbolic as sp
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, Symbol


def counted_from(entries: Tensor[Expr], count: Symbol, least: int) -> StableForm:
    """Rewrite every sum that is a polynomial, where that leaves coefficients of one sign.

    Args:
        entries: products, quotients and roots of polynomials in the count and other symbols that are not negative.
        count: a symbol.
        least: what it is never less than.
    """
    beyond = sp.Symbol(f"{count.name}_beyond_{least}", real=True)
    shift = {count: beyond + least}

    def counted(expression: Expr) -> Expr:
        if expression.is_Atom:
            return expression
        if expression.is_Add and expression.is_polynomial(*expression.free_symbols):
            shifted = sp.expand(expression.xreplace(shift))
            return shifted if _of_one_sign(shifted) else expression
        return expression.func(*map(counted, expression.args))

    rewritten = entries.map(counted)
    return StableForm({beyond: count - least}, rewritten).only(rewritten)


def with_sums_expanded(expression: Expr) -> Expr:
    """Every sum that is a polynomial multiplied out: how a rewritten formula is compared with what it was."""
    if expression.is_Atom:
        return expression
    if expression.is_Add and expression.is_polynomial(*expression.free_symbols):
        return sp.expand(expression)
    return expression.func(*map(with_sums_expanded, expression.args))


def _of_one_sign(polynomial: Expr) -> bool:
    signs = {term.as_coeff_Mul()[0] > sp.Integer(0) for term in sp.Add.make_args(polynomial)}
    return len(signs) == 1
