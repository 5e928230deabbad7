"""Measure the gain of each optimisation in native/: `python -m benchmarks native`, or `-m benchmarks.native NAME ...`.

The extension is built as it ships, and once more without each of them (`plain.py`). Two processes, one of each form,
run the same operation in turns. The result is the median of the ratios of many rounds, in CPU time. The answers of both
must be equal.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from statistics import median
from typing import Any

from benchmarks.domain import DOMAIN_ID
from benchmarks.native import frozen
from benchmarks.native.build import Build, program
from benchmarks.native.plain import EDITS, HERE

STARTS, ROUNDS = 3, 40
TOLERANCE = 1e-9
CLOUD = "do_transform_cloud, a padded point"
TOLERANCES = {CLOUD: 1e-6}
"""Of answers in float32, whose last digits depend on whether a product is rounded before it is added."""
LEAST = 1.10
"""An optimisation with a smaller ratio is removed."""

ROWS: list[tuple[str, str]] = [
    ("name index", "/tf of 100 frames, a transform"),
    ("prefetch", "/tf of 100 frames, a transform, cold caches"),
    ("canonical", "set"),
    ("append", "set_many, a transform"),
    ("names before", "set_many, shuffled, a transform"),
    ("newest links", "lookup, latest, depth 10"),
    ("newest links", "lookup, latest, humanoid"),
    ("chain product", "lookup, latest, humanoid"),
    ("chain product", "lookup, latest, depth 50"),
    ("slerp series", "lookup, middle, depth 10"),
    ("near slerp", "lookup_many, ascending, depth 10, 20 a sample"),
    ("near slerp", "deskew, a point"),
    ("columns", "lookup_many, ascending, depth 10, 20 a sample"),
    ("columns", "lookup_many, ascending, depth 10, 2 a sample"),
    ("wide vectors", "lookup_many, ascending, depth 10, 20 a sample"),
    ("wide vectors", "lookup_many, ascending, depth 10, 2 a sample"),
    ("wide vectors", CLOUD),
    ("search hint", "lookup_many, ascending, depth 10, 2 a sample"),
    ("any order", "lookup_many, shuffled, depth 10"),
    ("radix order", "lookup_many, shuffled, depth 1"),
    ("four at once", CLOUD),
    ("message pool", "decode TFMessage x 100"),
    ("message pool", "decode PoseStamped"),
    ("shared 0 and 1", "decode TFMessage x 100, in a plane"),
    ("shared 0 and 1", "decode PoseStamped"),
    ("ASCII text", "decode JointState of 30"),
    ("size hint", "encode TFMessage x 1"),
    ("kept memory", "decode 8 MB, five held"),
    ("decoded in place", "take a message of 8 MB"),
    ("wake-up if waiting", "post to a busy executor"),
]


class Worker:
    def __init__(self, extension: Path) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-m", "benchmarks.native.worker", str(extension)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            cwd=HERE.parent.parent,
        )

    def __call__(self, what: str, case: str) -> Any:
        assert self._process.stdin
        assert self._process.stdout
        self._process.stdin.write(f"{what} {case}\n")
        self._process.stdin.flush()
        line = self._process.stdout.readline()
        if not line:
            raise SystemExit(f"the process that was to {what} '{case}' has ended")
        return json.loads(line)

    def close(self) -> None:
        self._process.communicate()


def row(name: str, what: str, without: float, with_it: float, ratio: float | None = None) -> None:
    ratio = ratio or without / max(with_it, 1e-9)
    note = "" if ratio >= LEAST else "   less than a tenth"
    print(f"{name:22} {what:48} {without:12,.1f} {with_it:12,.1f} {ratio:7.2f}{note}", flush=True)


def check(name: str, case: str, ours: list[float], plain: list[float]) -> None:
    """Exit if the answers differ, because then their times cannot be compared."""
    tolerance = TOLERANCES.get(case, TOLERANCE)
    if len(ours) != len(plain) or any(abs(a - b) > tolerance for a, b in zip(ours, plain, strict=True)):
        raise SystemExit(f"'{case}' answers otherwise without '{name}'")


def compare(extension: Path, build: Build, name: str, cases: list[str]) -> None:
    plain = build.without(name).module
    times: dict[str, tuple[list[float], list[float]]] = {case: ([], []) for case in cases}
    for _ in range(STARTS):  # the addresses of code and data differ in each start
        workers = Worker(plain), Worker(extension)
        for case in cases:
            check(name, case, workers[1]("answer", case), workers[0]("answer", case))
            for worker in workers:
                worker("time", case)
            for turn in range(ROUNDS):
                for index in (0, 1) if turn % 2 else (1, 0):
                    times[case][index].append(workers[index]("time", case) * 1e9)
            for worker in workers:
                worker("drop", case)
        for worker in workers:
            worker.close()
    for case in cases:
        without, with_it = times[case]
        ratio = median(a / b for a, b in zip(without, with_it, strict=True))  # of adjacent pairs
        row(name, f"{case} [ns]", median(without), median(with_it), ratio)


def beside_writers(build: Build) -> None:
    """Measure the lock by the wall clock, because waiting takes no CPU time."""
    programs = program(build, build.without("fair mutex")), program(build)
    measured: tuple[list[list[float]], list[list[float]]] = ([], [])
    for _ in range(9):
        for one, found in zip(programs, measured, strict=True):
            command = [str(one), "2", "2", "0.3"]
            words = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
            if words[3] != "0":
                raise SystemExit(f"{words[3]} lookups beside writers were answered wrongly")
            found.append([float(word) for word in words])
    without, with_it = ([median(column) for column in zip(*found, strict=True)] for found in measured)
    row("fair mutex", "p99 of an insert of 50 beside two readers [us]", without[1], with_it[1])
    row("fair mutex", "inserts a second beside two readers", without[2], with_it[2], with_it[2] / without[2])
    row("fair mutex", "p99 of a lookup beside two writers [us]", without[0], with_it[0])


def round_trips(build: Build, name: str) -> None:
    """Measure by the wall clock a round trip between two processes, one message in flight."""
    forms = build.without(name).module, build.module
    medians_us: tuple[list[float], list[float]] = ([], [])
    for turn in range(6):
        for index in (0, 1) if turn % 2 else (1, 0):
            command = [
                sys.executable,
                "-m",
                "benchmarks.native.trips",
                str(forms[index]),
                "2000",
                str(DOMAIN_ID),
            ]
            trips = subprocess.run(
                command, capture_output=True, text=True, check=True, cwd=HERE.parent.parent
            )
            medians_us[index].append(median(json.loads(trips.stdout)))
    row(name, "a message there and back, p50 [us]", median(medians_us[0]), median(medians_us[1]))


def main() -> None:
    names = [*EDITS, "frozen file"]
    requested = sys.argv[1:] or names
    if unknown := [name for name in requested if name not in names]:
        raise SystemExit(f"no optimisation is named {', '.join(unknown)}; there are: {', '.join(names)}")
    build = Build()
    print(f"{'':22} {'':48} {'without':>12} {'with':>12} {'ratio':>7}", flush=True)
    for name in dict.fromkeys(name for name, _ in ROWS if name in requested):
        compare(build.module, build, name, [case for row_name, case in ROWS if row_name == name])
    if "fair mutex" in requested:
        beside_writers(build)
    for name in ("busy wait", "short slice"):
        if name in requested:
            round_trips(build, name)
    if "frozen file" in requested:
        for what, (without, with_it) in frozen.measure().items():
            row("frozen file", f"99 frames of 10,000 samples, {what}", without, with_it)


if __name__ == "__main__":
    main()
