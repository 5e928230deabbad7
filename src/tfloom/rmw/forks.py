"""Forked processes: objects of the wire that a child has inherited.

A fork copies the memory of a process, but only one of its threads: nothing sends or receives for the copies, and
their sockets are the parent's. So in the child they raise ForkedError. Closing them does nothing.
"""

from __future__ import annotations

import os
from typing import Any, NoReturn

from tfloom.rmw.errors import ForkedError

ADVICE = (
    "this process was forked after that, and a fork has none of the threads that send and receive. In the child, "
    "call rclpy.init() and create the node anew, or start the child by multiprocessing's method 'spawn'"
)

_lasting: tuple[str, int] | None = None
"""The advice of a wire that can't be opened in any child, and the process that has opened it."""


def forbid_children(advice: str) -> None:
    """Note that a wire is open here that no child of this process can open anew.

    Args:
        advice: What to do instead, in the place of `ADVICE`.
    """
    global _lasting  # noqa: PLW0603  # a fact about the process
    _lasting = advice, os.getpid()


def lasting_advice() -> str:
    """Return the advice of `forbid_children`, in its process and in children; empty where nothing is forbidden."""
    return "" if _lasting is None else _lasting[0]


def check_start() -> None:
    """Check that a wire can be opened in this process.

    Raises:
        ForkedError: it is a child of a process that has called `forbid_children`.
    """
    if _lasting is not None and _lasting[1] != os.getpid():
        raise ForkedError(f"the wire was opened by the parent process: {_lasting[0]}")


def refuse(what: str) -> NoReturn:
    """Raise the error of a use in a child.

    Args:
        what: What was inherited, as `the writer of /chatter`.

    Raises:
        ForkedError: always.
    """
    raise ForkedError(f"{what} was opened by the parent process: {ADVICE}")


class Inherited:
    """What takes the place of a native object in a child: each operation raises ForkedError.

    Args:
        what: Description for the error.
        native: The object, which is kept, because the library can't free it in a child.
    """

    def __init__(self, what: str, native: object) -> None:
        self._what = what
        self._kept = native

    def __getattr__(self, name: str) -> Any:
        refuse(self._what)

    def notify(self, queue: object, *_: object) -> None:
        """Do nothing if `queue` is None, because that ends notifications."""
        if queue is not None:
            refuse(self._what)

    def notify_event(self, _event: object, queue: object, *_: object) -> None:
        """Do nothing if `queue` is None, because that ends notifications."""
        if queue is not None:
            refuse(self._what)

    def close(self) -> None:
        """Do nothing: the parent closes it."""
