"""Signals in an asyncio program."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable
from types import FrameType, TracebackType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from asyncio import AbstractEventLoop

__all__ = ["AsyncSafeSignalManager"]

Handler = Callable[[int], None]


class AsyncSafeSignalManager:
    """Runs handlers of signals as callbacks of a loop, for the time of a `with` block, and restores the previous ones.

    On another thread than the main one it handles none, because Python passes signals to the main thread alone.

    Args:
        loop: The loop.
    """

    def __init__(self, loop: AbstractEventLoop) -> None:
        self._loop = loop
        self._handlers: dict[int, Handler] = {}
        self._previous: dict[int, Any] = {}
        self._is_entered = False

    def handle(self, signum: signal.Signals | int, handler: Handler | None) -> Handler | None:
        """Set the handler of a signal, None for none, and return the one before."""
        before = self._handlers.pop(signum, None)
        if handler is not None:
            self._handlers[signum] = handler
            if self._is_entered:
                self._install(signum)
        elif self._is_entered:
            self._restore(signum)
        return before

    def __enter__(self) -> AsyncSafeSignalManager:  # noqa: PYI034  # Self needs Python 3.11
        """Install the handlers."""
        if threading.current_thread() is threading.main_thread():
            self._is_entered = True
            for signum in self._handlers:
                self._install(signum)
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_value: BaseException | None,
        exc_traceback: TracebackType | None,
    ) -> None:
        """Restore the previous handlers."""
        self._is_entered = False
        for signum in list(self._previous):
            self._restore(signum)

    def _install(self, signum: int) -> None:
        if signum not in self._previous:
            # Python's own handler wakes the loop, by the descriptor that asyncio gives `set_wakeup_fd`.
            self._previous[signum] = signal.signal(signum, self._on_signal)

    def _restore(self, signum: int) -> None:
        if signum in self._previous:
            signal.signal(signum, self._previous.pop(signum) or signal.SIG_DFL)

    def _on_signal(self, signum: int, _: FrameType | None) -> None:
        if not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self._call, signum)

    def _call(self, signum: int) -> None:
        if (handler := self._handlers.get(signum)) is not None:
            handler(signum)
