"""Handlers for SIGINT (Ctrl-C) and SIGTERM, which shut all contexts down, so that spinning ends at once."""

from __future__ import annotations

import _thread
import _weakrefset
import atexit
import math
import os
import signal
import sys
import threading
import time
import weakref
from contextlib import suppress
from enum import IntFlag
from types import FrameType
from typing import Any

from tfloom._native import block_if_ending
from tfloom.node.context.context import Context, live_contexts
from tfloom.node.executing.guard_condition import GuardCondition
from tfloom.node.values.exceptions import ExternalShutdownException
from tfloom.node.values.handle import unwrap_handle
from tfloom.rmw.postponed_interrupt import postponed, uninterrupted_files

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
"""Time in which a second signal is ignored [s], because launchers send it to a process and to its group."""
POSTPONED_S = 1.0
"""Longest time by which a KeyboardInterrupt is postponed [s]."""
RETRY_S = 0.005

_uninterruptible_files = {
    weakref.WeakMethod.__new__.__code__.co_filename,
    _weakrefset.WeakSet.add.__code__.co_filename,
    "<frozen importlib._bootstrap>",  # modules in C replace the exception by an ImportError, as numpy's do
    "<frozen importlib._bootstrap_external>",
}
"""Files whose code an exception between two lines would break, or would lose the exception.

Named as in their code objects, because in a frozen program `__file__` is another path.
"""
_uninterruptible_functions = {"__del__", "new_event_loop"}  # the destructor of half a loop prints an error

_interrupted_at = -math.inf
"""When a signal shut a context down [s], until the next `init`."""
_previous: dict[signal.Signals, Any] = {}
_kept_after_shutdown: set[signal.Signals] = set()
"""Those of `_previous` that are still handled because the program is ending by a signal."""
_numbers_in_previous_handler: set[int] = set()
_SIGNALS = {SignalHandlerOptions.SIGINT: signal.SIGINT, SignalHandlerOptions.SIGTERM: signal.SIGTERM}


def _on_signal(number: int, frame: FrameType | None) -> None:
    global _interrupted_at  # noqa: PLW0603  # written on the main thread alone
    contexts = live_contexts()
    # The first signal finds live contexts and shuts them down. Later ones find none: the same signal from a launcher,
    # which is ignored; a SIGINT by which `_retry` asks to raise what was postponed; or one that is meant by the user.
    if contexts:
        _interrupted_at = time.monotonic()
    elif number == signal.SIGINT and postponed.is_set():
        _interrupt_main_thread(frame)
        return
    elif _is_repetition(number):
        return  # an exception now would interrupt the clean-up after the first
    for context in contexts:
        context.interrupt()
    for guard in _guards:
        guard.trigger()
    if contexts and number == signal.SIGINT:
        # Set before the attempt: where no exception may be raised now, a spin or `_retry` finds it here and raises it.
        postponed.set(time.monotonic() + POSTPONED_S)
        _interrupt_main_thread(frame)
    elif number in _kept_after_shutdown:
        # The handler is ours only to protect the clean-up from a repetition of the signal. This is none, so it acts as
        # it would have before `init`.
        _end_as_before_init(signal.Signals(number))
    else:
        _call_previous(number, frame)


def _is_repetition(number: int) -> bool:
    """Return whether a signal that arrives when no context is alive follows the one that ended the last."""
    return time.monotonic() < _interrupted_at + ECHO_S and (
        number == signal.SIGINT or number in _kept_after_shutdown
    )


def _interrupt_main_thread(frame: FrameType | None) -> None:
    """Call the previous handler of SIGINT; Python's raises KeyboardInterrupt. Where it would be lost, do it later."""
    if _may_interrupt(frame) or postponed.is_overdue(time.monotonic()):
        postponed.take()  # raised here, so no spin must raise it once more
        _call_previous(signal.SIGINT, frame)
    else:
        # Not a Thread, because its start may be what was interrupted. Without one, a spin raises what is postponed.
        with suppress(RuntimeError):
            _thread.start_new_thread(_retry, ())


def _retry() -> None:
    # The main thread leaves the code that must not be interrupted meanwhile, or reaches a spin, which raises what was
    # postponed itself. The signal runs `_on_signal` again, which starts the next retry if need be.
    time.sleep(RETRY_S)
    if not postponed.is_set():
        return
    main_thread = threading.main_thread().ident
    if hasattr(signal, "pthread_kill") and main_thread is not None:
        signal.pthread_kill(main_thread, signal.SIGINT)  # `interrupt_main` doesn't end a sleep
    else:
        _thread.interrupt_main(signal.SIGINT)


def _call_previous(number: int, frame: FrameType | None) -> None:
    previous = _previous.get(signal.Signals(number))
    if callable(previous) and number not in _numbers_in_previous_handler:
        _numbers_in_previous_handler.add(number)  # a handler that was installed after ours may call ours
        try:
            previous(number, frame)
        finally:
            _numbers_in_previous_handler.discard(number)


def _end_as_before_init(number: signal.Signals) -> None:
    """Restore a signal's former handler, and send the signal again."""
    _uninstall(number)
    signal.raise_signal(number)


def shutdown_exception() -> BaseException:
    """Return what a spin raises after its context was shut down: KeyboardInterrupt if that is still to be raised.

    Where the program's end has closed the context, a spin on a daemon thread ends with the program, without a
    traceback.
    """
    block_if_ending()
    return KeyboardInterrupt() if postponed.take() else ExternalShutdownException()


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

    Python prints and drops an exception in a destructor, a wire's library in its callbacks, and the code of
    `_uninterruptible_files` would keep a lock.
    """
    if frame is not None and _is_entering_with(frame):
        return False
    # All callers count, not only the innermost frame: the code of such a file may have called what runs now, as an
    # import runs the code of a module.
    while frame is not None:
        code = frame.f_code
        file = code.co_filename
        if (
            file in _uninterruptible_files
            or file in uninterrupted_files
            or code.co_name in _uninterruptible_functions
        ):
            return False
        frame = frame.f_back
    return True


class _Probe:
    """Reads the instructions by which a `with` calls `__enter__`: the look-up, and the call."""

    instructions = b""

    def __enter__(self) -> None:
        frame = sys._getframe(1)  # inspect takes long to import
        self.instructions = frame.f_code.co_code[frame.f_lasti - 2 : frame.f_lasti + 2]

    def __exit__(self, *_: object) -> None: ...


_probe = _Probe()
with _probe:
    pass


def _is_entering_with(frame: FrameType) -> bool:
    """Return whether a frame is between the `__enter__` of a `with` and its block.

    From Python 3.14 on a handler may run there, and after its exception nothing calls `__exit__`: a lock stays locked.
    """
    call = frame.f_lasti
    return sys.version_info >= (3, 14) and frame.f_code.co_code[call - 2 : call + 2] == _probe.instructions


def defer_keyboard_interrupt_in(file: str) -> None:
    """Postpone a KeyboardInterrupt until the functions of a file have returned, if a signal shut a context down.

    Args:
        file: `co_filename` of their code objects.
    """
    _uninterruptible_files.add(file)


def install_signal_handlers(options: SignalHandlerOptions = SignalHandlerOptions.ALL) -> None:
    """Handle these signals, and those only, from now on.

    A handler shuts all contexts down and then calls the previous handler: for SIGINT, Python's raises
    KeyboardInterrupt in the main thread. SIGTERM, which by default would end the process, makes spins raise
    ExternalShutdownException. A second signal right after the first is ignored; a later SIGINT raises
    KeyboardInterrupt at any point of the program.

    On other threads than the main one this does nothing, because Python allows it on that one alone.
    """
    global _interrupted_at  # noqa: PLW0603
    if threading.current_thread() is not threading.main_thread():
        return
    _interrupted_at = -math.inf
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


def leave_signal_handlers() -> None:
    """Restore the former handlers after a shutdown; on other threads than the main one, do nothing.

    If a signal shut the context down, the default actions are not restored, because a second signal right after the
    first would break off the clean-up and change the exit code.
    """
    postponed.take()
    if threading.current_thread() is not threading.main_thread():
        return
    for number, previous in list(_previous.items()):
        # A handler of the program's own is restored: what a second signal does is its decision.
        is_default = previous in {signal.SIG_DFL, signal.default_int_handler}
        if is_default and _interrupted_at > -math.inf and signal.getsignal(number) is _on_signal:
            _kept_after_shutdown.add(number)
        else:
            _uninstall(number)


def get_current_signal_handlers_options() -> SignalHandlerOptions:
    """Return the signals that are handled."""
    options = SignalHandlerOptions.NO
    for option, number in _SIGNALS.items():
        if number in _previous and number not in _kept_after_shutdown:
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


_before_fork = threading.local()
"""`mask`: the signals that were blocked before this thread began to fork; absent while it does not."""


def _block_signals() -> None:
    """Before a fork, block the handled signals, because Python drops those that a child receives too early."""
    if _previous and sys.platform != "win32":
        _before_fork.mask = signal.pthread_sigmask(signal.SIG_BLOCK, list(_previous))


def _unblock_signals() -> None:
    """After a fork, undo `_block_signals`."""
    mask = _before_fork.__dict__.pop("mask", None)
    if mask is not None and sys.platform != "win32":
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)


def _restore_handlers_in_forked_child() -> None:
    """In a forked child, restore the former handlers if the parent's contexts, which they shut down, are not usable.

    So Ctrl-C and the SIGTERM of `multiprocessing.Process.terminate` end a child that creates no context.
    """
    if _previous and not live_contexts():
        uninstall_signal_handlers()
    _unblock_signals()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(
        before=_block_signals,
        after_in_parent=_unblock_signals,
        after_in_child=_restore_handlers_in_forked_child,
    )


def _install(number: signal.Signals) -> None:
    _kept_after_shutdown.discard(number)
    current = signal.getsignal(number)
    if current is not _on_signal:
        _previous[number] = current
        signal.signal(number, _on_signal)


def _uninstall(number: signal.Signals) -> None:
    _kept_after_shutdown.discard(number)
    if number in _previous:
        previous = _previous.pop(number)
        # A handler that was installed after ours stays.
        if signal.getsignal(number) is _on_signal:
            signal.signal(number, previous if previous is not None else signal.SIG_DFL)
