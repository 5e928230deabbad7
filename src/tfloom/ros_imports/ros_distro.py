"""What contradicts between ROS 2's distributions, and which of them tfloom follows: `docs/distributions.md`.

tfloom has the names of Jazzy, Kilted and Lyrical together. ROS_DISTRO decides only where two distributions contradict
each other; it is read once, when this module is imported. Nothing but the environment is read, because `import rclpy`
imports this module.
"""

from __future__ import annotations

import os

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeVar

    T = TypeVar("T")

__all__ = [
    "DISTRIBUTIONS",
    "REMOVED",
    "ROS_DISTRO",
    "ROS_ENVIRONMENT",
    "nearest",
    "removal",
    "set_ros_environment",
    "since",
    "warn_if_removed",
]

DISTRIBUTIONS = ("jazzy", "kilted", "lyrical")
"""Those that tfloom follows, from the oldest."""
_OF_ROS_1 = {"kinetic", "lunar", "melodic", "noetic"}
"""Their first letters are those of newer distributions of ROS 2."""


def nearest(given: str) -> str:
    """Return the distribution that is followed for a value of ROS_DISTRO; it needs not be the name of one.

    The names of distributions are in alphabetical order, but for `rolling`, which is the newest. So an older one gives
    the oldest here, a newer one the newest, and a misspelled one the name that it resembles.
    """
    name = given.strip().lower()
    if not name or name in DISTRIBUTIONS:
        return name or DISTRIBUTIONS[0]
    if name in _OF_ROS_1 or not (name.isascii() and name.isalpha()):
        return DISTRIBUTIONS[0]
    from difflib import get_close_matches

    if similar := get_close_matches(name, DISTRIBUTIONS, 1):
        return similar[0]
    return next((known for known in reversed(DISTRIBUTIONS) if known[0] <= name[0]), DISTRIBUTIONS[0])


ROS_DISTRO = nearest(os.environ.get("ROS_DISTRO", ""))
"""The distribution that tfloom follows in this process."""


ROS_ENVIRONMENT = {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3", "ROS_DISTRO": ROS_DISTRO}
"""The variables that a sourced ROS sets: programs and conditions in package.xml ask for them."""


def set_ros_environment() -> None:
    """Set ROS_ENVIRONMENT for this process and those that it starts, each variable unless it has a value.

    This is done where a ROS would be sourced: in the scripts that `colcon build` writes, for what `ros2 run` and
    `ros2 launch` start, and in a program that imports tfloom's `rclpy`.
    """
    for name, value in ROS_ENVIRONMENT.items():
        os.environ.setdefault(name, value)


def since(distribution: str) -> bool:
    """Return whether the distribution that is followed is this one or a newer one."""
    return DISTRIBUTIONS.index(distribution) <= DISTRIBUTIONS.index(ROS_DISTRO)


def _choice(jazzy: T, kilted: T, lyrical: T) -> T:
    return (jazzy, kilted, lyrical)[DISTRIBUTIONS.index(ROS_DISTRO)]


# The table. Each row is one of docs/distributions.md, by the same name.

CALL_RAISES_AT_TIMEOUT = _choice(jazzy=False, kilted=True, lyrical=True)
"""Whether `Client.call` raises TimeoutError when its timeout is over; otherwise it returns None."""
RESULT_TIMEOUT_S = _choice(jazzy=900, kilted=10, lyrical=10)
"""How long an ActionServer keeps the result of an ended goal, where the program gives no time [s]."""
NEEDS_MORE_THAN_A_NAME = _choice(jazzy=False, kilted=False, lyrical=True)
"""Whether `declare_parameter(name)` alone raises TypeError; otherwise it warns."""
CONTEXT_ASKS_FOR_INIT = _choice(jazzy=False, kilted=True, lyrical=True)
"""Whether a Context that is entered by `with` before its `init` warns that this is deprecated."""
FEEDBACK_NEEDS_EXECUTING = _choice(jazzy=False, kilted=False, lyrical=True)
"""Whether feedback of a goal that isn't executing is ignored, with a warning; otherwise it is published."""
LOGGER_WARN_IS_DEPRECATED = _choice(jazzy=False, kilted=True, lyrical=True)
"""Whether `logger.warn` warns that it is `logger.warning`."""
FOURTH_OF_APPROXIMATE = _choice(jazzy="allow_headerless", kilted="queue_offset", lyrical="queue_offset")
"""What ApproximateTimeSynchronizer takes by position after `slop`."""
HAS_LATER_DEFINITIONS = _choice(jazzy=False, kilted=False, lyrical=True)
"""Whether TransitionEvent, Record, Resume, SplitBagfile and Stop have Lyrical's fields."""
TURTLESIM_PACKAGE = _choice(jazzy="turtlesim", kilted="turtlesim_msgs", lyrical="turtlesim_msgs")
"""The package in the names of turtlesim's types."""
BAG_FILES_HAVE_TIMES = _choice(jazzy=False, kilted=False, lyrical=True)
"""Whether a bag's files are `0_bag_2026_05_23-10_00_00.mcap`; otherwise `bag_0.mcap`."""
ALL_RECORDS_ACTIONS = _choice(jazzy=False, kilted=True, lyrical=True)
"""Whether `ros2 bag record --all` records actions, too: their feedback and status are hidden topics."""
LOSSES_HZ = _choice(jazzy=0.0, kilted=0.0, lyrical=1.0)
"""How often a recorder says at most which messages were lost, unless a rate is given [Hz]; 0: it has no such topic."""
PLAY_SHOWS_PROGRESS = _choice(jazzy=False, kilted=True, lyrical=True)
"""Whether `ros2 bag play` shows its progress on a terminal, unless `--progress-bar-update-rate` is given."""
NAMES_ARE_OPTIONAL = _choice(jazzy=False, kilted=False, lyrical=True)
"""Whether a verb that lacks a name says that there is no terminal to pick it on; otherwise it prints its usage."""
READS_FLOAT_TAG = _choice(jazzy=False, kilted=False, lyrical=True)
"""Whether `!!float 10` in a file of parameters is a double, and an unknown tag an error; otherwise tags are ignored."""

REMOVED = {
    "rclpy.qos_event": ("lyrical", "rclpy.event_handler"),
    "rclpy.clock.ROSClock": ("lyrical", "Clock(clock_type=ClockType.ROS_TIME)"),
    "rclpy.action.get_action_names_and_types and its like": ("lyrical", "the methods of Node of these names"),
    "rclpy.topic_endpoint_info": ("lyrical", "rclpy.endpoint_info"),
    "message_filters.Cache.getLastestTime": ("kilted", "getLatestTime"),
    "the URDF argument of robot_state_publisher": ("lyrical", "the parameter robot_description"),
    "topics of `ros2 bag record` without an option": ("lyrical", "--topics"),
}
"""What newer distributions deprecate or lack, by the first one that does, and its successor. It stays here."""


def removal(name: str) -> str:
    """Return what to say of a name of REMOVED; empty if the distribution that is followed has it like the first."""
    first, successor = REMOVED[name]
    return f"{name} is deprecated from {first} on: use {successor}" if since(first) else ""


def warn_if_removed(name: str, *, stacklevel: int = 2) -> None:
    """Warn of a name of REMOVED, which the distribution that is followed deprecates or lacks.

    Args:
        name: The name.
        stacklevel: As `warnings.warn` takes it, as if this function's caller called that.
    """
    if text := removal(name):
        import warnings

        warnings.warn(text, DeprecationWarning, stacklevel=stacklevel + 1)
