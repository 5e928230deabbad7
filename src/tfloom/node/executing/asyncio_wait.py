"""Awaiting a future in asyncio, without polling, and without loading asyncio in programs that don't use it."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Coroutine, Generator
from contextlib import suppress
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    import asyncio

__all__ = ["Awaited", "is_driven_by_asyncio", "step", "wait_in_asyncio"]


class Awaited(Protocol):
    """A future, as far as asyncio needs one."""

    def when_complete(self, resume: Callable[[], None]) -> None:
        """Call `resume()` on completion, at once if it is complete, on the completing thread."""

    def cancel(self) -> None:
        """Cancel the future, unless it is complete already."""

    def cancelled(self) -> bool:
        """Return whether `cancel` came before a result."""


class _Stepping(threading.local):
    """The step that the calling thread runs for an executor."""

    around: asyncio.Task[Any] | None = None
    """The asyncio task inside which the step runs; None: inside none, or no step runs."""


_stepping = _Stepping()


def step(coroutine: Coroutine[Any, Any, Any]) -> Any:
    """Run a coroutine of an executor to its next await and return what it yields there."""
    # Steps are nested where a callback spins an executor: at its end, the outer step is the one that runs again.
    former_task = _stepping.around
    _stepping.around = _current_task()
    try:
        return coroutine.send(None)
    finally:
        _stepping.around = former_task


def is_driven_by_asyncio() -> bool:
    """Return whether the innermost coroutine of this thread is run by asyncio, rather than by an executor.

    An executor may spin inside an asyncio task, and a callback of an executor may call `asyncio.run`.
    """
    task = _current_task()
    return task is not None and task is not _stepping.around


def _current_task() -> asyncio.Task[Any] | None:
    """Return the asyncio task that this thread runs."""
    if "asyncio" not in sys.modules:
        return None
    import asyncio

    try:
        return asyncio.current_task()
    except RuntimeError:  # no loop runs on this thread
        return None


def wait_in_asyncio(future: Awaited) -> Generator[Any, None, None]:
    """Suspend the asyncio task that runs until `future` is complete, on whichever thread that happens.

    Raises:
        CancelledError: the task was cancelled, which cancels the future as well; or the future was.
    """
    import asyncio

    loop = asyncio.get_running_loop()
    # The future completes on any thread, but a future of asyncio may be completed on its loop's thread alone.
    waiter = loop.create_future()

    def resume() -> None:
        if not waiter.done():  # the task may have been cancelled before the loop came to this
            waiter.set_result(None)

    def resume_in_loop() -> None:
        with suppress(RuntimeError):  # the loop was closed meanwhile, and with it everything that waits in it
            loop.call_soon_threadsafe(resume)

    future.when_complete(resume_in_loop)
    try:
        yield from waiter
    except asyncio.CancelledError:
        future.cancel()
        raise
    if future.cancelled():
        raise asyncio.CancelledError
