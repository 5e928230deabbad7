"""Modules of a façade that load when they are named, as after `import rclpy` alone in `rclpy.time.Time()`.

The original has them because its modules import one another; these façades import tfloom's rooms instead.
"""

from __future__ import annotations

from importlib import import_module
from types import ModuleType

__all__ = ["rclpy_module"]


def rclpy_module(name: str) -> ModuleType:
    """Return the module `rclpy.<name>`: the `__getattr__` of the façade `rclpy`.

    Raises:
        AttributeError: there is no such module.
    """
    if not name.startswith("_"):
        try:
            return import_module(f"rclpy.{name}")
        except ModuleNotFoundError as error:
            if error.name != f"rclpy.{name}":
                raise
    raise AttributeError(f"module 'rclpy' has no attribute {name!r}")
