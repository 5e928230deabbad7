"""The proxy that `handle` properties return: programs write `with node.handle:`, and pass it on."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar, cast

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

__all__ = ["Handle", "unwrap_handle"]

T = TypeVar("T")


class Handle:
    """Proxy returned by `.handle`. tfloom has no C handle, so attributes are forwarded.

    Leaving a `with` of it destroys nothing.
    """

    __slots__ = ("_target",)

    def __init__(self, target: Any) -> None:
        self._target = target

    def __getattr__(self, name: str) -> Any:
        return getattr(self._target, name)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        """Do nothing."""

    def __repr__(self) -> str:
        return f"<Handle of {self._target!r}>"


def unwrap_handle(handle: T | Handle) -> T:
    """Return the object behind a handle, and anything else unchanged."""
    return cast("T", handle._target) if isinstance(handle, Handle) else handle  # noqa: SLF001  # ours
