import os
import subprocess
import sys
import time

import pytest

from radartrack.derive.checking.papers.processor_time import processor_time

if processor_time(os.getpid()) is None:
    pytest.skip("this system does not tell what a process computed", allow_module_level=True)


def test_it_is_what_the_process_itself_says() -> None:
    while time.process_time() < 0.1:
        pass
    before, told, after = time.process_time(), processor_time(os.getpid()), time.process_time()
    assert told is not None
    assert before - 0.05 <= told <= after + 0.05  # the system counts in hundredths


def test_a_process_that_waits_computes_nothing() -> None:
    with subprocess.Popen([sys.executable, "-c", "print(flush=True); input()"], stdin=-1, stdout=-1) as child:
        assert child.stdout is not None
        child.stdout.readline()
        while processor_time(child.pid) != (seen := processor_time(child.pid)):
            time.sleep(0.01)
        time.sleep(0.2)
        assert processor_time(child.pid) == pytest.approx(seen, abs=0.05)
        child.kill()


def test_of_a_process_that_ended_nothing_is_told() -> None:
    with subprocess.Popen([sys.executable, "-c", ""]) as child:
        child.wait()
    assert processor_time(child.pid) is None
