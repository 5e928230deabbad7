"""A wait for a future of a node that another thread may spin, or nobody."""

from __future__ import annotations

import threading
import time
import weakref
from typing import Any

from tfloom.node.executing.executor import executor_of
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.task import Future

__all__ = ["wait_for_future"]

LOOK_AGAIN_S = 0.1
"""Period at which a wait checks whether its node is still spun elsewhere [s]."""

_lock = threading.Lock()
_spinning: weakref.WeakKeyDictionary[Any, threading.Lock] = weakref.WeakKeyDictionary()


def wait_for_future(node: Any, future: Future[Any], end_s: float) -> None:
    """Wait until a future is complete, until `end_s` by the steady clock [s], or until the shutdown.

    Args:
        node: The node whose executor completes the future; in none, it is spun here.
        future: The future.
        end_s: The end; infinite: no limit. One that is past lets what is ready be called.
    """
    # A node in an executor is spun by another thread, and this one sleeps until the future or the shutdown wakes it. It
    # also looks again at short intervals, because the node may leave its executor during the wait: from then on nobody
    # would complete the future, and this thread must spin.
    ended = threading.Event()
    future.when_complete(ended.set)
    context = node.context
    context.add_shutdown_hook(ended.set)
    try:
        while context.ok() and not future.done():
            left_s = max(0.0, end_s - time.monotonic())
            if executor_of(node) is not None or not _spin_alone(node, future, left_s):
                ended.wait(min(left_s, LOOK_AGAIN_S))
            if end_s <= time.monotonic():
                break
    finally:
        context.remove_shutdown_hook(ended.set)


def _spin_alone(node: Any, future: Future[Any], timeout_s: float) -> bool:
    """Spin a node that is in no executor until a future is complete; return False if another wait spins it."""
    # Several threads may wait at once for a node in no executor. One of them spins, for all; the others wait for their
    # futures, and look again in case that the spinning one has its own result and leaves.
    with _lock:
        alone = _spinning.setdefault(node, threading.Lock())
    if not alone.acquire(blocking=False):
        return False
    try:
        with SingleThreadedExecutor(context=node.context) as executor:
            executor.add_node(node)
            executor.spin_until_future_complete(future, timeout_s)
    finally:
        alone.release()
    return True
