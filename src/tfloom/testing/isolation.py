"""The state that code under test shares with the rest of the process, replaced for one test.

It is the environment's variables that select the wire and the domain, the default context, and the handlers of signals.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from itertools import count
from pathlib import Path
from typing import Any

from tfloom.node.context.context import live_contexts
from tfloom.node.context.utilities import current_defaults
from tfloom.rmw.backends import MAX_DOMAIN_ID
from tfloom.testing.domains import hold_domain

__all__ = ["WIRES", "isolated"]

WIRES = {"local": "tfloom_local", "dds": "rmw_cyclonedds_cpp"}
"""The value of RMW_IMPLEMENTATION, by the name that a test gives."""

_SIGNALS = "tfloom.node.executing.signals"
_local_numbers = count()


@contextmanager
def isolated(wire: str, log_folder: Path) -> Iterator[int]:
    """Give the block its own wire, domain and default context, and yield the number of the domain.

    The context is not initialised. At the end all contexts that the block has initialised are shut down, with their
    nodes, and everything else is as before.

    Args:
        wire: A key of `WIRES`: `local` is in the process, `dds` is on the loopback interface.
        log_folder: Where nodes write their log files.

    Raises:
        TimeoutError: all domains of DDS are in use.
    """
    with ExitStack() as stack:
        stack.enter_context(_restored_signal_handlers())
        # On the wire in the process a new number for each test is enough, because no other process is on it.
        domain = (
            next(_local_numbers) % MAX_DOMAIN_ID if wire == "local" else stack.enter_context(hold_domain())
        )
        stack.enter_context(
            _environment(
                RMW_IMPLEMENTATION=WIRES[wire],
                ROS_DOMAIN_ID=str(domain),
                ROS_AUTOMATIC_DISCOVERY_RANGE="LOCALHOST",
                ROS_STATIC_PEERS="",
                ROS_LOCALHOST_ONLY="",
                ROS_LOG_DIR=str(log_folder),
            )
        )
        stack.enter_context(_own_contexts())
        yield domain


@contextmanager
def _own_contexts() -> Iterator[None]:
    defaults = current_defaults()
    former, defaults.context = defaults.context, None
    # What exists before the block, such as a fixture's context of a wider scope, stays.
    others = set(live_contexts())
    try:
        yield
    finally:
        for context in set(live_contexts()) - others:
            context.destroy()
        if defaults.context is not None:
            defaults.context.destroy()
        defaults.context = former


@contextmanager
def _environment(**variables: str) -> Iterator[None]:
    former = {name: os.environ.get(name) for name in variables}
    _set_environment(variables)
    try:
        yield
    finally:
        _set_environment(former)


def _set_environment(variables: Mapping[str, str | None]) -> None:
    """Set variables; None and an empty text remove one."""
    for name, value in variables.items():
        if value:
            os.environ[name] = value
        else:
            os.environ.pop(name, None)


@contextmanager
def _restored_signal_handlers() -> Iterator[None]:
    """Take away the handlers that the block installs, and those of `rclpy.init`, which stay if nobody shuts down."""
    former = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield
    finally:
        signals = sys.modules.get(_SIGNALS)
        changed = {number for number in former if signal.getsignal(number) is not former[number]}
        if changed and signals is not None:
            signals.uninstall_signal_handlers()
        for number in changed:
            _restore(number, former[number])


def _restore(number: int, handler: Any) -> None:
    """Restore a handler; Python does so on the main thread alone.

    None is one that Python doesn't know, and rclpy's own would not know the handler before it.
    """
    is_rclpys = getattr(handler, "__module__", None) == _SIGNALS
    if handler is not None and not is_rclpys and threading.current_thread() is threading.main_thread():
        signal.signal(number, handler)
