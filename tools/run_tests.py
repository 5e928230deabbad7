"""Run a tier of the tests: `python tools/run_tests.py [--slow | --ros] [PYTEST'S ARGUMENTS]`.

A tier runs in two parts: first the few tests that measure time, or draw pages in a browser (marked `timing`), in three
processes; then the others, in several processes for each core, because they wait more than they compute.

Before them, what is generated is brought up to date (tools/generated.py).

A test that hangs ends the run, after the places of all its threads were printed: the limit of time is an option of
pytest. Processes that tests leave behind are named and ended, and fail the run.
"""

from __future__ import annotations

import argparse
import ctypes
import os
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TIMING_WORKERS = 3
WORKERS_PER_CORE = 5
ROS_WORKERS_PER_CORE = 3
"""Fewer, because the real rclpy takes several times the CPU time of tfloom: with more, a peer times out."""
SLOW_WORKERS_PER_CORE = 2
"""Fewer, because slow tests compile and check types with several processes each."""
MAX_WORKERS = 16
"""Limited because all workers use DDS domains from the same 70."""
TESTS = ROOT / "tests"
FEW_FILES = 30
"""So few files that are not compiled cost less than another start of pytest."""
ROS_TESTS = (TESTS / "ros_peer", TESTS / "drop_in", TESTS / "rmw" / "test_zenoh_witness.py")
MAX_SLOW_TEST_S = 2400
"""The longest time of a slow test [s]; pyproject.toml has that of the others."""
PR_SET_CHILD_SUBREAPER = 36
MAX_END_S = 10.0
"""The longest time that processes may take to end after the tests that started them [s]."""
NOTHING_SELECTED = 5
"""pytest's exit code when it ran no test."""


def number_of_workers(*, slow: bool, ros: bool) -> int:
    """Return the number of processes that run tests in parallel."""
    per_core = SLOW_WORKERS_PER_CORE if slow else ROS_WORKERS_PER_CORE if ros else WORKERS_PER_CORE
    return min(MAX_WORKERS, per_core * (os.cpu_count() or 1))


def files_marked(mark: str, paths: list[Path]) -> list[str]:
    """Return the files of these with tests of a mark, because collecting all takes each worker seconds.

    tests/conftest.py refuses a mark that its file doesn't name.
    """
    files = [
        file for path in paths for file in ([path] if path.is_file() else sorted(path.rglob("test_*.py")))
    ]
    return [str(path) for path in files if f"mark.{mark}" in path.read_text("utf-8")]


def tier_of(*, slow: bool, ros: bool) -> str:
    """Return the mark expression of a tier."""
    if ros:
        return "ros and not slow"
    return "slow" if slow else "not slow and not ros"


def generate() -> bool:
    """Bring the generated files of the checkout up to date; return whether they are."""
    return subprocess.run([sys.executable, ROOT / "tools" / "generated.py"], check=False).returncode == 0


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
    """Return the environment of the tests.

    They start a thousand processes, which must not compile all they import. What pip installs in a test is run once or
    twice, and compiled then as far as it is imported: half of the time of an installation is compiling all.
    """
    variables = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    return variables | {"PIP_NO_COMPILE": "0"}  # pip takes the value as that of `compile`


def adopt_orphans() -> None:
    """Become the parent of processes whose parents end, so that `end_orphans` finds them; on Linux."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)


def end_orphans() -> list[str]:
    """Wait for the processes that tests have left, end those that stay, and return their commands; on Linux."""
    if sys.platform != "linux":
        return []
    import psutil  # after set-up

    end_s = time.monotonic() + MAX_END_S
    while (left := psutil.Process().children(recursive=True)) and time.monotonic() < end_s:
        psutil.wait_procs(left, timeout=0.1)
    commands = []
    for process in left:
        with suppress(psutil.Error):  # it has just ended
            commands.append(" ".join(process.cmdline()) or process.name())
            process.kill()
    psutil.wait_procs(left, timeout=MAX_END_S)
    return commands


def run(marks: str, arguments: list[str]) -> tuple[int, float]:
    """Run pytest on the tests that a mark expression selects; return its exit code and the time it took [s]."""
    started = time.monotonic()
    command = [sys.executable, "-m", "pytest", "-m", marks, *arguments]
    with subprocess.Popen(command, cwd=ROOT, env=environment()) as process:
        try:
            reap_until_end(process)
        except BaseException:
            process.kill()
            raise
    return process.returncode, time.monotonic() - started


def reap_until_end(process: subprocess.Popen[bytes]) -> None:
    """Wait for the end of a child, and meanwhile for the orphans, on Linux.

    Or they would stay zombies, which a test takes for processes that have not ended: elsewhere, init waits for them.
    """
    while sys.platform == "linux" and process.returncode is None:
        number, status = os.wait()
        if number == process.pid:
            process.returncode = os.waitstatus_to_exitcode(status)
    process.wait()


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
    parser.add_argument(
        "--no-timing",
        action="store_true",
        help="without those that measure time, which say the same of each Python",
    )
    options, rest = parser.parse_known_args()
    tier = tier_of(slow=options.slow, ros=options.ros)
    if options.ros and not any(folder.name in argument for folder in ROS_TESTS for argument in rest):
        rest.extend(map(str, ROS_TESTS))  # named, so that the process that reports loads their conftest, too
    marks = f"{tier} and ({options.marks})" if options.marks else tier
    # Another worker would repeat the test that hangs.
    by_file = ["--dist=loadfile", "--no-loadscope-reorder", "--max-worker-restart=0"]
    if options.slow:
        by_file.append(f"--override-ini=faulthandler_timeout={MAX_SLOW_TEST_S}")
    if not generate():
        return 1
    adopt_orphans()
    many = number_of_workers(slow=options.slow, ros=options.ros)
    few = [f"--numprocesses={min(TIMING_WORKERS, many)}", *by_file]
    named = [path for argument in rest if (path := Path(argument.partition("::")[0])).exists()]
    if not named:
        compile_tests()
    parts = {}
    # Tests that measure time run first and in few processes: beside the others they would measure these, too.
    if not options.no_timing and (files := files_marked("timing", named or [TESTS])):
        arguments = [*few, *rest] if named else [*few, *rest, *files]
        parts["measuring time"] = run(f"{marks} and timing", arguments)
    slow = files_marked("slow", [TESTS]) if options.slow and not named else []
    parts["others"] = run(f"{marks} and not timing", [f"--numprocesses={many}", *by_file, *rest, *slow])
    times = ", ".join(f"{name} {seconds:.0f} s" for name, (_, seconds) in parts.items())
    print(f"Tests that are {tier}: {times}")
    # A part in which a selection matches nothing is not a failure, unless it matches nothing in both.
    codes = [code for code, _ in parts.values() if code != NOTHING_SELECTED]
    if left := end_orphans():
        print("Tests left these processes, which were ended:", *left, sep="\n  ")
        return max(1, *codes)
    return max(codes) if codes else NOTHING_SELECTED


if __name__ == "__main__":
    sys.exit(main())
