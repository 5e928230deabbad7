# PYTHON_ARGCOMPLETE_OK
"""The commands `ros2` and `launch_test`: tfloom's, unless a real ROS is there, whose names they are."""

from __future__ import annotations

import sys

from tfloom.cli.quiet_imports import QuietImports


def main() -> int:
    """Run the command line; where a real ROS is sourced, name it and stop.

    A real ROS has its own `ros2cli` and its own `rclpy`. A `ros2cli` alone, built in a workspace or installed by pip,
    serves extensions of the command, which run on tfloom's `rclpy`.
    """
    with QuietImports():
        from importlib.util import find_spec

        from tfloom.cli.main import main as tfloom_main
        from tfloom.ros_imports.guard import is_elsewhere
    if is_elsewhere("ros2cli") and is_elsewhere("rclpy"):
        real = find_spec("ros2cli")
        print(
            f"ros2: this is tfloom's, and it stands before the real one of {real and real.origin}.\n"
            "Type `tfloom` instead of `ros2` for this one, or leave this environment for the real one.",
            file=sys.stderr,
        )
        return 1
    return tfloom_main(prog="ros2")


def launch_test() -> int:
    """Run a launch test file; where Python would import a real launch_testing, say so and stop."""
    with QuietImports():
        from tfloom.ros_imports.guard import is_elsewhere
    if is_elsewhere("launch_testing"):
        print(
            "launch_test: this is tfloom's, and it stands before that of a real ROS.\n"
            "Type `python -m launch_testing.launch_test` for the real one.",
            file=sys.stderr,
        )
        return 1
    with QuietImports():
        from tfloom.launch.testing.launch_test import main as launch_test_main
    return launch_test_main()
