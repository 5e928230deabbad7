"""Packages that ROS 2 has and that an extra of tfloom installs."""

from __future__ import annotations

import sys

import pytest


def test_extra_launch_has_osrf_pycommon() -> None:
    process_utils = pytest.importorskip(
        "osrf_pycommon.process_utils", reason="osrf_pycommon is not installed: pip install 'tfloom[launch]'"
    )
    terminal_color = pytest.importorskip("osrf_pycommon.terminal_color")
    assert process_utils.which(sys.executable) == sys.executable
    assert terminal_color.remove_ansi_escape_sequences("\x1b[31mred\x1b[0m") == "red"
    assert process_utils.which("no_such_program_at_all") is None
