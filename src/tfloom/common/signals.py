"""Signals that are handled after a block, not within it."""

from __future__ import annotations

# The functions of the module signal try to make an enum of each handler, by exceptions: that takes ten times as long.
import _signal  # type: ignore[import-not-found]
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from types import FrameType

__all__ = ["signals_deferred"]

_DEFERRED = [
    getattr(_signal, name)
    for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT", "SIGALRM", "SIGUSR1", "SIGUSR2")
    if hasattr(_signal, name)  # Windows has the first two
]


@contextmanager
def signals_deferred() -> Iterator[None]:
    """Call the handlers of signals at the end of the block, for those that come within it.

    For what must be done whole, as the end of a bag, and for libraries that call back on the main thread: what a
    handler raises there, as KeyboardInterrupt, the library would print, and the program would go on.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    handlers = {number: handler for number in _DEFERRED if callable(handler := _signal.getsignal(number))}
    came: list[tuple[int, FrameType | None]] = []
    is_over = False

    def note(number: int, frame: FrameType | None) -> None:
        if is_over:  # what another signal's handler raised has kept this one's from being set again
            handlers[number](number, frame)
        else:
            came.append((number, frame))

    try:
        for number in handlers:
            _signal.signal(number, note)
        yield
    finally:
        is_over = True
        try:
            for number, handler in handlers.items():
                _signal.signal(number, handler)
        finally:
            _call_each(handlers, iter(came))


def _call_each(
    handlers: Mapping[int, Callable[[int, FrameType | None], object]],
    came: Iterator[tuple[int, FrameType | None]],
) -> None:
    """Call the handler of each signal, also of those after one whose handler raises."""
    try:
        for number, frame in came:
            handlers[number](number, frame)
    except BaseException:
        _call_each(handlers, came)
        raise
