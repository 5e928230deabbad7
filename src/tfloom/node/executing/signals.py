"""Handlers for SIGINT (Ctrl-C) and SIGTERM, which shut all contexts down, so that spinning ends at once."""

from __future__ import annotations

import _weakrefset
import atexit
import signal
import threading
import time
import weakref
from enum import IntFlag
from types import FrameType
from typing import Any

from tfloom.node.context.context import Context, live_contexts
from tfloom.node.executing.guard_condition import GuardCondition
from tfloom.node.values.handle import unwrap_handle

__all__ = [
    "SignalHandlerGuardCondition",
    "SignalHandlerOptions",
    "get_current_signal_handlers_options",
    "install_signal_handlers",
    "uninstall_signal_handlers",
]


class SignalHandlerOptions(IntFlag):
    """The signals to handle."""

    NO = 0
    SIGINT = 1
    SIGTERM = 2
    ALL = 3


ECHO_S = 0.5
"""Time in which a second SIGINT is ignored [s], because launchers send it to a process and to its group."""

_uninterruptible_files = {
    weakref.WeakMethod.__new__.__code__.co_filename,
    _weakrefset.WeakSet.add.__code__.co_filename,
}
"""Files whose code an exception between two lines would break, or would lose the exception.

Named as in their code objects, because in a frozen program `__file__` is another path.
"""

_interrupted_at = -ECHO_S
_previous: dict[signal.Signals, Any] = {}
_handled_now: set[int] = set()
_SIGNALS = {SignalHandlerOptions.SIGINT: signal.SIGINT, SignalHandlerOptions.SIGTERM: signal.SIGTERM}


def _on_signal(number: int, frame: FrameType | None) -> None:
    global _interrupted_at  # noqa: PLW0603  # written here alone
    contexts = live_contexts()
    if contexts:
        _interrupted_at = time.monotonic()
    elif number == signal.SIGINT and time.monotonic() < _interrupted_at + ECHO_S:
        return  # a KeyboardInterrupt now would interrupt the clean-up after the first
    for context in contexts:
        context.interrupt()
    for guard in _guards:
        guard.trigger()
    previous = _previous.get(signal.Signals(number))
    if contexts and number == signal.SIGINT and not _may_interrupt(frame):
        return  # spinning ends in any case
    if callable(previous) and number not in _handled_now:
        _handled_now.add(number)  # a handler that was installed after ours may call ours
        try:
            previous(number, frame)  # Python's handler for SIGINT raises KeyboardInterrupt
        finally:
            _handled_now.discard(number)


class SignalHandlerGuardCondition(GuardCondition):
    """A guard condition that each handled signal triggers, until it is destroyed."""

    def __init__(self, context: Context | None = None) -> None:
        global _guards  # noqa: PLW0603  # written here and in `destroy`
        super().__init__(None, None, unwrap_handle(context))
        _guards = (*_guards, self)

    def destroy(self) -> None:
        """Stop being triggered."""
        global _guards  # noqa: PLW0603
        _guards = tuple(guard for guard in _guards if guard is not self)
        super().destroy()


_guards: tuple[SignalHandlerGuardCondition, ...] = ()


def _may_interrupt(frame: FrameType | None) -> bool:
    """Return whether an exception may be raised in this frame.

    Python prints and drops an exception in a destructor, and the code of `_uninterruptible_files` would keep a lock.
    """
    while frame is not None:
        if frame.f_code.co_name == "__del__" or frame.f_code.co_filename in _uninterruptible_files:
            return False
        frame = frame.f_back
    return True


def defer_keyboard_interrupt_in(file: str) -> None:
    """Raise no KeyboardInterrupt inside the functions of a file, while there is a context to shut down instead.

    Args:
        file: `co_filename` of their code objects.
    """
    _uninterruptible_files.add(file)


def install_signal_handlers(options: SignalHandlerOptions = SignalHandlerOptions.ALL) -> None:
    """Handle these signals, and those only, from now on.

    A handler shuts all contexts down and then calls the previous handler: for SIGINT, Python's raises
    KeyboardInterrupt in the main thread. SIGTERM, which by default would end the process, makes spins raise
    ExternalShutdownException. A second SIGINT right after the first is ignored; a later one raises
    KeyboardInterrupt at any point of the program.

    On other threads than the main one this does nothing, because Python allows it on that one alone.
    """
    if threading.current_thread() is not threading.main_thread():
        return
    for option, number in _SIGNALS.items():
        if options & option:
            _install(number)
        else:
            _uninstall(number)


def uninstall_signal_handlers() -> None:
    """Restore the former handlers; on other threads than the main one, do nothing."""
    if threading.current_thread() is threading.main_thread():
        for number in list(_previous):
            _uninstall(number)


def get_current_signal_handlers_options() -> SignalHandlerOptions:
    """Return the signals that are handled."""
    options = SignalHandlerOptions.NO
    for option, number in _SIGNALS.items():
        if number in _previous:
            options |= option
    return options


@atexit.register
def _ignore_handled_signals() -> None:
    """Ignore the handled signals for the rest of the process, whose exit code has been set.

    The interpreter's exit restores the default action of each signal, so that one that arrives late would end the
    process with another exit code. Ignored signals stay ignored.
    """
    for number in list(_previous):
        if signal.getsignal(number) is _on_signal:
            signal.signal(number, signal.SIG_IGN)


def _install(number: signal.Signals) -> None:
    current = signal.getsignal(number)
    if current is not _on_signal:
        _previous[number] = current
        signal.signal(number, _on_signal)


def _uninstall(number: signal.Signals) -> None:
    if number in _previous:
        previous = _previous.pop(number)
        # A handler that was installed after ours stays.
        if signal.getsignal(number) is _on_signal:
            signal.signal(number, previous if previous is not None else signal.SIG_DFL)
