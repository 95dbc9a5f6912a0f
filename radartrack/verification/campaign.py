"""A run over many functions: what is left to do, who does it, and what came out."""

from __future__ import annotations

import importlib.metadata
import math
import platform
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing
from dataclasses import asdict, dataclass, field, replace
from functools import cached_property, reduce
from importlib.util import find_spec
from operator import add
from pathlib import Path
from typing import Any

from radartrack.derive.language.quantity import Quantity
from radartrack.verification.checkpoint import Checkpoint, digest_of
from radartrack.verification.engines import Engine
from radartrack.verification.layers import monte_carlo
from radartrack.verification.layers.dimensions import Dimensions
from radartrack.verification.layers.identity import Identity
from radartrack.verification.layers.mutants import Mutants
from radartrack.verification.layers.quadrature import Quadrature
from radartrack.verification.layers.rounding import Rounding
from radartrack.verification.layers.ulp_search import Accuracy
from radartrack.verification.outcome import BROKEN, FUNCTION, Function, Layer, Outcome, examined
from radartrack.verification.own_models import NONE, OwnModels
from radartrack.verification.paths import along, paths_of
from radartrack.verification.simulation.draws import CHUNK, Draws, Sums, tasks_for
from radartrack.verification.simulation.experiments import Departures, Trial, budget, departures, simulated, trials
from radartrack.verification.simulation.statistics import FALSE_ALARM
from radartrack.verification.subject import NotGenerated, generated

PACKAGES = ("numpy", "sympy", "mpmath", "python-flint")
Step = Callable[[str, int], None]


@dataclass(frozen=True)
class Effort:
    """How much is spent on one function.

    Attributes:
        points: of the comparison with many digits.
        nodes: points of the quadrature.
        draws: at each point of the simulation.
        mutants: that are tried; none with 0.
        seed: of everything random.
    """

    points: int
    nodes: int
    draws: int
    mutants: int
    seed: int = 0

    @property
    def layers(self) -> list[Layer]:
        """All but Monte Carlo, whose draws are spread over tasks of their own."""
        found: list[Layer] = [
            Dimensions(self.seed),
            Identity(self.seed),
            Rounding(),
            Accuracy(self.points, self.seed),
            Quadrature(self.nodes, self.seed),
        ]
        return [*found, Mutants(self.mutants, self.seed)] if self.mutants else found

    def layers_along(self, path: str) -> list[Layer]:
        """Those that look at code; a derivation, its mutants and the function as written are looked at once."""
        once = Identity | Mutants | Rounding
        return [layer for layer in self.layers if path == FUNCTION or not isinstance(layer, once)]


QUICK = Effort(points=2_000, nodes=1, draws=1 << 20, mutants=0)
FULL = Effort(points=100_000, nodes=4, draws=100_000_000, mutants=60)


@dataclass(frozen=True)
class Examination:
    """A task: one layer on one quantity, on one of the paths that users take to it."""

    name: str
    layer: Layer
    path: str = FUNCTION
    own: OwnModels = NONE

    @property
    def key(self) -> str:
        """Its name in a checkpoint."""
        return f"{self.name}/{self.layer.name}/{self.path}"

    def __call__(self) -> dict[str, Any]:
        """The outcome as JSON has it."""
        try:
            quantity = self.own.find(self.name)
            function = self.own.function(quantity)
            subject = (quantity, function) if function else along(self.path, quantity)
            return asdict(examined(self.layer, *subject))
        except NotGenerated as error:
            return asdict(Outcome.failed(self.layer.name, str(error)))


@dataclass
class Campaign:
    """All layers over some quantities.

    Attributes:
        names: of the quantities.
        effort: spent on each.
        checkpoint: a file to go on from, or the place for one; None for none.
        own: models of one's own that the names may be of; their code is added before anything runs.
    """

    names: Sequence[str]
    effort: Effort
    checkpoint: Path | None = None
    own: OwnModels = NONE
    _trials: dict[str, list[Trial]] = field(default_factory=dict)
    _reasons: dict[str, str] = field(default_factory=dict)

    @cached_property
    def kept(self) -> Checkpoint:
        """What is done; to be finished by who has told it.

        Raises:
            NotACheckpoint: when the file that is given holds something else.
        """
        return Checkpoint(
            self.checkpoint, digest_of(_sources(), repr((sorted(self.names), self.effort, *self.own.tables)))
        )

    def run(self, engine: Engine, step: Step) -> list[dict[str, Any]]:
        """Do what is not done yet; `step` is told what has ended and how many tasks there are."""
        kept = self.kept
        todo = list(self._tasks())
        left = [task for task in todo if task.key not in kept.done]
        for _ in range(len(todo) - len(left)):
            step("done before", len(todo))
        with closing(engine.run(enumerate(left))) as results:
            for number, result in results:
                kept.add(left[number].key, result)
                step(left[number].key, len(todo))
        return [self._record(name, kept.done) for name in self.names]

    def _tasks(self) -> Iterator[Examination | Draws]:
        for name in self.names:
            for layer in self.effort.layers:
                yield from self._examinations(name, layer)
        for name in self.names:
            for trial in self._simulations(self._find(name)):
                yield from tasks_for(trial.experiment, self.effort.draws)

    def _examinations(self, name: str, layer: Layer) -> list[Examination]:
        paths = paths_of(self._find(name))
        return [Examination(name, layer, path, self.own) for path in paths if layer in self.effort.layers_along(path)]

    def _find(self, name: str) -> Quantity:
        return self.own.find(name)

    def _function(self, quantity: Quantity) -> Function:
        return self.own.function(quantity) or generated(quantity)

    def _simulations(self, quantity: Quantity) -> list[Trial]:
        if quantity.name not in self._trials:
            self._trials[quantity.name] = list(self._planned(quantity))
        return self._trials[quantity.name]

    def _planned(self, quantity: Quantity) -> Iterator[Trial]:
        if simulated(quantity):
            try:
                yield from trials(quantity, self._function(quantity), self.effort.seed)
            except BROKEN as error:  # a function that is missing among them
                self._reasons[quantity.name] = f"{type(error).__name__}: {error}"

    def _record(self, name: str, done: Mapping[str, Any]) -> dict[str, Any]:
        quantity = self._find(name)
        outcomes = [self._along_all_paths(self._examinations(name, layer), done) for layer in self.effort.layers]
        outcomes.append(asdict(self._monte_carlo(quantity, done)))
        verdict = max(map(Outcome.read, outcomes), key=lambda outcome: outcome.severity).verdict
        return {"quantity": name, "verdict": verdict, "paths": list(paths_of(quantity)), "layers": outcomes}

    def _along_all_paths(self, tasks: Sequence[Examination], done: Mapping[str, Any]) -> dict[str, Any]:
        """The worst outcome of one layer, and the figure of each path."""
        outcomes = {task.path: Outcome.read(done[task.key]) for task in tasks}
        path, outcome = max(outcomes.items(), key=lambda item: item[1].severity)
        figures = {path: outcome.figure for path, outcome in outcomes.items()}
        detail = outcome.detail if len(outcomes) == 1 else f"{path}: {outcome.detail}"
        return asdict(replace(outcome, figures=figures, detail=detail))

    def _monte_carlo(self, quantity: Quantity, done: Mapping[str, Any]) -> Outcome:
        if not simulated(quantity):
            return monte_carlo.reason(quantity)
        planned = self._simulations(quantity)
        if not planned:
            return Outcome.failed(monte_carlo.NAME, self._reasons[quantity.name])
        results = ((trial, self._sums(trial, done), _departures(quantity, trial)) for trial in planned)
        return monte_carlo.decided(results, budget(quantity))

    def _sums(self, trial: Trial, done: Mapping[str, Any]) -> Sums | ValueError:
        total: Sums | None = None
        for task in tasks_for(trial.experiment, self.effort.draws):
            record = done[task.key]
            if record is None:
                return ValueError("not a number")
            total = reduce(add, [total, Sums.read(record)]) if total else Sums.read(record)
        return total if total is not None else ValueError("nothing was drawn")


def report(records: Sequence[Mapping[str, Any]], effort: Effort) -> dict[str, Any]:
    """Everything that a reader needs to repeat the run."""
    versions = {name: importlib.metadata.version(name) for name in PACKAGES if _installed(name)}
    return {
        "effort": asdict(effort),
        "sets_of_errors_in_a_chunk": CHUNK,
        "false_alarm_of_the_catalogue": FALSE_ALARM,
        "versions": {"python": platform.python_version(), "radartrack": _own_version(), **versions},
        "functions": list(records),
    }


def _departures(quantity: Quantity, trial: Trial) -> dict[str, Departures]:
    """How far the conversions depart from the function that was simulated; one that breaks down is nowhere."""
    others, found = paths_of(quantity)[1:], {}
    for path in others:
        try:
            found[path] = departures(quantity, trial, generated(quantity), along(path, quantity)[1])
        except BROKEN:
            found[path] = (math.nan,)
    return found


def _installed(name: str) -> bool:
    try:
        importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return False
    return True


def _own_version() -> str:
    return importlib.metadata.version("radartrack") if _installed("radartrack") else "not installed"


def _sources() -> list[Path]:
    """What the outcome depends on: derivations, generated code and this package."""
    packages = ("radartrack.derive", "radartrack.generated", "radartrack.verification")
    specs = [find_spec(package) for package in packages]
    return [Path(place) for spec in specs if spec for place in spec.submodule_search_locations or ()]
