"""What one of several processes that run the tests has derived, the others read: it takes each half a minute."""

import os
import pickle
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from time import thread_time

from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr

QUICK = 0.03  # seconds; what takes less is as soon derived as read


def share(folder: Path) -> None:
    """Let the quantities of the catalogue read from a folder what others derived, and leave there what they derive."""
    folder.mkdir(exist_ok=True)
    for name, quantity in catalogue().items():
        object.__setattr__(quantity, "derivation", _shared(folder / name, quantity.derivation))


def _shared(path: Path, derive: Callable[[], Tensor[Expr]]) -> Callable[[], Tensor[Expr]]:
    def derivation() -> Tensor[Expr]:
        with suppress(FileNotFoundError):
            known: Tensor[Expr] = pickle.loads(path.read_bytes())  # noqa: S301 - this run wrote it, for itself alone
            return known
        start = thread_time()
        derived = derive()
        if thread_time() - start > QUICK:
            written = path.with_name(f"{path.name}.{os.getpid()}")
            written.write_bytes(pickle.dumps(derived))
            written.replace(path)
        return derived

    return derivation
