"""A check that libddsc can start its threads: where it can't start one, it aborts the process."""

from __future__ import annotations

import _thread

from tfloom.rmw.errors import WireError

__all__ = ["check_threads"]

THREADS = 8
"""Threads that are started for the check: libddsc starts five for a participant, and one is tfloom's own."""


def check_threads(domain_id: int) -> None:
    """Start as many threads at once as a participant needs, and let them end.

    Raises:
        WireError: the system starts fewer.
    """
    gate = _thread.allocate_lock()
    ends = [_thread.allocate_lock() for _ in range(THREADS)]

    def wait(end: _thread.LockType) -> None:
        with gate:
            end.release()

    started = []
    try:
        with gate:
            for end in ends:
                end.acquire()
                _thread.start_new_thread(wait, (end,))
                started.append(end)
    except RuntimeError as error:
        raise WireError(
            f"cannot join DDS domain {domain_id}, which takes {THREADS} threads: {error}. End some program, or "
            "raise the limit of processes (ulimit -u)"
        ) from None
    finally:
        for end in started:
            end.acquire()
