"""Modules that tfloom has nothing of, as ROS 1's: their import ends with an error that names what to do instead.

`tfloom.pth` adds a finder to the end of `sys.meta_path` that imports this module when a program imports one of them
and nobody has it; `tfloom.use_ros_names()` does the same. Modules of these names in any folder of `sys.path` take
precedence. A program that only asks whether there is such a module, by `importlib.util.find_spec`, is told that there
is none. Of ROS 2 the same is said of modules that tfloom's own packages lack: those of verbs, and of the generator.
"""

from __future__ import annotations

import os
import sys
from importlib.machinery import ModuleSpec

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from importlib.abc import Loader
    from types import FrameType, ModuleType
    from typing import NoReturn
else:
    Loader = object  # importlib.abc takes longer to import than all the rest here

__all__ = ["INSTEAD", "install", "spec_of"]

INSTEAD = {
    "rospy": "it is ROS 1's. In ROS 2, write `import rclpy`, and a node as a class that derives from `rclpy.node.Node`",
    "tf": "it is ROS 1's. In ROS 2, write `import tf2_ros`, and `import tf_transformations` for `tf.transformations`",
    "roslib": "it is ROS 1's, and ROS 2 needs nothing in its place: delete the lines with `roslib`",
    "rosbag": "it is ROS 1's. `from tfloom.bag import frames` reads the transforms of its recordings, and "
    "`import rosbag2_py` the recordings of ROS 2",
    "actionlib": "it is ROS 1's. In ROS 2, write `from rclpy.action import ActionClient, ActionServer`",
    "urdf_parser_py": "PyPI has it: pip install urdf-parser-py",
    "image_transport_py": "it is compiled from C++, and tfloom has none of it. Subscribe to the topic of "
    "`sensor_msgs/msg/Image` or `CompressedImage` itself, with `cv_bridge` of tfloom-sensing",
}
"""The names, which the finder in CMakeLists.txt has, too, and the rest of the error's text."""
_ROS_NAMES = f"{os.sep}tfloom{os.sep}ros_names{os.sep}"
"""Part of the path of each package of ROS that tfloom has."""


def spec_of(name: str, path: Sequence[str] | None = None) -> ModuleSpec | None:
    """Return the spec of such a module, whose import raises the error.

    None for any other name, and where the name is only looked for: a spec would tell `importlib.util.find_spec` that
    the module is there.

    Args:
        name: The module's full name.
        path: The folders of its package; None for a package.
    """
    if name in INSTEAD:
        error: ImportError = ModuleNotFoundError(f"No module named {name!r}: {INSTEAD[name]}", name=name)
    elif path and _ROS_NAMES in next(iter(path), "") and (reason := _reason(name)):
        # No ModuleNotFoundError, which Python drops where `from package import module` finds no module.
        error = ImportError(f"No module named {name!r}: {reason}", name=name)
    else:
        return None
    return ModuleSpec(name, _Refusal(error)) if _is_import() else None


def _reason(name: str) -> str:
    """Return why a package of tfloom's has no such module, and what to do instead; empty for any other package."""
    package, *inner = name.split(".")
    if package == "rosidl_generator_py":
        return (
            "tfloom generates no code for interface packages. Import their classes (`from my_interfaces.msg import X`)"
            ", or write typed modules for editors with `tfloom interfaces stubs DIR`"
        )
    if package.startswith("ros2") and len(inner) == 2 and inner[0] == "verb":
        command = package.removeprefix("ros2")
        return (
            f"tfloom has most verbs as functions of the command, and no classes of them. Call the functions of "
            f"`{package}.api`, or `ros2cli.cli.main(argv=[{command!r}, {inner[1]!r}])`"
        )
    return ""


def install() -> None:
    """Add the finder to the end of `sys.meta_path`, unless one is there, as `tfloom.pth` has done."""
    if not any(getattr(finder, "finds_absent", False) for finder in sys.meta_path):
        sys.meta_path.append(_Finder())


def _is_import() -> bool:
    """Return whether an import statement or `importlib.import_module` asks the finders, rather than a search.

    Both call the same function of `importlib` with the same arguments, so only its caller tells them apart. Where a
    Python names these functions otherwise, the import fails with Python's own text.
    """
    frame: FrameType | None = sys._getframe()  # inspect takes long to import
    while frame is not None and not _is_of_import_system(frame, "_find_spec"):
        frame = frame.f_back
    caller = frame and frame.f_back
    return caller is not None and _is_of_import_system(caller, "_find_and_load_unlocked")


def _is_of_import_system(frame: FrameType, function: str) -> bool:
    code = frame.f_code
    return code.co_name == function and code.co_filename == "<frozen importlib._bootstrap>"


class _Finder:
    finds_absent = True

    def find_spec(
        self, fullname: str, path: Sequence[str] | None = None, _target: ModuleType | None = None
    ) -> ModuleSpec | None:
        return spec_of(fullname, path)


class _Refusal(Loader):
    def __init__(self, error: ImportError) -> None:
        self._error = error

    def create_module(self, _spec: ModuleSpec) -> NoReturn:
        raise self._error

    def exec_module(self, module: ModuleType) -> None:
        """Do nothing; Python asks for this method."""
