"""How figures look and how they are kept: one style, colours that survive colour blindness and print, fixed bytes."""

from __future__ import annotations

import io
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure

BLACK, ORANGE, SKY, GREEN, BLUE, RED, PURPLE = (
    "#000000", "#b87a00", "#3a9bd9", "#007a5a", "#0059a0", "#c04a00", "#a8487d",
)  # fmt: skip
"""The colours of Okabe and Ito (2008), darkened where they are too pale for a thin line on white paper."""

STYLE: Any = {
    "axes.axisbelow": True,
    "axes.grid": True,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlesize": 10,
    "figure.facecolor": "white",
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.6,
    "legend.fontsize": 8,
    "legend.frameon": False,
    "lines.linewidth": 1.4,
    "lines.markersize": 4,
    "savefig.dpi": 130,
    "svg.fonttype": "path",
    "svg.hashsalt": "radartrack",
}


@dataclass(frozen=True)
class Picture:
    """A figure with its name, its caption, and what it shows in words for who cannot see it."""

    name: str
    figure: Figure
    caption: str
    alt: str

    def svg(self) -> bytes:
        """The figure as SVG; the same bytes for the same figure."""
        return self._saved("svg", {"Date": None, "Creator": None})

    def png(self) -> bytes:
        """The figure as PNG; the same bytes for the same figure."""
        return self._saved("png", {"Software": None})

    def files(self) -> dict[str, bytes]:
        """SVG and PNG, by the names of their files."""
        return {f"{self.name}.svg": self.svg(), f"{self.name}.png": self.png()}

    def _saved(self, kind: str, metadata: dict[str, Any]) -> bytes:
        buffer = io.BytesIO()
        with mpl.rc_context(STYLE):
            self.figure.savefig(buffer, format=kind, metadata=metadata)
        return buffer.getvalue()

    def _repr_mimebundle_(self, **_: object) -> dict[str, bytes | str]:
        """What a notebook shows: the picture, or the words."""
        return {"image/png": self.png(), "text/plain": self.alt}


@contextmanager
def drawing(width: float, height: float) -> Iterator[Figure]:
    """A new figure [inches], and the style to draw it in; laid out once, so that every time it is saved alike."""
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(width, height), layout="constrained")
        yield figure
        figure.draw_without_rendering()
        figure.set_layout_engine("none")


def mark(axes: Axes, x: float, y: float, text: str, offset: tuple[float, float] = (6, 6)) -> None:
    """Mark a number of the paper with a star and words."""
    axes.plot([x], [y], marker="*", markersize=11, color=RED, markeredgecolor="white", linestyle="none", zorder=5)
    axes.annotate(text, (x, y), textcoords="offset points", xytext=offset, color=RED, fontsize=8)
