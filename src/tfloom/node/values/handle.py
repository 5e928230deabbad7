"""The proxy that `handle` properties return, for programs that write `with node.handle:` or pass it to rclpy."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol, TypeVar, cast

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import TracebackType

    from typing_extensions import Self

__all__ = ["DestroyableType", "Handle", "unwrap_handle"]

T = TypeVar("T")


class DestroyableType(Protocol):
    """An object with the destructor that rclpy's compiled module has."""

    def destroy_when_not_in_use(self) -> None:
        """Release what the object holds; it must not be used afterwards."""


class Handle:
    """Proxy returned by `.handle`. tfloom has no C handle, so attributes are forwarded.

    The exit of a `with` block on it destroys nothing.

    Args:
        target: What the attributes are forwarded to.
        check_exists: Called at the entry of a `with` block; raises InvalidHandle if the target was destroyed.
    """

    __slots__ = ("_check_exists", "_target")

    def __init__(self, target: Any, check_exists: Callable[[], object] | None = None) -> None:
        self._target = target
        self._check_exists = check_exists

    def __getattr__(self, name: str) -> Any:
        return getattr(self._target, name)

    def __enter__(self) -> Self:
        if self._check_exists is not None:
            self._check_exists()
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        """Do nothing."""

    def __repr__(self) -> str:
        return f"<Handle of {self._target!r}>"


def unwrap_handle(handle: T | Handle) -> T:
    """Return the object that a handle forwards to; return any other object unchanged."""
    return cast("T", handle._target) if isinstance(handle, Handle) else handle  # noqa: SLF001  # all other names are the target's
