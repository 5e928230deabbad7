"""The finder of interface packages without Python modules: `from my_interfaces.msg import X`, without a build.

It is last in `sys.meta_path`, because any module of the same name takes precedence. It finds packages on
AMENT_PREFIX_PATH that hold definitions (`share/my_interfaces/msg/X.msg`); the classes of their modules are created at
first access. `tfloom.pth` installs it if AMENT_PREFIX_PATH is set when Python starts; `tfloom.use_ros_names()` does the
same. Beside another `rclpy` it finds nothing. Type checkers don't run it: for them `tfloom interfaces stubs` writes the
same packages as typed modules.

This module imports almost nothing, because each Python process in a sourced workspace loads it when it starts.
"""

from __future__ import annotations

import os
import sys
from importlib.machinery import ModuleSpec

from tfloom.ros_imports.guard import serves_rclpy

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from importlib.abc import Loader
    from types import ModuleType
else:
    Loader = object  # importlib.abc takes longer to import than all the rest here

__all__ = ["InterfaceFinder", "install"]

_KINDS = ("msg", "srv", "action")


def install() -> None:
    """Add the finder to the end of `sys.meta_path`, unless it is there."""
    if not any(isinstance(finder, InterfaceFinder) for finder in sys.meta_path):
        sys.meta_path.append(InterfaceFinder())


class InterfaceFinder(Loader):
    """The finder, and the loader of `my_interfaces` and `my_interfaces.msg`."""

    def find_spec(
        self, fullname: str, _path: Sequence[str] | None = None, _target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return the spec of a package with definitions, or of its messages, services or actions.

        Returns:
            None if the package holds no such definitions, or if `rclpy` is not tfloom's, because the nodes of another
            ROS don't accept tfloom's messages.
        """
        package, _, kind = fullname.partition(".")
        folder = _package_folder(package, kind) if kind in ("", *_KINDS) else None
        if folder is None or not serves_rclpy():
            return None
        return ModuleSpec(fullname, self, origin=folder, is_package=not kind)

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        """Return None, for Python's own kind of module."""

    def exec_module(self, module: ModuleType) -> None:
        """Give the module functions that find its attributes at first access."""
        from tfloom.rosidl.definition_modules import fill_module

        spec = module.__spec__
        fill_module(module, str(spec.origin if spec is not None else None))


def _package_folder(package: str, kind: str) -> str | None:
    """Return the first folder `share/package` on AMENT_PREFIX_PATH that holds definitions of a kind, or of any."""
    if not package.isidentifier():
        return None
    for prefix in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
        folder = os.path.join(prefix, "share", package)  # pathlib takes longer to import than all the rest
        if prefix and any(_holds_definitions(folder, name) for name in _KINDS if kind in ("", name)):
            return folder
    return None


def _holds_definitions(folder: str, kind: str) -> bool:
    try:
        names = os.listdir(os.path.join(folder, kind))  # as above
    except OSError:
        return False
    return any(name.endswith((f".{kind}", ".idl")) for name in names)
