"""Compare tfloom with the real rclpy on random cases: `python -m tests.ros_peer.compare KIND --count N --seed S`.

A kind is a file of `kinds/`, which both Pythons load, and which uses only ROS's names:

- `draw(random) -> case` returns a case as JSON values; or `EVERY` is a list of all cases, of which each number is one;
- `run(case) -> answer` does what the case says and returns what came of it. An exception that it raises is an answer,
  too: its class is compared. Of a value of a class that JSON doesn't have, the class's name is compared as well;
- `KNOWN`, if there are differences on purpose: by the id of a row of `docs/deviations.md`, a function that is given the
  case, their answer and ours, and returns whether this row explains the difference;
- `DEFINITIONS`, if the cases use messages of which tfloom is to read the peer's definitions;
- `RELEASES`, the names of those that are compared with, and whose contradictions tfloom then follows; otherwise Jazzy;
- `WIRE`, if the cases need one: the RMW_IMPLEMENTATION of tfloom; otherwise the nodes stay in the process;
- `SECONDS`, the longest time for a case [s]; otherwise MAX_CASE_S.

Each case is drawn from the seed and its own number, so `--first NUMBER --count 1` repeats it. All cases of a batch run
in one process of each side; where a case ends or stalls it, that is its answer, and a new process runs the rest.
"""

from __future__ import annotations

import argparse
import importlib
import json
import os
import random
import select
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import IO, Any, NamedTuple

from tools.ros_peer import JAZZY, RELEASES, NoPeerError, RosPeer, find

HERE = Path(__file__).parent
WORKER = HERE / "programs" / "compare_worker.py"
KINDS = sorted(path.stem for path in (HERE / "kinds").glob("*.py"))
DEVIATIONS = HERE.parents[1] / "docs" / "deviations.md"

BATCH_SIZE = 500
MAX_CASE_S = 20.0
MAX_START_S = 120.0
"""The longest time for the start of a process on a busy machine, before its first case [s]."""
MAX_SHOWN = 20
"""Number of differences that are printed, unless --all is given."""


class Difference(NamedTuple):
    """A case that both sides answered differently."""

    number: int
    case: Any
    theirs: Any
    ours: Any
    row: str | None
    """The row of docs/deviations.md that explains it."""

    def __str__(self) -> str:
        return f"case {self.number}: {json.dumps(self.case)}\n  theirs: {self.theirs}\n  ours:   {self.ours}"


class Side:
    """One of both: how its Python runs the cases of a kind.

    Args:
        python: The Python.
        environment: Its environment variables.
        seconds: The longest time for a case [s].
    """

    def __init__(self, python: str | Path, environment: Mapping[str, str], seconds: float) -> None:
        self.python = python
        self.environment = dict(environment)
        self.seconds = seconds

    def answers(self, kind: Path, cases: Sequence[Any]) -> list[Any]:
        """Return the answer to each case of a kind's file."""
        answers: list[Any] = []
        while len(answers) < len(cases):
            answers += self._run(kind, cases[len(answers) :])
        return answers

    def _run(self, kind: Path, cases: Sequence[Any]) -> list[Any]:
        """Return the answers of a new process, and of the case that ended or stalled it, how."""
        with tempfile.TemporaryFile() as lines, tempfile.TemporaryFile() as errors:
            lines.write("".join(f"{json.dumps(case)}\n" for case in cases).encode("ascii"))
            lines.seek(0)
            process = subprocess.Popen(
                [str(self.python), str(WORKER), str(kind)],
                stdin=lines,
                stdout=subprocess.PIPE,
                stderr=errors,
                env=self.environment,
            )
            assert process.stdout is not None
            answers: list[Any] = []
            end = {"stalled": True}
            try:
                for line in _lines(process.stdout, self.seconds, first_s=MAX_START_S + self.seconds):
                    answers.append(json.loads(line))  # noqa: PERF401  # those before a TimeoutError stay
                end = {"ended": process.wait(self.seconds)}
            except (TimeoutError, subprocess.TimeoutExpired):
                pass
            finally:
                process.kill()
                process.wait()
                process.stdout.close()
            if not answers and end == {"ended": 1}:  # Python's own code: the kind can't be loaded
                errors.seek(0)
                raise RuntimeError(errors.read().decode(errors="replace"))
            return answers if len(answers) == len(cases) else [*answers, end]


def _lines(stream: IO[bytes], seconds: float, first_s: float) -> Iterator[bytes]:
    """Yield the lines of a pipe to its end.

    Raises:
        TimeoutError: the first line takes longer than `first_s`, or another one than `seconds` [s].
    """
    rest = b""
    limit_s = first_s
    while True:
        deadline_s = time.monotonic() + limit_s
        limit_s = seconds
        while b"\n" not in rest:
            ready, _, _ = select.select([stream], [], [], max(0.0, deadline_s - time.monotonic()))
            if not ready:
                raise TimeoutError
            data = os.read(stream.fileno(), 1 << 16)
            if not data:
                return
            rest += data
        line, _, rest = rest.partition(b"\n")
        yield line


def compare(
    kind: ModuleType,
    peer: RosPeer,
    *,
    count: int,
    seed: int,
    domain: int,
    first: int = 0,
    python: str | Path = sys.executable,
    told: Callable[[str], None] = lambda line: None,
) -> list[Difference]:
    """Return the differences of `count` cases, in order.

    Args:
        kind: The module of the kind.
        peer: The real rclpy.
        count: Number of cases.
        seed: Of all cases.
        domain: The ROS domain of both sides, one after the other.
        first: Number of the first case.
        python: The Python whose tfloom is compared.
        told: Called with a line about each batch.
    """
    seconds = getattr(kind, "SECONDS", MAX_CASE_S)
    ours_environment = os.environ | {
        "ROS_DOMAIN_ID": str(domain),
        "ROS_DISTRO": peer.release.name,
        "RMW_IMPLEMENTATION": getattr(kind, "WIRE", "tfloom_local"),
    }
    if getattr(kind, "DEFINITIONS", False):
        ours_environment["AMENT_PREFIX_PATH"] = str(peer.python.parents[1])
    theirs = Side(peer.python, peer.environment(domain), seconds)
    ours = Side(python, ours_environment, seconds)
    path = Path(str(kind.__file__))
    differences: list[Difference] = []
    for begin in range(first, first + count, BATCH_SIZE):
        numbers = range(begin, min(begin + BATCH_SIZE, first + count))
        cases = [drawn(kind, seed, number) for number in numbers]
        answers = zip(numbers, cases, theirs.answers(path, cases), ours.answers(path, cases), strict=True)
        for number, case, their_answer, our_answer in answers:
            if _text(their_answer) != _text(our_answer):
                row = _row(kind, case, their_answer, our_answer)
                differences.append(Difference(number, case, their_answer, our_answer, row))
        told(f"{numbers[-1] + 1 - first} cases, {len(differences)} differences")
    return differences


def drawn(kind: ModuleType, seed: int, number: int) -> Any:
    """Return a case by its number, as both sides read it."""
    every = getattr(kind, "EVERY", None)
    if every is not None:
        return json.loads(json.dumps(every[number % len(every)]))
    return json.loads(json.dumps(kind.draw(random.Random(f"{seed}/{number}"))))


def _text(answer: Any) -> str:
    # As text, in which 1, 1.0 and true differ, and NaN is equal to itself.
    return json.dumps(answer, sort_keys=True)


def _row(kind: ModuleType, case: Any, theirs: Any, ours: Any) -> str | None:
    known = getattr(kind, "KNOWN", {})
    return next((row for row, explains in known.items() if explains(case, theirs, ours)), None)


def unknown_rows(kind: ModuleType) -> list[str]:
    """Return the ids in a kind's KNOWN that `docs/deviations.md` does not have."""
    page = DEVIATIONS.read_text("utf-8")
    return [row for row in getattr(kind, "KNOWN", {}) if f"\n| {row} |" not in page]


def load_kind(name: str) -> ModuleType:
    """Return the module of a kind by its name."""
    return importlib.import_module(f"tests.ros_peer.kinds.{name}")


def main(arguments: Sequence[str] | None = None) -> int:
    """Compare a kind, print the differences, and return 1 if no row explains one."""
    parser = argparse.ArgumentParser(prog="python -m tests.ros_peer.compare", description=__doc__)
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument("kind", choices=KINDS, metavar="KIND", help=", ".join(KINDS))
    parser.add_argument("--count", type=int, default=2000, metavar="N", help="cases (default: 2000)")
    parser.add_argument("--seed", type=int, default=0, metavar="S", help="of all cases (default: 0)")
    parser.add_argument("--first", type=int, default=0, metavar="NUMBER", help="first case (default: 0)")
    parser.add_argument("--domain", type=int, default=int(os.environ.get("ROS_DOMAIN_ID", "100")))
    parser.add_argument("--python", default=sys.executable, help="the Python whose tfloom is compared")
    parser.add_argument("--all", action="store_true", help="print all differences, also those of rows")
    parser.add_argument(
        "--release", choices=RELEASES, help="of the real rclpy (default: the first of the kind's)"
    )
    options = parser.parse_args(arguments)
    kind = load_kind(options.kind)
    release = options.release or next(iter(getattr(kind, "RELEASES", (JAZZY.name,))))
    try:
        peer = find(release=RELEASES[release])
    except NoPeerError as error:
        print(error, file=sys.stderr)
        return 2
    differences = compare(
        kind,
        peer,
        count=options.count,
        seed=options.seed,
        domain=options.domain,
        first=options.first,
        python=options.python,
        told=lambda line: print(line, file=sys.stderr),
    )
    faults = [difference for difference in differences if difference.row is None]
    for difference in differences if options.all else faults[:MAX_SHOWN]:
        print(difference if difference.row is None else f"{difference}\n  row:    {difference.row}")
    rows = Counter(difference.row for difference in differences if difference.row is not None)
    for row, number in rows.items():
        print(f"{number} differences of the row {row}")
    print(
        f"{options.count} cases of {options.kind}, seed {options.seed}: {len(faults)} differences without a row"
    )
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
