"""Which of many observed in the same pattern, so that what depends on the pattern alone is computed once."""

import numpy as np
from numpy.typing import NDArray


def distinct(seen: NDArray[np.bool_]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Find the distinct rows of flags, whatever their number.

    Args:
        seen: shape (n, m).

    Returns:
        The number of one row for each pattern, and for each row which of them has its pattern, shape (n,).

    """
    bits = np.packbits(seen, axis=1)
    order = np.lexsort((*bits.T, np.zeros(len(seen), dtype=bool)))  # of no flags all are alike
    starts = np.ones(len(seen), dtype=bool)
    starts[1:] = (np.diff(bits[order], axis=0) != 0).any(axis=1)
    which = np.empty(len(seen), dtype=np.int64)
    which[order] = np.cumsum(starts) - 1
    return order[starts], which
