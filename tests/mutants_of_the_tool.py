"""What `make mutants` calls around Cosmic Ray: a sample of its mutants, and the tests of the module that is mutated.

python tests/mutants_of_the_tool.py sample SESSION COUNT
python tests/mutants_of_the_tool.py test ORIGINAL
"""

import random
import sqlite3
import subprocess
import sys
from pathlib import Path

CHECKER = ["checking"]
TESTS = {
    "operator": ["test_operator.py"],
    "exponential": ["test_exponential.py", "test_operator.py"],
    "numpy_code": ["test_numpy_code.py", "test_writer.py"],
    "writer": ["test_writer.py"],
    "bernstein": ["test_bernstein.py", "test_stable.py"],
    "stable": ["test_stable.py", "test_forms.py"],
    "common": ["test_common.py"],
    "rational": ["test_rational.py"],
}


LEFT = """
    select job_id, module_path from mutation_specs where job_id not in (select job_id from work_results)
    order by module_path, start_pos_row, start_pos_col, operator_name, occurrence, operator_args
"""


def sample(session: Path, count: int) -> None:
    """Keep about so many of the mutants that are not filtered out, each module having as many, always the same."""
    with sqlite3.connect(session) as database:
        by_module: dict[str, list[str]] = {}
        for job, module in database.execute(LEFT):
            by_module.setdefault(module, []).append(job)
        share = -(-count // len(by_module))
        for jobs in by_module.values():
            random.Random(0).shuffle(jobs)
            database.executemany("delete from work_items where job_id = ?", [(job,) for job in jobs[share:]])
            database.executemany("delete from mutation_specs where job_id = ?", [(job,) for job in jobs[share:]])


def test(original: Path) -> int:
    """Run the tests of the one module of `derive` that differs from the original; 0 when they pass."""
    here = Path("derive")
    changed = [path for path in sorted(here.rglob("*.py")) if path.read_bytes() != (original / path).read_bytes()]
    names = {name for path in changed for name in TESTS.get(path.stem, CHECKER)}
    files = [f"tests/derive/{name}" for name in sorted(names)] or ["tests/derive"]
    call = [sys.executable, "-m", "pytest", "-x", "-q", "-n", "0", "-p", "no:cacheprovider", *files]
    return subprocess.run(call, check=False).returncode


if __name__ == "__main__":
    command, place, *rest = sys.argv[1:]
    if command == "sample":
        sample(Path(place), int(rest[0]))
    else:
        raise SystemExit(test(Path(place)))
