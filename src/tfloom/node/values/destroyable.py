"""The type of objects that are destroyed when they are not in use."""

from __future__ import annotations

from typing import Protocol

__all__ = ["DestroyableType"]


class DestroyableType(Protocol):
    """An object with the destructor that rclpy's compiled module has."""

    def destroy_when_not_in_use(self) -> None:
        """Release what the object holds; it must not be used afterwards."""
