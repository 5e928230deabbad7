"""The finder of interface packages that no Python package holds: `from my_interfaces.msg import X`, with no build.

It stands last in `sys.meta_path`, so that it is asked only for what no other finder has found. It serves packages on
AMENT_PREFIX_PATH that hold definitions (`share/my_interfaces/msg/X.msg`), as modules whose classes are made when
they are named. `tfloom.pth` installs it where AMENT_PREFIX_PATH is set when Python starts; `tfloom.use_ros_names()`
does so by hand.

This module is loaded at the start of each Python in a sourced workspace, so it imports almost nothing.
"""

from __future__ import annotations

import os
import sys
from importlib.machinery import ModuleSpec

from tfloom.ros_guard import serves_rclpy

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import ModuleType

__all__ = ["InterfaceFinder", "install"]

_KINDS = ("msg", "srv", "action")


def install() -> None:
    """Add the finder to the end of `sys.meta_path`, unless it is there."""
    if InterfaceFinder not in sys.meta_path:
        sys.meta_path.append(InterfaceFinder)


class InterfaceFinder:
    """Finds `my_interfaces` and `my_interfaces.msg`, and is their loader."""

    @classmethod
    def find_spec(
        cls, fullname: str, _path: Sequence[str] | None = None, _target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return the spec of a package with definitions, or of its messages, services or actions, or None.

        None where `rclpy` is another ROS's, too: its nodes don't take tfloom's messages.
        """
        package, _, kind = fullname.partition(".")
        folder = _package_folder(package, kind) if kind in ("", *_KINDS) else None
        if folder is None or not serves_rclpy():
            return None
        # With no origin that is a file: tools that show a module's source would look for Python there.
        return ModuleSpec(fullname, cls, origin=folder, is_package=not kind)  # type: ignore[arg-type]  # a class may be a loader

    @staticmethod
    def create_module(spec: ModuleSpec) -> ModuleType | None:
        """Leave it to Python to make the module."""

    @staticmethod
    def exec_module(module: ModuleType) -> None:
        """Let the module's attributes be found when they are named."""
        from tfloom.rosidl.definition_modules import fill_module

        fill_module(module)


def _package_folder(package: str, kind: str) -> str | None:
    """Return the first folder `share/package` on AMENT_PREFIX_PATH that holds definitions of a kind, or of any."""
    if not package.isidentifier():
        return None
    for prefix in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
        folder = os.path.join(prefix, "share", package)  # noqa: PTH118  # pathlib takes longer to import than all the rest
        if prefix and any(_holds_definitions(folder, each) for each in _KINDS if kind in ("", each)):
            return folder
    return None


def _holds_definitions(folder: str, kind: str) -> bool:
    try:
        names = os.listdir(os.path.join(folder, kind))  # noqa: PTH118, PTH208  # as above
    except OSError:
        return False
    return any(name.endswith(f".{kind}") for name in names)
