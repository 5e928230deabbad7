"""What tests of demonstrations share."""

from __future__ import annotations

import shutil
import sys
import uuid
from pathlib import Path

import pytest
from tests.workspace.conftest import BIN, colcon

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture
def mark(monkeypatch: pytest.MonkeyPatch) -> str:
    """An environment variable that marks all processes of the demonstration."""
    if sys.platform != "linux":
        pytest.skip("processes are found in /proc, which Linux has")
    value = str(uuid.uuid4())
    monkeypatch.setenv("TFLOOM_TEST_MARK", value)
    return f"TFLOOM_TEST_MARK={value}"


@pytest.fixture
def built_broadcaster(tmp_path: Path) -> list[str]:
    """Build the example package in a workspace, and return the command that sources it and starts its program."""
    shutil.copytree(EXAMPLES / "turtle_frames", tmp_path / "src" / "turtle_frames")
    built = colcon(tmp_path, "build", "--packages-select", "turtle_frames")
    assert built.code == 0, built.output
    script = tmp_path / "install" / "setup.bash"
    return ["bash", "-c", f"source '{script}' && exec '{BIN / 'ros2'}' run turtle_frames broadcaster"]
