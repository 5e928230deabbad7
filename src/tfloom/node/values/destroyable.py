"""What can be destroyed."""

from __future__ import annotations

from typing import Protocol

__all__ = ["DestroyableType"]


class DestroyableType(Protocol):
    """Something to be destroyed when nobody uses it any more."""

    def destroy_when_not_in_use(self) -> None:
        """Destroy it."""
