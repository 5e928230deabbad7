"""Programs that end at a random moment end well: on each wire, with each executor, whatever their threads are doing.

`python -m tests.node.test_random_ends 1000 [FIRST]` runs that many, beside each other, and prints how they ended.
"""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import count, islice, product
from pathlib import Path

import pytest

PROGRAM = Path(__file__).parents[1] / "programs" / "random_end.py"
ENDS = ("returns", "exits", "raises", "is interrupted", "raises in a callback")
CODES = {"returns": [0], "exits": [7], "raises": [1], "is interrupted": [130, 1], "raises in a callback": [1]}
"""Python ends by 1 in the place of 130 if, after the traceback, another thread or `atexit` runs code given as text."""
TEXTS = {"raises": "OwnError", "is interrupted": "KeyboardInterrupt", "raises in a callback": "OwnError"}
"""What a program prints of its end."""

TIMEOUT_S = 60.0
CYCLE = 30
"""Numbers in which each wire meets each executor and each end."""


def fault_of(number: int, domain_id: int) -> str | None:
    """Run the program of a number; return how it ended, if that is not as it must."""
    end = ENDS[number // 6 % 5]
    environment = {**os.environ, "ROS_DOMAIN_ID": str(domain_id)}
    command = [sys.executable, str(PROGRAM), str(number)]
    with subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=environment
    ) as program:
        try:
            _, text = program.communicate(timeout=TIMEOUT_S)
        except subprocess.TimeoutExpired:
            program.send_signal(signal.SIGABRT)  # with a traceback, where PYTHONFAULTHANDLER is set
            _, text = program.communicate()
            return f"{' '.join(command)} does not end: {end}\n{text}"
    code = 130 if program.returncode == -signal.SIGINT else program.returncode  # as a shell says it
    if code in CODES[end] and TEXTS.get(end, "") in text and "Fatal Python error" not in text:
        return None
    return f"{' '.join(command)} ended with {program.returncode}: {end}\n{text}"


def faults_of(numbers: Iterator[int], domain_id: int) -> list[str]:
    """Run the programs of numbers beside each other, and return how those ended that did not as they must."""
    numbers_left = _Shared(numbers)

    def run(_: int) -> list[str | None]:
        return [fault_of(number, domain_id) for number in numbers_left]

    workers = 5 * (os.cpu_count() or 1)  # most wait for a long callback
    with ThreadPoolExecutor(workers) as pool:
        return [fault for ends in pool.map(run, range(workers)) for fault in ends if fault is not None]


class _Shared:
    """An iterator that several threads take from."""

    def __init__(self, numbers: Iterator[int]) -> None:
        from threading import Lock

        self._numbers = numbers
        self._lock = Lock()

    def __iter__(self) -> _Shared:
        return self

    def __next__(self) -> int:
        with self._lock:
            return next(self._numbers)


def random_first() -> int:
    """Return a random number that is the first of a cycle."""
    return random.randrange(10**6) * CYCLE


def some_of_a_cycle() -> Iterator[int]:
    """Return numbers of a random cycle in which each end meets each wire, and the executors take turns."""
    first, turn = random_first(), random.randrange(3)
    for end, wire in product(range(5), range(2)):
        yield first + wire + 2 * ((end + wire + turn) % 3) + 6 * end


def test_programs_that_end_at_a_random_moment_end_well(domain_id: int) -> None:
    faults = faults_of(some_of_a_cycle(), domain_id)
    assert not faults, "\n\n".join(faults)


@pytest.mark.slow
def test_programs_of_four_cycles_end_well(domain_id: int) -> None:
    faults = faults_of(islice(count(random_first()), 4 * CYCLE), domain_id)
    assert not faults, "\n\n".join(faults)


def main(length: int, first: int) -> None:
    from tests.conftest import hold_domain

    began = time.monotonic()
    with hold_domain() as domain_id:
        faults = faults_of(iter(range(first, first + length)), domain_id)
    print(*faults, sep="\n\n")
    kinds = Counter(fault.splitlines()[0].split(str(PROGRAM))[1].split(maxsplit=1)[1] for fault in faults)
    print(
        f"{length} programs from {first} in {time.monotonic() - began:.0f} s, {len(faults)} faults: {dict(kinds)}"
    )


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else random_first())
