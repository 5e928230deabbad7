"""The default context, and the functions that use it.

There is one for the process, and one for each thread that has its own.
"""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any

from tfloom.common.seconds import checked_timeout, to_nanoseconds
from tfloom.node.context import arguments
from tfloom.node.context.context import Context
from tfloom.node.values.duration import S_TO_NS

__all__ = [
    "S_TO_NS",
    "get_available_rmw_implementations",
    "get_default_context",
    "get_rmw_implementation_identifier",
    "ok",
    "remove_ros_args",
    "shutdown",
    "timeout_sec_to_nsec",
    "try_shutdown",
]


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


_lock = threading.RLock()
"""Guards the default contexts."""


def _renew_lock() -> None:
    """In a forked child, make a new lock, because a thread of the parent may have held it."""
    global _lock  # noqa: PLW0603
    _lock = threading.RLock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_renew_lock)


def get_default_context(*, shutting_down: bool = False) -> Context:
    """Return the context used where none is given; with `shutting_down`, the next call creates a new one."""
    with _lock:
        defaults = current_defaults()
        context = defaults.context
        if context is None or (context.is_from_parent_process() and not shutting_down):
            context = defaults.context = Context()
        if shutting_down:
            defaults.context = None
        return context


def ok(*, context: Context | None = None) -> bool:
    """Return whether a context is initialised and not shut down."""
    return (context or get_default_context()).ok()


def shutdown(*, context: Context | None = None) -> None:
    """Shut a context down.

    Raises:
        RuntimeError: it was never initialised.
        RCLError: it was shut down before.
    """
    (context or get_default_context(shutting_down=True)).shutdown()


def try_shutdown(*, context: Context | None = None) -> None:
    """Shut a context down unless that has been done; the next default context is a new one."""
    (context or get_default_context(shutting_down=True)).try_shutdown()


def remove_ros_args(args: Sequence[str] | None = None) -> list[str]:
    """Return a command line (None: `sys.argv`) without its ROS arguments.

    Raises:
        RCLInvalidROSArgsError: a ROS argument is malformed.
    """
    return arguments.remove_ros_args(sys.argv if args is None else args)


def get_rmw_implementation_identifier() -> str:
    """Return the wire in use, as RMW_IMPLEMENTATION spells it."""
    from tfloom.rmw.backends import implementation_identifier

    return implementation_identifier()


def get_available_rmw_implementations() -> set[str]:
    """Return the wires between processes that RMW_IMPLEMENTATION may select; `tfloom_local` stays within one."""
    from tfloom.rmw.backends import BACKENDS

    return set(BACKENDS) - {"tfloom_local"}


def timeout_sec_to_nsec(timeout_sec: float | None) -> int:
    """Return a timeout [s] in nanoseconds; -1, no limit, for None, negative ones, and those beyond 64 bits.

    Raises:
        TypeError: it is not a number.
        ValueError: it is NaN.
    """
    timeout_s = checked_timeout("timeout_sec_to_nsec", timeout_sec)
    return -1 if timeout_s is None or timeout_s < 0 else to_nanoseconds(timeout_s)
