"""Calls of callbacks, of which one that raises does not prevent the others."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterable
from contextlib import suppress

from tfloom.common.terminal import report

__all__ = ["call_all", "print_error", "report_exception"]


def call_all(calls: Iterable[Callable[[], object]]) -> None:
    """Make all calls, in order; then raise the first exception, and print the traceback of each other one.

    The callbacks of a list are of several users, of which each relies on being called: a timer's callback for jumps
    of its clock, for example, stands beside those of the program. KeyboardInterrupt and SystemExit end the calls.
    """
    first: Exception | None = None
    for call in calls:
        try:
            call()
        except Exception as error:  # raised below
            if first is None:
                first = error
            else:
                print_error(error)
    if first is not None:
        raise first


def print_error(error: BaseException, title: str = "") -> None:
    """Print the traceback of an error on stderr, below a title; do nothing where that can't be written."""
    import traceback  # not above, because from Python 3.14 on it loads dataclasses and inspect

    lines = "".join(traceback.format_exception(error)).removesuffix("\n")
    report(f"{title}\n{lines}" if title else lines)


def report_exception() -> None:
    """Report the exception that is being handled by `threading.excepthook`, though its thread goes on.

    For callbacks that a thread of the library runs: no caller of the program's would get the exception.
    """
    with suppress(OSError):  # where stderr can't be written
        threading.excepthook(threading.ExceptHookArgs((*sys.exc_info(), threading.current_thread())))
