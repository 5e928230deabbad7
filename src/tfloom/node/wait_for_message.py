"""Wait for one message of a topic."""

from __future__ import annotations

import math
import time
from typing import TYPE_CHECKING, Any

from tfloom.common.seconds import checked_timeout
from tfloom.node.executing.callback_groups import MutuallyExclusiveCallbackGroup
from tfloom.node.executing.executor import executor_of
from tfloom.node.executing.lone_spin import wait_for_future
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

    A node that is in no executor is spun here during the wait; several threads may wait at once. Otherwise another
    thread must spin it, so this must not be called from one of its callbacks.

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
        wait_for_future(
            node, future, math.inf if timeout_s is None or timeout_s < 0 else time.monotonic() + timeout_s
        )
    finally:
        node.destroy_subscription(subscription)
    return future.done(), future.result()
