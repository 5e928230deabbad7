"""Launches with tests, for nodes."""

from __future__ import annotations

from tfloom.launch.testing import test_runner

__all__ = ["LaunchTestRunner"]


class LaunchTestRunner(test_runner.LaunchTestRunner):
    """Runs launches one after another, each with its tests; nodes need nothing more."""
