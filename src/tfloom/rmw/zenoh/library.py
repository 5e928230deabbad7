"""The search for eclipse-zenoh, the library of the Zenoh wire, its log, and signals while it calls back.

`import zenoh` costs a command time, so it is done when a session or a router is opened.
"""

from __future__ import annotations

# The functions of the module signal try to make an enum of each handler, by exceptions: that takes ten times as long.
import _signal  # type: ignore[import-not-found]
import sys
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from importlib.machinery import PathFinder
from types import FrameType, ModuleType

from tfloom.rmw.errors import NoBackendError

__all__ = ["find_library", "open_library", "signals_deferred"]

_HOW_TO_INSTALL = "install it with: pip install 'tfloom[zenoh]'"
_HOW_TO_DO_WITHOUT = (
    "eclipse-zenoh has wheels for Linux with glibc, macOS and Windows; within one process, "
    "RMW_IMPLEMENTATION=tfloom_local needs nothing"
)
_DEFERRED = [
    getattr(_signal, name)
    for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT", "SIGALRM", "SIGUSR1", "SIGUSR2")
    if hasattr(_signal, name)  # Windows has the first two
]


def find_library() -> str:
    """Return the folder of the package zenoh, without importing it.

    Raises:
        NoBackendError: it isn't installed.
    """
    spec = PathFinder.find_spec("zenoh")
    if spec is None or not spec.submodule_search_locations or spec.loader is None:
        raise NoBackendError(f"there is no Zenoh: {_HOW_TO_INSTALL}; {_HOW_TO_DO_WITHOUT}")
    return next(iter(spec.submodule_search_locations))


def open_library() -> ModuleType:
    """Return the module zenoh. Its log shows errors alone, unless RUST_LOG asks for more.

    Raises:
        NoBackendError: it isn't installed, or can't be loaded on this system.
    """
    is_first = "zenoh" not in sys.modules
    find_library()
    try:
        import zenoh
    except ImportError as error:
        raise NoBackendError(
            f"the package zenoh can't be loaded: {error}; {_HOW_TO_INSTALL}; {_HOW_TO_DO_WITHOUT}"
        ) from None
    if is_first:
        zenoh.init_log_from_env_or("off")
    return zenoh


@contextmanager
def signals_deferred() -> Iterator[None]:
    """Call the handlers of signals at the end of the block, for those that come within it.

    Zenoh calls back on the thread that declares something, ends it, or writes to a reader of the same session. If that
    is the main one, a handler may run in the callback. What it raises, as KeyboardInterrupt, would be printed by Zenoh,
    and the program would go on.
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
