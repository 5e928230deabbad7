"""The distributions beside tfloom that have ROS's packages: where they are installed, and how to install them.

For other distributions, a first look for what they add by entry points, which most do not.
"""

from __future__ import annotations

import sys
from functools import cache
from importlib.machinery import PathFinder
from pathlib import Path
from typing import NamedTuple

__all__ = [
    "INTERFACES",
    "SENSING",
    "Distribution",
    "distribution_with",
    "find_prefix",
    "installed_prefixes",
    "may_have_entry_points",
]


class Distribution(NamedTuple):
    """A distribution in the folder `packages/` of tfloom's sources."""

    name: str
    import_package: str
    """The package that it installs: its folder `ros_names` has the ROS packages."""
    ros_packages: tuple[str, ...]

    @property
    def how_to_install(self) -> str:
        """The command that installs it: by its path, because it is on no index."""
        return f"pip install ./packages/{self.name}, in tfloom's sources"


INTERFACES = Distribution(
    "tfloom-interfaces",
    "tfloom_interfaces",
    (
        "ackermann_msgs",
        "action_tutorials_interfaces",
        "control_msgs",
        "controller_manager_msgs",
        "geographic_msgs",
        "map_msgs",
        "moveit_msgs",
        "nav2_msgs",
        "nmea_msgs",
        "object_recognition_msgs",
        "octomap_msgs",
        "vision_msgs",
    ),
)
SENSING = Distribution(
    "tfloom-sensing",
    "tfloom_sensing",
    ("cv_bridge", "diagnostic_updater", "image_geometry", "interactive_markers"),
)


def distribution_with(ros_package: str) -> Distribution | None:
    """Return the distribution that has a ROS package, installed or not; None if there is none."""
    for distribution in (INTERFACES, SENSING):
        if ros_package in distribution.ros_packages:
            return distribution
    return None


@cache
def find_prefix(distribution: Distribution) -> Path | None:
    """Return the folder of a distribution's import package, or None where it isn't installed."""
    spec = PathFinder.find_spec(distribution.import_package)
    return None if spec is None or spec.origin is None else Path(spec.origin).parent


def installed_prefixes() -> list[Path]:
    """Return the folders of the import packages that are installed."""
    return [prefix for prefix in map(find_prefix, (INTERFACES, SENSING)) if prefix is not None]


def may_have_entry_points(group_name: str) -> bool:
    """Return whether the text of a group's name is in the entry points of any installed package.

    It reads the files alone, because `importlib.metadata` takes longer to import, and parses all of them.
    """
    section = f"[{group_name}]".encode()
    for folder in sys.path:
        for pattern in ("*.dist-info/entry_points.txt", "*.egg-info/entry_points.txt"):
            for path in Path(folder).glob(pattern):
                try:
                    if section in path.read_bytes():
                        return True
                except OSError:
                    continue
    return False
