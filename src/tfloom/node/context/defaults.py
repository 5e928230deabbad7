"""The context that functions use where none is given: one for the process, or one for a thread."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any

from tfloom.node.context.context import Context


class Defaults:
    """Holder of a default context and of the executor on it; each is None until its first use.

    Args:
        context: The first default context.
    """

    def __init__(self, context: Context | None = None) -> None:
        self.context = context
        self.executor: Any = None
        """An `Executor`, which this room doesn't know. Read without a lock; `get_global_executor` alone writes it."""


_current: ContextVar[Defaults] = ContextVar("defaults", default=Defaults())  # noqa: B039  # one for the process


def current_defaults() -> Defaults:
    """Return the defaults of this thread if it has some, else those of the process."""
    return _current.get()


@contextmanager
def own_defaults(context: Context) -> Iterator[None]:
    """Make `context` the default of this thread alone for the block, with a default executor of the thread's own.

    So several programs that name no context can run in one process, each on its own thread.
    """
    token = _current.set(Defaults(context))
    try:
        yield
    finally:
        _current.reset(token)
