"""The context and the executor that functions use where none is given."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.node.context import Context
    from tfloom.node.executor import Executor


class Defaults:
    """A default context and a default executor, each None until it is needed.

    Args:
        context: The context to begin with.
    """

    def __init__(self, context: Context | None = None) -> None:
        self.context = context
        self.executor: Executor | None = None


_current: ContextVar[Defaults] = ContextVar("defaults", default=Defaults())  # noqa: B039  # one for the process


def current_defaults() -> Defaults:
    """Return the defaults of this thread if it has its own, else those of the process."""
    return _current.get()


@contextmanager
def own_defaults(context: Context) -> Iterator[None]:
    """Make `context` the default of this thread alone for the block, and give the thread an executor of its own.

    So programs that name no context run side by side in one process, each on its own thread.
    """
    token = _current.set(Defaults(context))
    try:
        yield
    finally:
        _current.reset(token)
