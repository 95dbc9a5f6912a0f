"""Kronecker products in LaTeX."""

import time
from collections.abc import Callable

import pytest

from radartrack.derive import check
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.reading import FormulaError, read_latex, read_text
from radartrack.derive.reading.tex.latex_kronecker import with_kronecker
from radartrack.derive.reading.tex.latex_symmetric import with_mirrored

MATRIX = r"\begin{bmatrix} 1 & T \\ 0 & 1 \end{bmatrix}"
AXIS_BY_AXIS = "[[1, T, 0, 0], [0, 1, 0, 0], [0, 0, 1, T], [0, 0, 0, 1]]"
SCATTERED = "[[1, 0, T, 0], [0, 1, 0, T], [0, 0, 1, 0], [0, 0, 0, 1]]"


@pytest.mark.parametrize("identity", ["I_2", r"\mathbf{I}_{2}", r"I_{2\times 2}", r"\bm{I}_2"])
def test_a_product_with_an_identity_is_the_matrix_for_each_axis(identity: str) -> None:
    assert read_latex(rf"{identity} \otimes {MATRIX}", ["T"]) == read_text(AXIS_BY_AXIS, ["T"])
    assert read_latex(rf"{MATRIX}\otimes {identity}", ["T"]) == read_text(SCATTERED, ["T"])
    assert read_latex(rf"F = {identity}\otimes F_1, F_1 = {MATRIX}", ["T"]) == read_text(AXIS_BY_AXIS, ["T"])


def test_any_matrices_are_multiplied() -> None:
    other = r"\begin{bmatrix} 1 & 2 \\ 2 & 3 \end{bmatrix}"
    found = read_latex(rf"q {MATRIX} \otimes {other} + Q", ["T", "q", "Q"], {"Q": (4, 4)})
    assert found == read_text("q*kron([[1, T], [0, 1]], [[1, 2], [2, 3]]) + Q", ["T", "q", "Q"], {"Q": (4, 4)})
    found = read_latex(rf"\left(G G^T\right)\otimes A, G = {MATRIX}, A = {MATRIX}", ["T"])
    assert found == read_text("kron(([[1, T], [0, 1]]*[[1, T], [0, 1]].T), [[1, T], [0, 1]])", ["T"])


def test_a_product_of_letters_is_one_factor_and_what_is_behind_an_identity_is_none() -> None:
    assert with_kronecker(r"I_2\otimes \Gamma\Gamma^T") == r"\operatorname{kron}(\operatorname{eye}(2), \Gamma\Gamma^T)"
    assert with_kronecker(r"q F_{k}\otimes I_3 x") == r"q \operatorname{kron}(F_{k}, \operatorname{eye}(3)) x"


@pytest.mark.parametrize(("name", "verdict"), [("3", Outcome.EQUAL), ("2", Outcome.DIFFERS)])
def test_noise_along_several_axes_is_checked_as_that_of_one(name: str, verdict: Outcome) -> None:
    block = rf"\begin{{bmatrix}} T^3/{name} & T^2/2 \\ * & T \end{{bmatrix}}"
    found = check("motion.constant_velocity.process_noise.continuous", rf"q {block} \otimes I_3", latex=True)
    assert found.verdict is verdict


@pytest.mark.parametrize(
    "formula", [r"T \otimes T", rf"I_9 \otimes ({MATRIX} \otimes I_9)", r"\otimes T", r"T \otimes"]
)
def test_what_is_no_product_of_matrices_is_refused(formula: str) -> None:
    with pytest.raises(FormulaError):
        read_latex(formula, ["T"])


HOSTILE = [
    "a", "a_{", "a ", r"\mathbf{", r"\left(", r"\begin{matrix}", "{", r"\\[", "&*", r"\end{matrix}", r"I_{2", "a^a",
]  # fmt: skip


@pytest.mark.parametrize("rewrite", [with_kronecker, with_mirrored])
@pytest.mark.parametrize("part", HOSTILE)
def test_hostile_texts_take_no_long_time(rewrite: Callable[[str], str], part: str) -> None:
    """A hundred times what they need, of this thread alone: work without end is seen, nothing else."""
    text = (part * 80_000)[:80_000]
    start = time.thread_time()
    for hostile in (rf"{text}\otimes", rf"\otimes {text}", rf"\begin{{matrix}}{text}\end{{matrix}}\otimes"):
        rewrite(hostile)
    assert time.thread_time() - start < 60
