"""The command line of talker_qos and listener_qos."""

from __future__ import annotations

import argparse
import sys

from tfloom.node.context.utilities import remove_ros_args
from tfloom.node.qos.qos import QoSProfile, ReliabilityPolicy, qos_profile_sensor_data

__all__ = ["parse_qos_arguments"]

CYCLES = 20


def parse_qos_arguments(
    program: str, description: str, what: str, args: list[str] | None
) -> tuple[QoSProfile, int]:
    """Read a command line; exit with a usage text if it is invalid.

    Args:
        program: The program's name.
        description: What it does.
        what: Name of the counted items, in the plural.
        args: Its command line, ROS arguments included; None: `sys.argv`.

    Returns:
        The quality of service, reliable or best effort, and the number to end after.
    """
    parser = argparse.ArgumentParser(prog=program, description=description)
    parser.add_argument("--reliable", action="store_true", help="be reliable (default: best effort)")
    parser.add_argument(
        *("-n", "--number_of_cycles"),
        type=int,
        default=CYCLES,
        metavar="N",
        help=f"end after this number of {what} (default: {CYCLES})",
    )
    options = parser.parse_args(remove_ros_args(sys.argv[1:] if args is None else args))
    reliable = QoSProfile(depth=10, reliability=ReliabilityPolicy.RELIABLE)
    return reliable if options.reliable else qos_profile_sensor_data, options.number_of_cycles
