"""A constant added to an entry that is so small that only the smallest values show it."""

from __future__ import annotations

import numpy as np

from radartrack.testing.calling.called_function import Array
from radartrack.testing.diagnosis import Slip
from radartrack.testing.slips.argument_slips import few_digits
from radartrack.testing.wanted import Expected

ROUNDING = 2.0**-44  # of the scale of an entry, which its rounding may make
STEADY = 1e-3  # of the constant, by which it may scatter where it stands out against rounding
FEWEST = 3  # points at which it stands out
COST = 1.9


def added_constants(expected: Expected, found: Array) -> tuple[Slip, ...]:
    """For each entry that is nowhere more than a constant off, the constant; none where an entry is off otherwise.

    Args:
        expected: the exact values on all scales.
        found: what the function has there, shape (points, entries).
    """
    entries: dict[str, list[int]] = {}
    with np.errstate(all="ignore"):
        away, noise = found - expected.values, ROUNDING * np.maximum(expected.scales, np.abs(found))
    for place in np.flatnonzero(~(np.abs(away) <= noise).all(axis=0)):
        clear = np.abs(away[:, place]) * STEADY > noise[:, place]
        if clear.sum() < FEWEST:
            return ()
        constant = float(np.median(away[clear, place]))
        if not (np.abs(away[:, place] - constant) <= STEADY * abs(constant) + noise[:, place]).all():
            return ()
        term = few_digits(float(f"{abs(constant):.3g}"))
        entries.setdefault(f"{'an extra term' if constant > 0 else 'subtracted is'} {term}", []).append(int(place))
    places = expected.wanted.places
    return tuple(
        Slip(tuple(places[one] for one in having) if expected.wanted.shape else (), words, "", "", COST)
        for words, having in entries.items()
    )
