"""The context that functions use where none is given: one for the process, or a thread's own."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from tfloom.node.context.context import Context


class Defaults:
    """Holds a default context, which is None until it is needed.

    Args:
        context: The context to begin with.
    """

    def __init__(self, context: Context | None = None) -> None:
        self.context = context


_current: ContextVar[Defaults] = ContextVar("defaults", default=Defaults())  # noqa: B039  # one for the process


def current_defaults() -> Defaults:
    """Return the defaults of this thread if it has its own, else those of the process."""
    return _current.get()


@contextmanager
def own_defaults(context: Context) -> Iterator[None]:
    """Make `context` the default of this thread alone for the block; the thread's default executor is its own, too.

    So programs that name no context run side by side in one process, each on its own thread.
    """
    token = _current.set(Defaults(context))
    try:
        yield
    finally:
        _current.reset(token)
