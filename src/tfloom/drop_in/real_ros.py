"""The names of a real ROS 2, imported when they are needed. No other module of tfloom imports a ROS name.

They cannot be imported when this package is loaded, because tfloom is installed where there is no ROS.
"""

from __future__ import annotations

from functools import lru_cache
from importlib import import_module
from types import ModuleType
from typing import Any

from tfloom.ros_imports.guard import is_elsewhere

__all__ = ["find", "has_rclpy", "message_class", "module"]


def has_rclpy() -> bool:
    """Return whether `rclpy` is, or would be, imported from a ROS 2 other than tfloom."""
    return is_elsewhere("rclpy")


def module(name: str) -> ModuleType:
    """Import and return a module of the real ROS 2, by its full name.

    Raises:
        ImportError: its package is not installed, or only as tfloom's façade; or its own imports fail.
    """
    package = name.partition(".")[0]
    if not is_elsewhere(package):
        raise ImportError(f"'{package}' is not installed for the ROS 2 that 'rclpy' comes from", name=package)
    return import_module(name)


@lru_cache(maxsize=32)
def find(name: str) -> ModuleType | None:
    """Return a module of the real ROS 2, or None if its package is not installed for it."""
    return module(name) if is_elsewhere(name.partition(".")[0]) else None


def message_class(package: str, name: str, kind: str = "msg") -> Any:
    """Return a message or service class of the real ROS 2.

    Raises:
        ImportError: its package is not installed for it.
    """
    return getattr(module(f"{package}.{kind}"), name)
