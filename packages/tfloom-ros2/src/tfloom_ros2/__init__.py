# PYTHON_ARGCOMPLETE_OK
"""The command `ros2`: tfloom's, unless a real ROS is there, whose name it is."""

from __future__ import annotations

import sys
from importlib.util import find_spec

from tfloom.cli.main import main as tfloom_main


def main() -> int:
    """Run the command line; where Python would import a real ros2, name it and stop."""
    real = find_spec("ros2cli")
    if real is not None:
        print(
            f"ros2: this is tfloom's, and it stands before the real one of {real.origin}.\n"
            "Type `tfloom` instead of `ros2` for this one, or leave this environment for the real one.",
            file=sys.stderr,
        )
        return 1
    return tfloom_main(prog="ros2")
