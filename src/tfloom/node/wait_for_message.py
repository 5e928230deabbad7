"""Wait for one message of a topic."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from tfloom.common.seconds import checked_timeout
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup
from tfloom.node.executing.executor import executor_of
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.qos.qos import QoSProfile

if TYPE_CHECKING:
    from tfloom.node.node import Node

__all__ = ["wait_for_message"]


def wait_for_message(
    msg_type: Any,
    node: Node,
    topic: str,
    *,
    qos_profile: QoSProfile | int = 1,
    time_to_wait: float = -1,
) -> tuple[bool, Any]:
    """Wait for the next message of a topic.

    A node that is in no executor is spun here during the wait. Otherwise another thread must spin it, so this must
    not be called from one of its callbacks.

    Args:
        msg_type: Class of the message.
        node: The node that subscribes.
        topic: Name of the topic.
        qos_profile: QoS of the subscription; a number is the depth of a KEEP_LAST history.
        time_to_wait: The longest wait [s]; negative: no limit.

    Returns:
        (True, the message), or (False, None) if none arrived in time or before shutdown.

    Raises:
        TypeError: `time_to_wait` is not a number.
        ValueError: it is NaN.
        RuntimeError: called from a callback of a single-threaded executor, which would block its own thread.
    """
    timeout_s = checked_timeout("wait_for_message", time_to_wait)
    future: Future[Any] = Future()

    def on_message(message: Any) -> None:
        if not future.done():
            future.set_result(message)

    executor = executor_of(node)
    if executor is not None and executor.would_wait_for_itself():
        raise RuntimeError(
            f"wait_for_message on {topic} in a callback would block the thread that receives messages"
        )
    subscription = node.create_subscription(
        msg_type, topic, on_message, qos_profile, callback_group=MutuallyExclusiveCallbackGroup()
    )
    try:
        # In an executor, the node is spun by another thread, and this one only waits. Otherwise nothing would call the
        # callback, so the node is spun here.
        if executor is not None:
            _wait_for_future(future, timeout_s, node)
        else:
            with SingleThreadedExecutor(context=node.context) as own:
                own.add_node(node)
                own.spin_until_future_complete(future, timeout_s)
    finally:
        node.destroy_subscription(subscription)
    return future.done(), future.result()


def _wait_for_future(future: Future[Any], timeout_s: float | None, node: Node) -> None:
    ended = threading.Event()
    future.when_complete(ended.set)
    node.context.add_shutdown_hook(ended.set)
    try:
        ended.wait(None if timeout_s is None or timeout_s < 0 else timeout_s)
    finally:
        node.context.remove_shutdown_hook(ended.set)
