"""Progress of long commands, on the error stream."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from rich.progress import Progress, ProgressColumn

from radartrack._system import terminal


@contextmanager
def progress_on_terminals(*columns: ProgressColumn) -> Iterator[Progress]:
    """A line that is gone in the end; where the error stream is no terminal, nothing, not even an empty line."""
    console = terminal.error_console()
    progress = Progress(*columns, console=console, transient=True, disable=not console.is_terminal)
    if progress.disable:
        yield progress
        return
    with progress:
        yield progress
