"""Whatever happens, the target is all of the old directory or all of the new one."""

import ctypes
import errno
import fcntl
import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from radartrack._system import directory_swap
from radartrack._system.directory_swap import replace_directory, replace_file
from tests.radartrack._system.replacements import (
    NAMES,
    complete_set,
    fail,
    read_set,
    rename_like_an_overlay,
    write_set,
)

REPLACEMENTS = Path(__file__).with_name("replacements.py")
OLD, NEW = complete_set("old"), complete_set("new")


def write_new(directory: Path) -> None:
    write_set(directory, "new")


def names_beside(target: Path) -> list[str]:
    return [path.name for path in target.parent.iterdir()]


@pytest.fixture
def target(tmp_path: Path) -> Path:
    target = tmp_path / "generated"
    target.mkdir()
    write_set(target, "old")
    return target


@pytest.fixture(params=["exchange", "rename", "delete"])
def mode(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    if request.param != "exchange":
        monkeypatch.setattr(directory_swap, "_exchange", lambda *_: False)
    if request.param == "delete":
        monkeypatch.setattr(Path, "rename", rename_like_an_overlay)
    return str(request.param)


@pytest.mark.usefixtures("mode")
def test_only_what_was_written_remains(target: Path) -> None:
    (target / "orphan.py").write_text("old")
    (target / "folder").mkdir()
    replace_directory(target, write_new)
    assert read_set(target) == NEW
    assert names_beside(target) == ["generated"]


def test_missing_directory_is_created(tmp_path: Path) -> None:
    target = tmp_path / "generated"
    replace_directory(target, write_new)
    assert read_set(target) == NEW
    assert names_beside(target) == ["generated"]


def test_folders_and_links_in_the_new_directory_are_kept(target: Path) -> None:
    def write(new: Path) -> None:
        (new / "folder" / "inner").mkdir(parents=True)
        (new / "folder" / "inner" / "file").write_text("deep")
        (new / "dangling").symlink_to("nowhere")

    replace_directory(target, write)
    assert (target / "folder" / "inner" / "file").read_text() == "deep"
    assert (target / "dangling").is_symlink()


def test_the_permissions_are_those_of_an_ordinary_new_directory(target: Path) -> None:
    ordinary = target.with_name("ordinary")
    ordinary.mkdir()
    replace_directory(target, write_new)
    assert target.stat().st_mode == ordinary.stat().st_mode


def test_a_symbolic_link_is_followed(target: Path) -> None:
    link = target.with_name("link")
    link.symlink_to(target)
    replace_directory(link, write_new)
    assert link.is_symlink()
    assert read_set(target) == NEW


def test_a_file_in_the_place_of_the_directory_is_refused(tmp_path: Path) -> None:
    target = tmp_path / "generated"
    target.write_text("precious")
    with pytest.raises(NotADirectoryError, match="generated"):
        replace_directory(target, write_new)
    assert target.read_text() == "precious"


@pytest.mark.usefixtures("mode")
@pytest.mark.parametrize("error", [ValueError, KeyboardInterrupt, OSError])
def test_a_writer_that_fails_changes_nothing(target: Path, error: type[BaseException]) -> None:
    before = target.stat().st_ino

    def write(new: Path) -> None:
        write_new(new)
        raise error

    with pytest.raises(error):
        replace_directory(target, write)
    assert read_set(target) == OLD
    assert target.stat().st_ino == before
    assert names_beside(target) == ["generated"]


def test_a_writer_that_fails_creates_nothing(tmp_path: Path) -> None:
    with pytest.raises(InterruptedError):
        replace_directory(tmp_path / "generated", fail)
    assert list(tmp_path.iterdir()) == []


def test_all_is_flushed_before_it_is_put_in_place(target: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    old = target.stat().st_ino
    written: set[int] = set()
    flushed: dict[bool, set[int]] = {True: set(), False: set()}

    def write(new: Path) -> None:
        write_new(new)
        (new / "folder").mkdir()
        written.update(path.stat().st_ino for path in [new, *new.iterdir()])

    def flush(file: int) -> None:
        flushed[target.stat().st_ino == old].add(os.fstat(file).st_ino)

    monkeypatch.setattr(os, "fsync", flush)
    replace_directory(target, write)
    assert flushed == {True: written, False: {target.parent.stat().st_ino}}


def refuse_with(number: int, monkeypatch: pytest.MonkeyPatch) -> None:
    def renameat2(*_: object) -> int:
        ctypes.set_errno(number)
        return -1

    monkeypatch.setattr(ctypes, "CDLL", lambda *_, **__: SimpleNamespace(renameat2=renameat2))


@pytest.mark.parametrize("number", [errno.EINVAL, errno.ENOSYS, errno.EXDEV, errno.ENOTSUP])
def test_a_file_system_that_cannot_exchange_gets_renames(
    target: Path, number: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    refuse_with(number, monkeypatch)
    replace_directory(target, write_new)
    assert read_set(target) == NEW
    assert names_beside(target) == ["generated"]


def test_a_system_without_the_call_gets_renames(target: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ctypes, "CDLL", lambda *_, **__: SimpleNamespace())
    replace_directory(target, write_new)
    assert read_set(target) == NEW


def test_any_other_refusal_is_raised_and_changes_nothing(target: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    refuse_with(errno.EBUSY, monkeypatch)
    with pytest.raises(OSError, match="busy") as raised:
        replace_directory(target, write_new)
    assert raised.value.errno == errno.EBUSY
    assert read_set(target) == OLD
    assert names_beside(target) == ["generated"]


def test_this_system_exchanges(target: Path) -> None:
    """Otherwise the tests of the exchange test something else."""
    other = target.with_name("other")
    other.mkdir()
    assert directory_swap._exchange(target, other)
    assert read_set(other) == OLD


def test_a_directory_put_in_the_gap_by_hand_does_no_harm(target: Path) -> None:
    """A kill between the two renames, then somebody restores the target from elsewhere."""
    for role in ("ready", "old"):
        leftover = target.with_name(f".generated.swap-{role}")
        leftover.mkdir()
        write_set(leftover, role)
    target.with_name(".generated.swap-lock").write_bytes(directory_swap._LOCKED)
    replace_directory(target, write_new)
    assert read_set(target) == NEW
    assert names_beside(target) == ["generated"]


@pytest.mark.parametrize("role", ["new", "old", "ready", "lock"])
def test_a_stranger_s_file_or_folder_that_is_called_as_a_part_of_a_replacement_is_left_alone(target: Path, role: str):
    theirs = target.with_name(f".generated.swap-{role}")
    if role == "lock":
        theirs.write_text("mine")
    else:
        theirs.mkdir()
        write_set(theirs, "mine")
    with pytest.raises(FileExistsError, match=rf"generated\.swap-{role}"):
        replace_directory(target, write_new)
    assert read_set(target) == OLD
    assert theirs.read_text() == "mine" if role == "lock" else read_set(theirs) == complete_set("mine")
    assert sorted(names_beside(target)) == sorted(["generated", theirs.name])


@pytest.mark.parametrize("content", ["σ\r\n", b"\0\xff", ""])
def test_a_file_is_replaced_with_the_permissions_it_had_and_leaves_nothing_beside(tmp_path: Path, content: str | bytes):
    file, link = tmp_path / "file", tmp_path / "link"
    file.write_text("old")
    file.chmod(0o640)
    link.symlink_to(file)
    replace_file(link, content)
    assert file.read_bytes() == (content.encode() if isinstance(content, str) else content)
    assert file.stat().st_mode & 0o777 == 0o640
    assert link.is_symlink()
    assert sorted(names_beside(file)) == ["file", "link"]


@pytest.mark.parametrize("fails", ["open", "fsync", "replace", "encode"])
def test_a_file_that_cannot_be_replaced_is_as_before(tmp_path: Path, fails: str, monkeypatch: pytest.MonkeyPatch):
    file = tmp_path / "file"
    file.write_text("old")

    def full(*_: object, **__: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    if fails != "encode":
        monkeypatch.setattr(os if fails == "fsync" else Path, fails, full)
    with pytest.raises((OSError, UnicodeEncodeError)):
        replace_file(file, "\udcff" if fails == "encode" else "new")
    monkeypatch.undo()
    assert file.read_text() == "old"
    assert names_beside(file) == ["file"]


Kill = dict[str, dict[str, str] | list[str] | None]


@pytest.fixture(scope="module", params=["exchange", "rename", "delete"])
def kills(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, list[Kill]]:
    """What a kill at each step left, how the next replacement mended it although its writer failed."""
    root = tmp_path_factory.mktemp(request.param)
    command = [sys.executable, REPLACEMENTS, "steps", request.param, root]
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return request.param, [json.loads(line) for line in output.splitlines()]


def test_killed_at_any_step_the_target_is_old_or_new_at_the_latest_after_the_next_call(
    kills: tuple[str, list[Kill]],
) -> None:
    _, left = kills
    assert all(kill["next"] in (OLD, NEW) for kill in left)
    assert all(kill["beside"] == ["generated"] for kill in left)
    assert {kill["next"] == NEW for kill in left} == {True, False}
    assert len(left) > len(OLD)


def test_killed_at_any_step_the_target_is_old_or_new_or_the_new_set_waits_beside_it(
    kills: tuple[str, list[Kill]],
) -> None:
    mode, left = kills
    gap = [kill for kill in left if kill["killed"] not in (OLD, NEW)]
    assert all(kill["ready"] == NEW for kill in gap)
    assert bool(gap) == (mode != "exchange")


@contextmanager
def replaced_forever(target: Path) -> Iterator[None]:
    before = target.stat().st_ino
    process = subprocess.Popen([sys.executable, REPLACEMENTS, "forever", target])
    try:
        while target.stat().st_ino == before:
            assert process.poll() is None
            time.sleep(0.001)
        yield
    finally:
        process.kill()
        process.wait()


def test_killed_at_random_moments_the_target_is_complete(target: Path) -> None:
    for moment in np.random.default_rng(7).uniform(0, 0.03, size=12):
        with replaced_forever(target):
            time.sleep(moment)
        assert_complete(read_set(target))
    replace_directory(target, write_new)
    assert names_beside(target) == ["generated"]


def assert_complete(files: dict[str, str] | None) -> str:
    """One text in all files, three times over, and no file missing."""
    assert files is not None
    text = min(files.values()).split(" ")[0]
    assert files in (complete_set(f"{text} "), OLD)
    return text


def read_while_in_place(target: Path) -> dict[str, str] | None:
    """The files, unless the directory was replaced while it was read."""
    directory = os.open(target, os.O_RDONLY)
    try:
        files = {name: read_in(directory, name) for name in NAMES}
        return files if os.path.samestat(os.fstat(directory), target.stat()) else None
    except FileNotFoundError:
        assert not os.path.samestat(os.fstat(directory), target.stat())
        return None
    finally:
        os.close(directory)


def read_in(directory: int, name: str) -> str:
    with os.fdopen(os.open(name, os.O_RDONLY, dir_fd=directory)) as file:
        return file.read()


def writers(texts: set[str]) -> set[str]:
    return {text.split(".")[0] for text in texts if "." in text}


def test_readers_see_complete_sets_while_two_processes_replace_them(target: Path) -> None:
    seen: set[str] = set()
    with replaced_forever(target), replaced_forever(target):
        end = time.monotonic() + 600  # only a defect waits so long
        while (len(seen) < 40 or len(writers(seen)) < 2) and time.monotonic() < end:
            files = read_while_in_place(target)
            if files is not None:
                seen.add(assert_complete(files))
    assert len(seen) >= 40
    assert len(writers(seen)) >= 2


def test_while_one_replaces_another_is_refused_and_disturbs_nothing(target: Path) -> None:
    def write(new: Path) -> None:
        write_new(new)
        with pytest.raises(BlockingIOError, match=r"just being replaced.*generated\.swap-lock"):
            replace_directory(target, lambda directory: write_set(directory, "other"))

    replace_directory(target, write)
    assert read_set(target) == NEW
    assert names_beside(target) == ["generated"]


def test_a_lock_whose_file_its_holder_has_just_removed_is_taken_anew(
    target: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lock = target.with_name(".generated.swap-lock")
    flock = fcntl.flock
    calls: list[int] = []

    def holder_ends_just_before(descriptor: int, operation: int) -> None:
        if not calls:
            lock.unlink()
        calls.append(descriptor)
        flock(descriptor, operation)

    def write(new: Path) -> None:
        write_new(new)
        with pytest.raises(BlockingIOError):
            replace_directory(target, write_new)

    monkeypatch.setattr(fcntl, "flock", holder_ends_just_before)
    replace_directory(target, write)
    assert len(calls) == 3
    assert read_set(target) == NEW


@pytest.mark.parametrize("kind", ["directory", "pipe", "link to a pipe"])
def test_what_is_no_file_is_not_replaced_by_one(tmp_path: Path, kind: str):
    target = tmp_path / "target"
    if kind == "directory":
        target.mkdir()
    else:
        os.mkfifo(tmp_path / "pipe")
        target = tmp_path / "pipe"
        if kind.startswith("link"):
            target = tmp_path / "link"
            target.symlink_to("pipe")
    before = sorted(tmp_path.iterdir())
    with pytest.raises(OSError, match="no file that could be replaced"):
        replace_file(target, "content")
    assert sorted(tmp_path.iterdir()) == before
    assert not target.is_file()
