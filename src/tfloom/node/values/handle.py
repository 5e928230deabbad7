"""What the `handle` properties give: programs write `with node.handle:`, and pass it on."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar, cast

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

__all__ = ["Handle", "thing_of"]

T = TypeVar("T")


class Handle:
    """Stands for an object of the library's own, of which there is none: has all that the thing itself has.

    Other than the thing, it may be used in a `with` that leaves the thing as it is.
    """

    __slots__ = ("_thing",)

    def __init__(self, thing: Any) -> None:
        self._thing = thing

    def __getattr__(self, name: str) -> Any:
        return getattr(self._thing, name)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        """Leave the thing as it is."""

    def __repr__(self) -> str:
        return f"<Handle of {self._thing!r}>"


def thing_of(handle: T | Handle) -> T:
    """Return the thing that a handle stands for; anything else as it is."""
    return cast("T", handle._thing) if isinstance(handle, Handle) else handle  # noqa: SLF001  # ours
