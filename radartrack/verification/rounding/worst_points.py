"""Where generated functions are worst: points that a search found, kept in the package, to be tried again."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from importlib.resources import files
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack.derive.language.quantity import Quantity
from radartrack.verification.domain_points import Points, sample
from radartrack.verification.layers.ulp_search import bred
from radartrack.verification.rounding.exact_statements import ExactStatements
from radartrack.verification.subject import evaluated, generated

RECORD = "worst_points.json"
AT_RANDOM, LITTER, GENERATIONS = 1500, 300, 15  # a third of it finds a third less
Row = dict[str, Any]


def kept() -> dict[str, Row]:
    """What the package holds: by quantity the worst point that was found, and the error there in ulp."""
    found: dict[str, Row] = json.loads(files(__package__).joinpath(RECORD).read_text("utf-8"))
    return found


def errors_at(quantity: Quantity, source: str, points: Points) -> npt.NDArray[np.float64]:
    """The largest error of an entry at each point, in ulp."""
    computed = evaluated(generated(quantity), quantity, points)
    return ExactStatements(source, quantity).errors(computed.reshape(-1, math.prod(quantity.shape)), points)


def replayed(quantity: Quantity, source: str, row: Row) -> float:
    """The error at a point that is kept."""
    points = {name: np.array([value]) for name, value in row["at"].items()}
    return float(errors_at(quantity, source, points)[0])


def worst_point(quantity: Quantity, source: str, seed: int = 0) -> Row:
    """Points at random, and generations bred from the worst of them."""
    tried = sample(quantity, AT_RANDOM, seed + 40)
    found = errors_at(quantity, source, tried)
    generator = np.random.Generator(np.random.Philox(seed + 41))
    for _ in range(GENERATIONS if tried else 0):
        born = bred(quantity, tried, found, LITTER, generator)
        tried = {name: np.concatenate([values, born[name]]) for name, values in tried.items()}
        found = np.concatenate([found, errors_at(quantity, source, born)])
    place = int(found.argmax())
    at = {name: float(values[place]) for name, values in tried.items()}
    return {"ulp": float(f"{found[place]:.3g}"), "at": at}


def written(rows: Mapping[str, Row]) -> str:
    """All of them, one line a function."""
    lines = [f"{json.dumps(name)}: {json.dumps(row)}" for name, row in sorted(rows.items())]
    return "{\n" + ",\n".join(lines) + "\n}\n"
