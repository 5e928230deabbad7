"""A node that is spun on a separate thread, so that a test need not."""

from __future__ import annotations

import threading

from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.values.callback_errors import report_exception
from tfloom.node.values.exceptions import ExternalShutdownException

__all__ = ["MessagePump"]


class MessagePump:
    """Spins a node on a thread, from `start` to `stop`.

    Args:
        node: The node.
        context: That of the node; None for the default one.
    """

    def __init__(self, node: Node, context: Context | None = None) -> None:
        self._node = node
        self._executor = SingleThreadedExecutor(context=context or node.context)
        self._executor.add_node(node)
        self._thread = threading.Thread(target=self._run, name="message pump", daemon=True)
        self._is_to_end = threading.Event()

    def start(self) -> None:
        """Start to spin."""
        self._thread.start()

    def stop(self) -> None:
        """End spinning, and return when it has ended.

        Raises:
            Exception: a callback did not return in 5 s.
        """
        self._is_to_end.set()
        self._executor.wake()
        if self._thread.ident is not None:  # else it was not started
            self._thread.join(timeout=5.0)
        if self._thread.is_alive():
            raise Exception("Timed out waiting for message pump to stop")
        self._executor.shutdown()

    def _run(self) -> None:
        while not self._is_to_end.is_set():
            try:
                self._executor.spin_once(timeout_sec=1.0)
            except ExternalShutdownException:
                return
            except Exception:  # of one of the test's callbacks; the others go on
                report_exception()
