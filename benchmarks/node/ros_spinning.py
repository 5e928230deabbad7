"""The ways in which a program runs its callbacks, with ROS's names alone: tfloom and rclpy run the same code."""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Iterator
from typing import Any, Protocol

IN_A_THREAD = ("spin", "MultiThreadedExecutor", "EventsExecutor")
WAYS = ("spin_once", *IN_A_THREAD)
"""`spin_once` in a loop of the main thread, or a spin of one of the executors in a thread of its own."""
MAX_DURATION_S = 30.0


class Wait(Protocol):
    """Waits for an event, and returns whether it was set within the time."""

    def __call__(self, event: threading.Event, timeout_s: float = ..., /) -> bool: ...


def executor_of(way: str) -> Any:
    """Return the executor of a way."""
    from rclpy import executors

    if way == "EventsExecutor":
        from rclpy.experimental import EventsExecutor

        return EventsExecutor()
    if way == "MultiThreadedExecutor":
        return executors.MultiThreadedExecutor(num_threads=2)
    return executors.SingleThreadedExecutor()


@contextlib.contextmanager
def spinning(way: str, *nodes: Any) -> Iterator[Wait]:
    """Spin nodes for the block, and yield a function that waits for an event that a callback sets."""
    executor = executor_of(way)
    for node in nodes:
        executor.add_node(node)

    def spin_until(event: threading.Event, timeout_s: float = MAX_DURATION_S) -> bool:
        end = time.monotonic() + timeout_s
        while not event.is_set():
            left = end - time.monotonic()
            if left <= 0.0:
                return False
            executor.spin_once(timeout_sec=left)
        return True

    if way == "spin_once":
        yield spin_until
        return
    thread = threading.Thread(target=executor.spin, daemon=True)
    thread.start()
    try:
        yield lambda event, timeout_s=MAX_DURATION_S: event.wait(timeout_s)
    finally:
        executor.shutdown()
        thread.join(MAX_DURATION_S)
