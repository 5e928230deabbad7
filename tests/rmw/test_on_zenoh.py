"""The tests of commands, transforms and programs, which use DDS by default, on Zenoh."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from tests.conftest import WIRE_VARIABLE, run_to_end

pytest.importorskip("zenoh", reason="eclipse-zenoh is not installed: pip install 'tfloom[zenoh]'")

ROOT = Path(__file__).parents[2]
FOLDERS = (
    "tests/cli",
    "tests/tf2_ros",
    "tests/tf2_tools",
    "tests/launch",
    "tests/turtlesim",
    "tests/robot",
    "tests/bag",
)
TIMEOUT_S = 1200.0

pytestmark = [pytest.mark.slow, pytest.mark.wire]


def test_what_runs_on_dds_runs_on_zenoh() -> None:
    done = run_to_end(
        [
            *(
                sys.executable,
                "-m",
                "pytest",
                "-q",
                "-p",
                "no:cacheprovider",
                "--numprocesses=4",
                "--dist=loadfile",
            ),
            *("-m", "wire and not slow and not ros and not timing", *FOLDERS),
        ],
        cwd=ROOT,
        env={**os.environ, WIRE_VARIABLE: "rmw_zenoh_cpp"},
        timeout_s=TIMEOUT_S,
    )
    assert done.returncode == 0, done.stdout[-20_000:] + done.stderr
