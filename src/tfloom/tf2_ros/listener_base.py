"""The part of a TransformListener that doesn't depend on whose node subscribes."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from tfloom.node.clock.time_jump import ClockChange
from tfloom.tf2_ros.buffer_core import BufferCore

if TYPE_CHECKING:
    from tfloom._native import TfSink

__all__ = ["AUTHORITY", "ListenerBase"]

AUTHORITY = "default_authority"
"""Name under which a listener inserts transforms, as tf2 names it."""
JOIN_TIMEOUT_S = 2.0


class ListenerBase:
    """Inserts the transforms of messages into a buffer, and may spin its node on a thread.

    Derived classes subscribe, of a node of tfloom or of a real rclpy.
    """

    node: Any
    _buffer: Any

    def __init__(self) -> None:
        self.executor: Any = None
        self.dedicated_listener_thread: threading.Thread | None = None
        self._sink: TfSink | None = None
        """The sink of moving transforms, where the wire passes them directly."""
        self._jump_handle: Any = None

    def callback(self, data: Any) -> None:
        """Insert the transforms of a message into the buffer."""
        for transform in data.transforms:
            self._buffer.set_transform(transform, AUTHORITY)

    def static_callback(self, data: Any) -> None:
        """Insert the transforms of a message into the buffer, as static ones."""
        for transform in data.transforms:
            self._buffer.set_transform_static(transform, AUTHORITY)

    def unregister(self) -> None:
        """Destroy the subscriptions. The buffer keeps its content."""
        raise NotImplementedError

    def _is_direct(self, *, is_static: bool) -> bool:
        """Return whether the wire may pass transforms directly to the buffer: nothing in between is overridden."""
        callback = "static_callback" if is_static else "callback"
        setter = "set_transform_static" if is_static else "set_transform"
        return (
            isinstance(self._buffer, BufferCore)
            and getattr(type(self._buffer), setter) is getattr(BufferCore, setter)
            and setter not in vars(self._buffer)
            and getattr(type(self), callback) is getattr(ListenerBase, callback)
        )

    def _simulated_ns(self) -> int | None:
        """Return the node's simulated time [ns]; None where its clock returns the system's."""
        raise NotImplementedError

    def _on_jump(self, jump: Any) -> None:
        """Tell the sink the node's new time."""
        sink = self._sink
        if sink is None:
            return
        sink.set_simulated_time(self._simulated_ns())
        # What is held was far ahead of the time before the jump, which says nothing of the time after it.
        if int(jump.clock_change) != ClockChange.ROS_TIME_NO_CHANGE or jump.delta.nanoseconds < 0:
            sink.forget_all()

    def _spin(self, executor: Any, run: Callable[[], None]) -> None:
        """Spin the node in an executor by `run()`, on a thread.

        Raises:
            RuntimeError: the thread can't be started. The listener is unregistered, and the node is in the executor in
                which it was before.
        """
        # `add_node` takes the node from the executor in which it is. If no thread can be started, nobody would spin
        # this executor, so the node goes back to the former one.
        before = self.node.executor
        if before is not None and self.node not in before.get_nodes():
            before = None  # `Node.executor` is also one that the node was removed from
        executor.add_node(self.node)
        thread = threading.Thread(target=run, name="tf_listener", daemon=True)
        try:
            thread.start()
        except RuntimeError as error:
            executor.shutdown()
            self.unregister()
            if before is not None:
                before.add_node(self.node)
            raise RuntimeError(
                f"a TransformListener with spin_thread=True needs a thread: {error}"
            ) from error
        self.executor = executor
        self.dedicated_listener_thread = thread

    def __del__(self) -> None:
        # Runs on any thread, at any time, perhaps after a failed __init__ or at the interpreter's end.
        with suppress(Exception):
            if self.executor is not None:
                self.executor.shutdown(0)
            thread = self.dedicated_listener_thread
            if thread is not None and thread is not threading.current_thread():
                thread.join(JOIN_TIMEOUT_S)
            self.unregister()
