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
from radartrack.verification import compiled_c
from radartrack.verification.checkpoint import Checkpoint, digest_of
from radartrack.verification.engines import Engine
from radartrack.verification.layers import monte_carlo
from radartrack.verification.layers.dimensions import Dimensions
from radartrack.verification.layers.identity import Identity
from radartrack.verification.layers.loosened import in_single
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
        """Those that look at code; a derivation and its mutants are looked at once, with the function."""
        return [
            layer for layer in self.layers if path == FUNCTION or not isinstance(layer, Identity | Mutants | Rounding)
        ]


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
            if self.path in compiled_c.PATHS:
                layer = in_single(self.layer) if self.path == compiled_c.SINGLE else self.layer
                return asdict(examined(layer, quantity, compiled_c.along(self.path, quantity)))
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
        in_c: whether what is verified is the code in C, compiled, in both precisions.
    """

    names: Sequence[str]
    effort: Effort
    checkpoint: Path | None = None
    own: OwnModels = NONE
    in_c: bool = False
    _trials: dict[str, list[Trial]] = field(default_factory=dict)
    _reasons: dict[str, str] = field(default_factory=dict)

    @cached_property
    def kept(self) -> Checkpoint:
        """What is done; to be finished by who has told it.

        Raises:
            NotACheckpoint: when the file that is given holds something else.
        """
        return Checkpoint(
            self.checkpoint, digest_of(_sources(), repr((sorted(self.names), self.effort, self.in_c, *self.own.tables)))
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
            for layer in self._layers:
                yield from self._examinations(name, layer)
        for name in self.names:
            for trial in self._simulations(self._find(name)):
                yield from tasks_for(trial.experiment, self.effort.draws)

    def _examinations(self, name: str, layer: Layer) -> list[Examination]:
        paths = self._paths(self._find(name))
        return [Examination(name, layer, path, self.own) for path in paths if layer in self.effort.layers_along(path)]

    @property
    def _layers(self) -> list[Layer]:
        """Those of the effort; for C those that look at code."""
        return self.effort.layers_along(compiled_c.DOUBLE) if self.in_c else self.effort.layers

    def _paths(self, quantity: Quantity) -> tuple[str, ...]:
        return compiled_c.PATHS if self.in_c else paths_of(quantity)

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
        outcomes = [self._along_all_paths(self._examinations(name, layer), done) for layer in self._layers]
        outcomes.append(asdict(self._monte_carlo(quantity, done)))
        verdict = max(map(Outcome.read, outcomes), key=lambda outcome: outcome.severity).verdict
        return {"quantity": name, "verdict": verdict, "paths": list(self._paths(quantity)), "layers": outcomes}

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
        results = ((trial, self._sums(trial, done), self._departures(quantity, trial)) for trial in planned)
        return monte_carlo.decided(results, budget(quantity))

    def _departures(self, quantity: Quantity, trial: Trial) -> dict[str, Departures]:
        """How far other paths depart from the function that was simulated; one that breaks down is nowhere.

        Where errors are small, a simulation tells apart what single precision does not.
        """
        found = {}
        for path in self._paths(quantity):
            if path in {FUNCTION, compiled_c.SINGLE}:
                continue
            try:
                other = compiled_c.along(path, quantity) if self.in_c else along(path, quantity)[1]
                found[path] = departures(quantity, trial, self._function(quantity), other)
            except BROKEN:
                found[path] = (math.nan,)
        return found

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
