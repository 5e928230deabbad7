"""The program joint_state_publisher_gui of its package: the page of `tfloom view`, with a slider for each joint."""

from __future__ import annotations

import argparse
import sys

from tfloom.cli import view
from tfloom.common.terminal import report
from tfloom.node.context.utilities import remove_ros_args
from tfloom.viewer.extra import MISSING, is_installed

__all__ = ["run"]

NAME = "joint_state_publisher_gui"


def run(args: list[str] | None = None) -> int:
    """Publish the states of joints, and serve the page on which they are moved, until Ctrl-C; return the exit code.

    ROS arguments are those of the node joint_state_publisher.
    """
    words = sys.argv[1:] if args is None else args
    parser = argparse.ArgumentParser(
        prog=NAME,
        description="Publish the states of a robot's joints, moved by sliders on the page of `tfloom view`.",
    )
    parser.add_argument("urdf_file", nargs="?", help="URDF file to use")
    urdf_file = parser.parse_args(remove_ros_args(words)).urdf_file
    if not is_installed():
        report(f"{NAME}: {MISSING.format(name='the page with sliders')}")
        return 1
    print(f"{NAME}: sliders are on the page of `tfloom view`", flush=True)
    return view.serve_as(NAME, [], view.Publishing(urdf_file, list(words)))
