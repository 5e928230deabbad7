"""Submodules of a façade that are imported on first use, as `rclpy.time.Time()` after `import rclpy` alone.

In the original they are there because its modules import one another; these façades import tfloom's rooms instead.
"""

from __future__ import annotations

from importlib import import_module
from types import ModuleType

__all__ = ["rclpy_module"]


def rclpy_module(name: str) -> ModuleType:
    """Import and return the module `rclpy.<name>`: the `__getattr__` of the façade `rclpy`.

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
