"""A tier of the tests ends, names the test that hangs, and leaves no process."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import psutil
import pytest
from tests.conftest import PYTEST, python_with, refuse_marks_of_other_files, run_to_end
from tools import run_tests

ROOT = Path(__file__).resolve().parents[2]


def run_tier(file: Path, text: str, *options: str) -> subprocess.CompletedProcess[str]:
    """Run a tier of one file, with one worker, where processes that tests leave have a second to end."""
    file.write_text(text)
    options = (*PYTEST[2:], "-q", "-c", str(ROOT / "pyproject.toml"), "--numprocesses=1", *options)
    main = "import sys; from tools import run_tests; sys.exit(run_tests.main())"
    command = python_with({"tools.run_tests.MAX_END_S": 1.0}, main, *options, file)
    return run_to_end([sys.executable, *command], cwd=ROOT)


def test_a_test_that_hangs_is_named_and_ends_the_run(tmp_path: Path) -> None:
    done = run_tier(
        tmp_path / "test_hangs.py",
        "import threading\n\ndef test_hangs():\n    threading.Event().wait()\n\ndef test_passes():\n    pass\n",
        "--override-ini=faulthandler_timeout=1",
    )
    assert done.returncode == 1
    assert "crashed while running '::test_hangs'" in done.stdout
    assert 'test_hangs.py", line 4 in test_hangs' in done.stderr


@pytest.mark.skipif(sys.platform != "linux", reason="processes change their parents so on Linux alone")
def test_processes_that_tests_leave_are_ended_and_fail_the_run(tmp_path: Path) -> None:
    """A process whose parent has ended does not stay as a zombie when it ends."""
    note = tmp_path / "pid"
    done = run_tier(
        tmp_path / "test_leaves.py",
        "import os, pathlib, subprocess\nimport psutil\nfrom tests.conftest import wait_until\n\n"
        "def test_leaves():\n"
        "    pid = os.spawnlp(os.P_NOWAIT, 'sleep', 'sleep', '321')\n"
        f"    pathlib.Path({str(note)!r}).write_text(str(pid))\n\n"
        "def test_orphan():\n"
        "    command = ['sh', '-c', 'sleep 0.1 >/dev/null & echo $!']\n"
        "    pid = int(subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout)\n"
        "    wait_until(lambda: not psutil.pid_exists(pid), timeout_s=10.0)\n",
    )
    assert done.returncode == 1
    assert "2 passed" in done.stdout
    assert "Tests left these processes, which were ended:\n  sleep 321\n" in done.stdout
    assert not psutil.pid_exists(int(note.read_text()))


def test_nothing_selected_is_no_success(tmp_path: Path) -> None:
    assert run_tier(tmp_path / "test_none.py", "", "--numprocesses=0").returncode == 5


def test_all_tests_beside_the_real_rclpy_and_the_witness_are_run() -> None:
    """The tier names its folders and files, so a file elsewhere would never run."""
    marked = [
        path
        for path in run_tests.TESTS.rglob("test_*.py")
        if re.search(r"^ *(@|pytestmark = .*)pytest\.mark\.ros\b", path.read_text("utf-8"), re.MULTILINE)
    ]
    assert len(marked) > 5
    left_out = [
        path for path in marked if not any(path.is_relative_to(named) for named in run_tests.ROS_TESTS)
    ]
    assert not left_out


def test_a_mark_of_another_file_is_refused(tmp_path: Path) -> None:
    """The tiers look for files with the text of a mark."""
    file = tmp_path / "test_a.py"
    file.write_text("from marks import slow\n\n@slow\ndef test_a():\n    pass\n")
    item: Any = SimpleNamespace(path=file, get_closest_marker=lambda mark: mark == "slow")
    with pytest.raises(pytest.UsageError, match=r"test_a\.py: write pytest\.mark\.slow in this file"):
        refuse_marks_of_other_files("slow", [item])
    assert run_tests.files_marked("slow", [tmp_path]) == []
    refuse_marks_of_other_files("timing", [item])
    file.write_text(file.read_text().replace("@slow", "@pytest.mark.slow"))
    refuse_marks_of_other_files("slow", [item])
    assert run_tests.files_marked("slow", [tmp_path]) == [str(file)]
