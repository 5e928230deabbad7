"""What small programs of kinds share: nodes that a thread spins, waiting for conditions, and the warnings of a call."""

from __future__ import annotations

import contextlib
import time
import warnings
from collections.abc import Callable
from threading import Thread
from typing import Any

WAIT_S = 15.0


class Stage:
    """A context, and its nodes, which a thread spins inside the block.

    Args:
        arguments: Of the command line, as `--ros-args`.
        spins: Whether a thread spins; otherwise the program does.
    """

    def __init__(self, *arguments: str, spins: bool = True) -> None:
        import rclpy
        from rclpy.executors import MultiThreadedExecutor

        self.context = rclpy.Context()
        rclpy.init(args=["program", *arguments], context=self.context)
        self.executor = MultiThreadedExecutor(4, context=self.context)
        self.nodes: list[Any] = []
        self._thread = Thread(target=self._spin, daemon=True) if spins else None

    def node(self, name: str, kind: Any = None, **options: Any) -> Any:
        """Return a new node, of a class of its own if one is given."""
        from rclpy.node import Node

        self.nodes.append((kind or Node)(name, context=self.context, **options))
        if self._thread is not None:
            self.executor.add_node(self.nodes[-1])
        return self.nodes[-1]

    def _spin(self) -> None:
        from rclpy.executors import ExternalShutdownException

        with contextlib.suppress(ExternalShutdownException):
            self.executor.spin()

    def __enter__(self) -> Stage:  # noqa: PYI034  # the peer's Python has no typing_extensions
        if self._thread is not None:
            self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.executor.shutdown(timeout_sec=WAIT_S)
        if self._thread is not None:
            self._thread.join(WAIT_S)
        for node in self.nodes:
            node.destroy_node()
        self.context.try_shutdown()


def until(condition: Callable[[], Any]) -> Any:
    """Wait until a condition holds; return what it then is."""
    end_s = time.monotonic() + WAIT_S
    while not (value := condition()):
        if time.monotonic() > end_s:
            raise TimeoutError("the condition did not hold in time")
        time.sleep(0.005)
    return value


def result_of(future: Any) -> Any:
    """Return the result of a future that another thread completes."""
    until(future.done)
    return future.result()


def outcome(call: Callable[[], Any]) -> list[Any]:
    """Return what a call returns or raises, and the warnings that it gives, as texts."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            value = call()
        except Exception as error:  # noqa: BLE001  # it is the outcome
            value = f"{type(error).__name__}: {error}"
    return [value, [f"{warning.category.__name__}: {warning.message}" for warning in caught]]
