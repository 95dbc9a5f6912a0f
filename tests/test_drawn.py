"""A shade along an edge is overlooked; a curve that moves by half the width of its line is not."""

import base64
from io import BytesIO

import numpy as np
import pytest

pytest.importorskip("matplotlib", reason="pictures are drawn with it")

from matplotlib.figure import Figure

from tests.drawn import show_the_same


def curve(raised: float = 0.0, width: float = 6.0) -> str:
    figure = Figure(figsize=(width, 4), dpi=100)
    axes = figure.subplots()
    axes.set_ylim(-1.5, 1.5)
    x = np.linspace(0, 6, 200)
    axes.plot(x, np.sin(x) + raised)
    written = BytesIO()
    figure.savefig(written, format="png")
    return base64.b64encode(written.getvalue()).decode()


def test_the_last_bits_of_a_curve_are_not_seen():
    assert show_the_same(curve(), curve(1e-9))


@pytest.mark.parametrize("other", [{"raised": 0.01}, {"raised": -0.2}, {"width": 6.1}])
def test_a_curve_that_moves_is(other: dict[str, float]):
    assert not show_the_same(curve(), curve(**other))
