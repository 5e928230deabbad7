"""Launch tests under pytest, for nodes: those whose description has the marker `rostest`. PYTEST_DONT_REWRITE."""

from __future__ import annotations

from tfloom.launch.testing.hooks import LaunchTestItem, LaunchTestModule
from tfloom.launch.testing.ros.test_runner import LaunchTestRunner

__all__ = ["LaunchROSTestItem", "LaunchROSTestModule"]


class LaunchROSTestItem(LaunchTestItem):
    """All launches of a file, and their tests, as one item of pytest."""

    runner_class = LaunchTestRunner


class LaunchROSTestModule(LaunchTestModule):
    """A file with `generate_test_description`."""

    item_class = LaunchROSTestItem
