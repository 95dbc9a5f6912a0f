"""A process that derives is prepared before it loads SymPy."""

import subprocess
import sys


def test_sympy_finds_what_it_is_told() -> None:
    code = (
        "import gc, sys; from radartrack._system.deriving_process import prepare;"
        "early = 'sympy' in sys.modules; prepare(); import radartrack._regeneration.deriving;"
        "print(early, gc.isenabled(), sys.modules['sympy'].core.cache.SYMPY_CACHE_SIZE)"
    )
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert result.stdout.split() == ["False", "False", "10000"]
