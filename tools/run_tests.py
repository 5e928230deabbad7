"""Run a tier of the tests: `python tools/run_tests.py [--slow | --ros] [PYTEST'S ARGUMENTS]`.

A tier runs in two parts: first the few tests that measure time (marked `timing`), in three processes, because they
hardly compute; then the others, in several processes for each core, because they wait more than they compute.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TIMING_WORKERS = 3
WORKERS_PER_CORE = 3
SLOW_WORKERS_PER_CORE = 2
"""Fewer, because slow tests compile and check types with several processes each."""
MAX_WORKERS = 16
"""Limited because all workers use DDS domains from the same 70."""
TESTS = ROOT / "tests"
FEW_FILES = 30
"""So few files that are not compiled cost less than another start of pytest."""
ROS_TESTS = (TESTS / "ros_peer", TESTS / "drop_in")
NOTHING_SELECTED = 5
"""pytest's exit code when it ran no test."""


def workers(*, slow: bool) -> int:
    """Return the number of processes that run tests in parallel."""
    per_core = SLOW_WORKERS_PER_CORE if slow else WORKERS_PER_CORE
    return min(MAX_WORKERS, per_core * (os.cpu_count() or 1))


def timing_files(paths: list[Path]) -> list[str]:
    """Return the files of these with tests that measure time, because collecting all takes longer than these tests."""
    files = [
        file for path in paths for file in ([path] if path.is_file() else sorted(path.rglob("test_*.py")))
    ]
    return [str(path) for path in files if "mark.timing" in path.read_text("utf-8")]


def tier_of(*, slow: bool, ros: bool) -> str:
    """Return the mark expression of a tier."""
    if ros:
        return "ros and not slow"
    return "slow" if slow else "not slow and not ros"


def compile_tests() -> None:
    """Have pytest compile each test file of a new clone once, because each worker would compile all of them."""
    compiled = f"{sys.implementation.cache_tag}-pytest-*.pyc"
    files = [
        str(path)
        for path in sorted(TESTS.rglob("test_*.py"))
        if not any((path.parent / "__pycache__").glob(f"{path.stem}.{compiled}"))
    ]
    if len(files) < FEW_FILES:
        return
    cores = os.cpu_count() or 1
    command = [sys.executable, "-m", "pytest", "--collect-only", "-qq"]
    processes = [
        subprocess.Popen([*command, *share], cwd=ROOT, env=environment(), stdout=subprocess.DEVNULL)
        for share in (files[start::cores] for start in range(cores))
        if share
    ]
    for process in processes:
        process.wait()  # what can't be collected is said when the tests run


def environment() -> dict[str, str]:
    """Return the environment of the tests: they start a thousand processes, which must not compile all they import."""
    return {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}


def run(marks: str, arguments: list[str]) -> tuple[int, float]:
    """Run pytest on the tests that a mark expression selects; return its exit code and the time it took [s]."""
    started = time.monotonic()
    command = [sys.executable, "-m", "pytest", "-m", marks, *arguments]
    code = subprocess.run(command, cwd=ROOT, env=environment(), check=False).returncode
    return code, time.monotonic() - started


def main() -> int:
    """Run both parts of a tier; return 0 if at least one test ran and none failed."""
    parser = argparse.ArgumentParser(description="Run a tier of the tests.", allow_abbrev=False)
    parser.add_argument(
        "--slow", action="store_true", help="the tests that are slow by nature, instead of the others"
    )
    parser.add_argument("-m", dest="marks", help="of the tier, those with these marks (pytest's expression)")
    parser.add_argument(
        "--ros", action="store_true", help="the tests beside the real rclpy, instead of the others"
    )
    options, rest = parser.parse_known_args()
    tier = tier_of(slow=options.slow, ros=options.ros)
    if options.ros and not any(folder.name in argument for folder in ROS_TESTS for argument in rest):
        rest.extend(map(str, ROS_TESTS))  # named, so that the process that reports loads their conftest, too
    marks = f"{tier} and ({options.marks})" if options.marks else tier
    by_file = ["--dist=loadfile", "--no-loadscope-reorder"]
    many = workers(slow=options.slow)
    few = [f"--numprocesses={min(TIMING_WORKERS, many)}", *by_file]
    named = [path for argument in rest if (path := Path(argument.partition("::")[0])).exists()]
    if not named:
        compile_tests()
    parts = {}
    # Tests that measure time run first and in few processes: beside the others they would measure these, too.
    if files := timing_files(named or [TESTS]):
        arguments = [*few, *rest] if named else [*few, *rest, *files]
        parts["measuring time"] = run(f"{marks} and timing", arguments)
    parts["others"] = run(f"{marks} and not timing", [f"--numprocesses={many}", *by_file, *rest])
    times = ", ".join(f"{name} {seconds:.0f} s" for name, (_, seconds) in parts.items())
    print(f"Tests that are {tier}: {times}")
    # A part in which a selection matches nothing is no failure, unless it is so in both.
    codes = [code for code, _ in parts.values() if code != NOTHING_SELECTED]
    return max(codes) if codes else NOTHING_SELECTED


if __name__ == "__main__":
    sys.exit(main())
