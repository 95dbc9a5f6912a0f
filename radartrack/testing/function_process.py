"""A process of its own that diagnoses a function of a file: the function may print, hang or end the process.

Run as `python -m radartrack.testing.function_process`; it reads one request and writes one answer, both JSON.
"""

from __future__ import annotations

import importlib.util
import io
import json
import os
import signal
import subprocess
import sys
import threading
import time
import traceback
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import Any

COMMAND = (sys.executable, "-P", "-m", "radartrack.testing.function_process")
START = 120.0  # seconds that all but the function may take
WATCHED = 0.05  # seconds
PRINTS = "it prints while it is called"

Request = Mapping[str, Any]


class CannotRun(Exception):
    """A function cannot be run to its end."""


def diagnosed(request: Request, timeout: float) -> dict[str, Any]:
    """The record of a diagnosis, and its words as `text`.

    Args:
        request: `file`, `function`, and the arguments of `diagnose` but the function; in place of models the data of
            `files` that declare them.
        timeout: seconds that a call of the function may take.

    Raises:
        CannotRun: with the reason.
    """
    try:
        done = subprocess.run(  # noqa: S603 - this interpreter, and a module of this package
            COMMAND,
            input=json.dumps({**request, "timeout": timeout}, default=str),
            stdout=subprocess.PIPE,
            encoding="utf-8",
            check=False,
            timeout=min(timeout + START, threading.TIMEOUT_MAX),
        )
    except subprocess.TimeoutExpired:
        raise CannotRun(f"{request['function']} was not diagnosed within {timeout + START:g} s") from None
    if not done.stdout:
        how = f"signal {-done.returncode}" if done.returncode < 0 else f"exit code {done.returncode}"
        raise CannotRun(f"{request['function']} ended the process that ran it, with {how}")
    answer: dict[str, Any] = json.loads(done.stdout)
    if "cannot" in answer:
        raise CannotRun(answer["cannot"])
    return answer


def main() -> None:
    """Read a request, diagnose, answer."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the parent
    request = json.loads(sys.stdin.buffer.read())
    answers, printed = _apart()
    watched = _Watched(request["function"], request["timeout"], answers)
    try:
        function = watched(loaded(Path(request["file"]), request["function"]))
        printed.count = 0  # what its file prints is another thing
        answer = _answer(function, request)
        if printed.count:
            answer["remarks"] = [*answer["remarks"], PRINTS]
            answer["text"] += f"\n  {PRINTS}"
    except CannotRun as error:
        answer = {"cannot": str(error)}
    _tell(answers, answer)


def _answer(function: Callable[..., Any], request: Request) -> dict[str, Any]:
    from radartrack.derive.reading.model_table import read_models  # noqa: PLC0415 - after the streams are apart
    from radartrack.testing.diagnosing import CannotDiagnose, diagnose  # noqa: PLC0415 - after the streams are apart

    options = {name: request[name] for name in ("arguments", "degrees", "variances", "given")}
    try:
        models = [model for data in request.get("files", ()) for model in read_models(data)]
        found = diagnose(function, request["name"], models=models, **options)
    except CannotDiagnose as error:
        raise CannotRun(f"{request['function']}: {error}") from None
    except (KeyError, ValueError) as error:
        raise CannotRun(str(error)) from None
    return {**found.record, "text": str(found)}


class _Counting(io.TextIOBase):
    """Takes what is printed and keeps nothing but its length."""

    count = 0

    def writable(self) -> bool:
        return True

    def write(self, text: str) -> int:
        self.count += len(text)
        return len(text)


def _apart() -> tuple[int, _Counting]:
    """A descriptor for the answer that nothing else writes to; what the function prints is counted and dropped."""
    answers = os.dup(1)
    nowhere = os.open(os.devnull, os.O_RDWR)
    os.dup2(nowhere, 0)
    os.dup2(nowhere, 1)
    os.close(nowhere)
    printed = _Counting()
    sys.stdout = printed
    return answers, printed


def _tell(answers: int, answer: Mapping[str, Any]) -> None:
    with os.fdopen(answers, "w", encoding="utf-8") as stream:
        json.dump(answer, stream)
    os._exit(0)  # whatever threads the function has left


class _Watched:
    """Notices that a function, or its file, does not come to an end; what the diagnosis takes does not count."""

    def __init__(self, name: str, timeout: float, answers: int) -> None:
        self._name, self._timeout, self._answers = name, timeout, answers
        self._inside, self._since = "while it is imported", time.monotonic()
        threading.Thread(target=self._watch, daemon=True).start()

    def __call__(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """The function, which says where it is."""
        self._inside = ""

        def watched(*arguments: Any, **named: Any) -> Any:
            self._since = time.monotonic()
            self._inside = f"when called with {', '.join(map(repr, (*arguments, *named.values())))}"
            try:
                return function(*arguments, **named)
            finally:
                self._inside = ""

        for name in ("argtypes", "nin"):  # what a function of C or a ufunc takes
            if hasattr(function, name):
                setattr(watched, name, getattr(function, name))
        watched.__wrapped__ = function  # type: ignore[attr-defined]
        return watched

    def _watch(self) -> None:
        while not (inside := self._inside) or time.monotonic() - self._since < self._timeout:
            time.sleep(WATCHED)
        what = f"{self._name} does not return {inside} (stopped after {self._timeout:g} s)"
        _tell(self._answers, {"cannot": what})


def loaded(path: Path, name: str) -> Callable[..., Any]:
    """A function of a file, which is run as Python runs it."""
    sys.path.insert(0, str(path.resolve().parent))
    spec = importlib.util.spec_from_file_location(path.stem, path)
    if spec is None or spec.loader is None:
        raise CannotRun(f"{path} is no Python file")
    module = importlib.util.module_from_spec(spec)
    sys.modules[path.stem] = module
    try:
        spec.loader.exec_module(module)
    except BaseException as error:  # noqa: BLE001 - SystemExit too
        place = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(path)]
        line = f", line {place[-1]}" if place else ""
        raise CannotRun(f"{path} cannot be imported: {type(error).__name__}: {error}{line}") from None
    found: Any = module
    for part in name.split("."):
        if not hasattr(found, part):
            near = get_close_matches(part, [known for known in dir(found) if not known.startswith("_")], n=3)
            hint = f"; did you mean {' or '.join(near)}?" if near else ""
            raise CannotRun(f"{path} has no function {name}{hint}")
        found = getattr(found, part)
    if not callable(found):
        raise CannotRun(f"{name} in {path} is no function but a {type(found).__name__}")
    return found  # type: ignore[no-any-return]


if __name__ == "__main__":
    main()
