"""Replacement of a whole directory in one step.

The new directory is written beside the target, flushed to disk, and exchanged with the target by one system
call (renameat2 on Linux, renamex_np on macOS). A process killed at any moment leaves at the target either all
of the old directory or all of the new one, and no reader ever finds it missing.

Where the system or the file system cannot exchange directories, two renames follow one another. A process
killed between them leaves the target missing, and the new directory complete beside it; the next replacement
begins by putting it in place. Where not even a rename is possible (an overlay with the directory in a lower
layer), the old directory is deleted instead, and that moment lasts as long as the deletion.

Only names of the form `.NAME.swap-*` are used beside the target directory. What a killed process leaves under them
goes with the next replacement, which knows it by what the lock says; what else is called so is left alone. On Windows
nothing is flushed: the promise does not extend to a power failure.
"""

import contextlib
import ctypes
import errno
import os
import secrets
import shutil
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

if sys.platform == "win32":
    import msvcrt
else:
    import fcntl

_CANNOT_EXCHANGE = {errno.ENOSYS, errno.EINVAL, errno.ENOTSUP, errno.EOPNOTSUPP, errno.EXDEV}
_AT_FDCWD = -100
_RENAME_EXCHANGE = 2
_RENAME_SWAP = 2
_LOCKED = b"radartrack is replacing a directory; what is beside this file is a part of that.\n"


def replace_directory(target: Path, write: Callable[[Path], None]) -> None:
    """Replace a directory, or create it, by what `write` puts into the empty directory that it is handed.

    Nothing else that the target held remains. A symbolic link at `target` is followed.

    Raises:
        NotADirectoryError: there is something other than a directory at `target`.
        BlockingIOError: it is being replaced by somebody else at this moment.
        FileExistsError: something is called as what is written beside the target, and is not known as a remainder.
        OSError: the file system refuses.
        Exception: whatever `write` raises; the target is then as before.

    """
    target = target.resolve()
    if target.exists() and not target.is_dir():
        raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR), str(target))
    with _locked(target) as left_behind:
        if left_behind:
            _clean_up(target)
        else:
            _refuse_others(target)
        try:
            new = _beside(target, "new")
            new.mkdir()
            write(new)
            _flush(new, *new.rglob("*"))
            _put_in_place(new, target)
        finally:
            _clean_up(target)


def replace_file(target: Path, content: str | bytes) -> None:
    """Replace a file, or create it, in one step; text is written as UTF-8, with its line ends as they are.

    A symbolic link at `target` is followed. Whatever goes wrong, the file is as before.

    Raises:
        OSError: the file system refuses, or there is a device, a pipe or a directory.

    """
    replace_file_by(target, lambda new: _write(new, content))


def replace_file_by(target: Path, write: Callable[[Path], None]) -> None:
    """Replace a file, or create it, in one step by what `write` puts at the new place that it is handed.

    A symbolic link at `target` is followed. Whatever goes wrong, the file is as before.

    Raises:
        OSError: the file system refuses, or there is a device, a pipe or a directory.
        Exception: whatever `write` raises.

    """
    target = Path(os.path.realpath(target))
    if target.exists() and not target.is_file():
        raise OSError(errno.EINVAL, "this is no file that could be replaced", str(target))
    new = target.with_name(f".swap-{secrets.token_hex(8)}")
    try:
        write(new)
        if target.exists():
            shutil.copymode(target, new)
        _flush(new)
        new.replace(target)
    except BaseException:
        new.unlink(missing_ok=True)
        raise
    _flush(target.parent)


def _write(new: Path, content: str | bytes) -> None:
    with new.open("xb") as file:
        file.write(content.encode() if isinstance(content, str) else content)


def _beside(target: Path, role: str) -> Path:
    return target.with_name(f".{target.name}.swap-{role}")


def _clean_up(target: Path) -> None:
    """Finish what was begun with two renames, and remove what is left of any replacement."""
    if _beside(target, "ready").exists():
        _install(target)
    _discard(_beside(target, "new"))
    _discard(_beside(target, "old"))


def _refuse_others(target: Path) -> None:
    for path in (_beside(target, role) for role in ("new", "old", "ready")):
        if os.path.lexists(path):
            raise FileExistsError(errno.EEXIST, "this is in the way, and nothing says that it may go", str(path))


def _put_in_place(new: Path, target: Path) -> None:
    if not target.exists():
        new.rename(target)
    elif not _exchange(new, target):
        # Under this name it is known to be complete.
        new.rename(_beside(target, "ready"))
        _install(target)
    _flush(target.parent)


def _install(target: Path) -> None:
    old = _beside(target, "old")
    _discard(old)
    if target.exists():
        try:
            target.rename(old)
        except OSError as error:
            if error.errno != errno.EXDEV:
                raise
            shutil.rmtree(target)
    _beside(target, "ready").rename(target)


def _discard(directory: Path) -> None:
    with contextlib.suppress(FileNotFoundError):
        shutil.rmtree(directory)


def _exchange(first: Path, second: Path) -> bool:
    """Exchange two directories in one step; False where that cannot be done."""
    if sys.platform == "win32":
        return False
    libc = ctypes.CDLL(None, use_errno=True)
    names = os.fsencode(first), os.fsencode(second)
    if hasattr(libc, "renameat2"):
        failed = libc.renameat2(_AT_FDCWD, names[0], _AT_FDCWD, names[1], _RENAME_EXCHANGE)
    elif hasattr(libc, "renamex_np"):
        failed = libc.renamex_np(names[0], names[1], _RENAME_SWAP)
    else:
        return False
    number = ctypes.get_errno()
    if failed and number not in _CANNOT_EXCHANGE:
        raise OSError(number, os.strerror(number), str(first), None, str(second))
    return not failed


def _flush(*paths: Path) -> None:
    if sys.platform == "win32":
        return
    for path in paths:
        if path.is_symlink() or not (path.is_file() or path.is_dir()):
            continue
        try:
            descriptor = os.open(path, os.O_RDONLY)
        except PermissionError:  # not written here: a file that is kept
            continue
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)


@contextlib.contextmanager
def _locked(target: Path) -> Iterator[bool]:
    """Hold the lock; True when a process that was killed held it before."""
    path = _beside(target, "lock")
    descriptor = _lock(path)
    while not _is_at(descriptor, path):  # whoever held it before has removed the file after we opened it
        os.close(descriptor)
        descriptor = _lock(path)
    found = os.read(descriptor, len(_LOCKED) + 1)
    if not _LOCKED.startswith(found):
        os.close(descriptor)
        raise FileExistsError(errno.EEXIST, "this is in the way, and is no lock", str(path))
    try:
        os.write(descriptor, _LOCKED[len(found) :])
        yield bool(found)
    finally:
        if sys.platform == "win32":
            os.ftruncate(descriptor, 0)
        else:
            path.unlink()
        os.close(descriptor)


def _lock(path: Path) -> int:
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        if sys.platform == "win32":
            msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
        else:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        os.close(descriptor)
        reason = "the directory is just being replaced by whoever holds this lock"
        raise BlockingIOError(errno.EAGAIN, reason, str(path)) from None
    return descriptor


def _is_at(descriptor: int, path: Path) -> bool:
    try:
        return os.path.samestat(os.fstat(descriptor), path.stat())
    except FileNotFoundError:
        return False
