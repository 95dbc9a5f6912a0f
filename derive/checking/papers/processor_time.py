"""How long a process has computed, which on a busy machine is less than the time that has passed."""

import os
from pathlib import Path

PARENTHESIS = b")"  # ends the name of the program, which may hold spaces
USER, SYSTEM = 11, 12  # fields after it


def processor_time(process: int) -> float | None:
    """Seconds; None where the system does not tell, or the process has ended."""
    try:
        fields = Path(f"/proc/{process}/stat").read_bytes().rpartition(PARENTHESIS)[2].split()
        return (int(fields[USER]) + int(fields[SYSTEM])) / os.sysconf("SC_CLK_TCK")
    except (AttributeError, IndexError, OSError, ValueError):
        return None
