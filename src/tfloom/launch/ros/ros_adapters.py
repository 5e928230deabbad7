"""The node of a launch, by which its actions call services, subscribe and time; it is created on first use."""

from __future__ import annotations

import contextlib
import os
import threading
from typing import TYPE_CHECKING

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.events.event_handlers import OnShutdown

if TYPE_CHECKING:
    from tfloom.node.context.context import Context
    from tfloom.node.executing.executors import SingleThreadedExecutor
    from tfloom.node.node import Node

__all__ = ["ROSAdapter", "get_ros_adapter", "get_ros_node"]

_KEY = "ros_adapter"


class ROSAdapter:
    """A node that a separate thread spins.

    Args:
        argv: ROS arguments of the node's context; None: those of the command line.
        autostart: Whether it starts at once.
    """

    def __init__(self, *, argv: list[str] | None = None, autostart: bool = True) -> None:
        self._argv = argv
        self._context: Context | None = None
        self._node: Node | None = None
        self._executor: SingleThreadedExecutor | None = None
        self._thread: threading.Thread | None = None
        if autostart:
            self.start()

    @property
    def argv(self) -> list[str] | None:
        """ROS arguments of the node's context."""
        return self._argv

    @property
    def ros_context(self) -> Context | None:
        """Context of the node; None while it doesn't run."""
        return self._context

    @property
    def ros_node(self) -> Node | None:
        """The node; None while it doesn't run."""
        return self._node

    @property
    def ros_executor(self) -> SingleThreadedExecutor | None:
        """Executor of the node; None while it doesn't run."""
        return self._executor

    def start(self) -> None:
        """Create the node, and spin it.

        Raises:
            RuntimeError: it is running.
        """
        if self._thread is not None:
            raise RuntimeError("Cannot start a ROS adapter that is already running")
        # A launch without lifecycle nodes and ROS timers has no node, and loads none.
        from tfloom.node.context.context import Context
        from tfloom.node.executing.executors import SingleThreadedExecutor
        from tfloom.node.node import Node

        self._context = Context()
        self._context.init(args=self._argv)
        self._node = Node(f"launch_ros_{os.getpid()}", context=self._context)
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self._node)
        thread = threading.Thread(target=_spin, args=(self._executor,), name="launch_ros", daemon=True)
        try:
            thread.start()
        except RuntimeError as error:
            self._destroy()
            raise RuntimeError(f"the launch's node has no thread: {error}") from error
        self._thread = thread

    def shutdown(self) -> None:
        """Destroy the node.

        Raises:
            RuntimeError: it doesn't run.
        """
        if self._thread is None or self._context is None or self._executor is None or self._node is None:
            raise RuntimeError("Cannot shutdown a ROS adapter that is not running")
        # The thread ends before the node is destroyed, so that no callback runs with a node that is gone.
        self._executor.shutdown()
        self._thread.join()
        self._destroy()

    def _destroy(self) -> None:
        if self._executor is not None:
            self._executor.shutdown()
        if self._node is not None:
            self._node.destroy_node()
        if self._context is not None:
            self._context.try_shutdown()
        self._thread = self._executor = self._node = self._context = None


def _spin(executor: SingleThreadedExecutor) -> None:
    from tfloom.node.values.exceptions import ShutdownException

    with contextlib.suppress(ShutdownException):
        executor.spin_on_own_thread()


def get_ros_node(context: LaunchContext) -> Node:
    """Return the node of a launch, which is created on first use and destroyed at the shutdown.

    Raises:
        RuntimeError: the launch has been shut down.
    """
    node = get_ros_adapter(context).ros_node
    if node is None:
        raise RuntimeError("the launch has been shut down, and with it its node")
    return node


def get_ros_adapter(context: LaunchContext) -> ROSAdapter:
    """Return the adapter of a launch, which is created on first use and ended at the shutdown."""
    adapter: ROSAdapter | None = context.get_locals_as_dict().get(_KEY)
    if adapter is None:
        # A launch's own arguments, `name:=value`, are not remap rules of its node.
        argv = context.argv
        rules = [word for index, word in enumerate(argv) if ":=" not in word or "--ros-args" in argv[:index]]
        adapter = ROSAdapter(argv=rules)
        context.extend_globals({_KEY: adapter})
        end = adapter.shutdown
        context.register_event_handler(OnShutdown(on_shutdown=lambda *_: end()))
    return adapter
