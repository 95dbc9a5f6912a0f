"""Replacements of a directory in a process of their own, for tests that kill it.

replacements.py steps MODE ROOT   kills at every step in turn, and a line of JSON on what each of them left
replacements.py forever TARGET    one new set after the other
"""

import errno
import itertools
import json
import os
import signal
import sys
from functools import partial
from pathlib import Path
from unittest import mock

from radartrack._system import directory_swap

NAMES = [f"{number}.py" for number in range(8)]
PIECES = 3
RENAME = Path.rename


def write_set(directory: Path, text: str) -> None:
    for name in NAMES:
        with (directory / name).open("w") as file:
            for _ in range(PIECES):
                file.write(text)
                file.flush()
                sys.audit("replacements.piece")


def complete_set(text: str) -> dict[str, str]:
    return dict.fromkeys(NAMES, PIECES * text)


def read_set(directory: Path) -> dict[str, str] | None:
    if not directory.is_dir():
        return None
    return {path.name: path.read_text() for path in directory.iterdir()}


def kill_at(step: int) -> None:
    """Kill this process at a step; Python audits what touches files before it takes effect."""
    steps = itertools.count()
    events = ("open", "os.", "fcntl.", "ctypes.dlsym", "replacements.")

    def hook(event: str, _: object) -> None:
        if event.startswith(events) and next(steps) == step:
            os.kill(os.getpid(), signal.SIGKILL)

    sys.addaudithook(hook)


def rename_like_an_overlay(source: Path, destination: Path) -> Path:
    if not source.name.startswith("."):
        raise OSError(errno.EXDEV, os.strerror(errno.EXDEV), str(source))
    return RENAME(source, destination)


def restrict_to(mode: str) -> None:
    if mode in {"rename", "delete"}:
        mock.patch.object(directory_swap, "_exchange", return_value=False).start()
    if mode == "delete":
        mock.patch.object(Path, "rename", rename_like_an_overlay).start()


def is_killed_at(step: int, target: Path) -> bool:
    child = os.fork()
    if child == 0:
        kill_at(step)
        directory_swap.replace_directory(target, lambda new: write_set(new, "new"))
        os._exit(0)
    return os.WIFSIGNALED(os.waitpid(child, 0)[1])


def fail(_: Path) -> None:
    raise InterruptedError


def steps(mode: str, root: Path) -> None:
    restrict_to(mode)
    for step in itertools.count():
        target = root / str(step) / "generated"
        target.mkdir(parents=True)
        write_set(target, "old")
        if not is_killed_at(step, target):
            return
        left = {"killed": read_set(target), "ready": read_set(target.with_name(".generated.swap-ready"))}
        try:
            directory_swap.replace_directory(target, fail)
        except InterruptedError:
            left["next"] = read_set(target)
        beside = sorted(path.name for path in target.parent.iterdir())
        sys.stdout.write(json.dumps({**left, "beside": beside}) + "\n")


def forever(target: Path) -> None:
    for number in itertools.count():
        text = f"{os.getpid()}.{number} "
        try:
            directory_swap.replace_directory(target, partial(write_set, text=text))
        except BlockingIOError:
            continue


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["steps", mode, root]:
            steps(mode, Path(root))
        case ["forever", target]:
            forever(Path(target))
