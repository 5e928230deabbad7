"""ROS 1's `rospy` and `tf`: their import ends with a ModuleNotFoundError that names what ROS 2 has in their place.

`tfloom.pth` adds a finder to the end of `sys.meta_path` that imports this module when a program imports one of the two
and nobody has it; `tfloom.use_ros_names()` does the same. Names of ROS 1 in any folder of `sys.path` take precedence.
"""

from __future__ import annotations

import sys
from importlib.machinery import ModuleSpec

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from importlib.abc import Loader
    from types import ModuleType
    from typing import NoReturn
else:
    Loader = object  # importlib.abc takes longer to import than all the rest here

__all__ = ["INSTEAD", "install", "spec_of"]

INSTEAD = {
    "rospy": "write `import rclpy`, and a node as a class that derives from `rclpy.node.Node`",
    "tf": "write `import tf2_ros`, and `import tf_transformations` for `tf.transformations`",
}
"""The names, and what a program writes instead."""


def spec_of(name: str) -> ModuleSpec | None:
    """Return the spec of a name of ROS 1, whose import raises the error; None for any other name."""
    return ModuleSpec(name, _Refusal()) if name in INSTEAD else None


def install() -> None:
    """Add the finder to the end of `sys.meta_path`, unless one is there, as `tfloom.pth` has done."""
    if not any(getattr(finder, "finds_ros1", False) for finder in sys.meta_path):
        sys.meta_path.append(_Finder())


class _Finder:
    finds_ros1 = True

    def find_spec(
        self, fullname: str, _path: Sequence[str] | None = None, _target: ModuleType | None = None
    ) -> ModuleSpec | None:
        return spec_of(fullname)


class _Refusal(Loader):
    def create_module(self, spec: ModuleSpec) -> NoReturn:
        raise ModuleNotFoundError(
            f"No module named {spec.name!r}: it is ROS 1's. In ROS 2, {INSTEAD[spec.name]}", name=spec.name
        )

    def exec_module(self, module: ModuleType) -> None:
        """Do nothing; Python asks for this method."""
