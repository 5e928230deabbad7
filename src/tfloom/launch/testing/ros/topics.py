"""Topics in tests of launches: a thread that spins nodes, a node that republishes, and a wait for messages."""

from __future__ import annotations

import random
import string
import threading
from collections import deque
from collections.abc import Callable, Iterable
from types import TracebackType
from typing import Any

from tfloom.common.seconds import checked_timeout
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import QoSProfile
from tfloom.node.values.callback_errors import report_exception
from tfloom.node.values.exceptions import ExternalShutdownException

__all__ = ["DataRepublisher", "MessagePump", "WaitForTopics"]

_DEPTH = 10


class DataRepublisher:
    """Publishes each message of a topic on another, as a function returns it.

    Args:
        node: Has the publisher and the subscription; something has to spin it.
        listen_topic: Topic of the messages.
        publish_topic: Topic of the changed ones.
        msg_type: Class of both.
        transform_fn: Takes a message and returns one, or None to drop it; called on the thread that spins the node.
    """

    def __init__(
        self,
        node: Node,
        listen_topic: str,
        publish_topic: str,
        msg_type: type[Any],
        transform_fn: Callable[[Any], Any],
    ) -> None:
        self._node = node
        self._transform = transform_fn
        self._num_received = 0
        self._republished: list[Any] = []
        self._publisher = node.create_publisher(msg_type, publish_topic, _DEPTH)
        self._subscription = node.create_subscription(msg_type, listen_topic, self._receive, _DEPTH)

    def shutdown(self) -> None:
        """End it, with its publisher and its subscription."""
        self._node.destroy_subscription(self._subscription)
        self._node.destroy_publisher(self._publisher)

    def get_num_received(self) -> int:
        """Return the number of messages that have come."""
        return self._num_received

    def get_num_republished(self) -> int:
        """Return the number of messages that were published, without those that were dropped."""
        return len(self._republished)

    def get_republished(self) -> list[Any]:
        """Return the messages that were published."""
        return list(self._republished)

    def _receive(self, message: Any) -> None:
        self._num_received += 1
        changed = self._transform(message)
        if changed:
            self._publisher.publish(changed)
            self._republished.append(changed)


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


class WaitForTopics:
    """Waits for at least one message on each of some topics.

    As a context manager it waits at the beginning of the block, and ends at its end; otherwise call `wait` and
    `shutdown`. It has its own context and node, in the domain of ROS_DOMAIN_ID.

    Args:
        topic_tuples: A topic's name and its message class, for each topic.
        timeout: [s].
        messages_received_buffer_length: Number of messages that are kept for each topic.
        trigger: Called with the node when it listens, to start what publishes; also with the arguments of `wait`.
        node_namespace: Namespace of the node; None for the root.
        qos_profile: QoS of the subscriptions, or their depth.

    Raises:
        RuntimeError: in a `with` statement, a topic has no message in time.
    """

    def __init__(
        self,
        topic_tuples: Iterable[tuple[str, type[Any]]],
        timeout: float = 5.0,
        messages_received_buffer_length: int = 10,
        trigger: Callable[..., object] | None = None,
        node_namespace: str | None = None,
        qos_profile: QoSProfile | int = 10,
    ) -> None:
        self.topic_tuples = list(topic_tuples)
        self.timeout = timeout
        checked_timeout("WaitForTopics", timeout)
        self.messages_received_buffer_length = messages_received_buffer_length
        if trigger is not None and not callable(trigger):
            raise TypeError(f"trigger must be a function, and is {trigger!r}")
        self._trigger = trigger
        self._changed = threading.Condition()
        self._received: dict[str, deque[Any]] = {}  # guarded by _changed
        self._context = Context()
        self._context.init()
        suffix = "".join(random.choices(string.ascii_lowercase + string.digits, k=10))  # noqa: S311  # a name
        self._node = Node(f"_test_node_{suffix}", namespace=node_namespace, context=self._context)
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self._node)
        self._qos_profile = qos_profile
        self._is_shut_down = False
        self._is_subscribed = False
        self._thread = threading.Thread(target=self._executor.spin, name="wait for topics", daemon=True)

    def wait(self, *args: Any, **kwargs: Any) -> bool:
        """Wait; return whether each topic has had a message.

        Args:
            args: Further arguments of `trigger`.
            kwargs: The same, by name.
        """
        timeout_s = checked_timeout("WaitForTopics", self.timeout)
        if not self._is_subscribed:
            self._is_subscribed = True
            for topic, kind in self.topic_tuples:
                self._node.create_subscription(kind, topic, self._receiver(topic), self._qos_profile)
            self._thread.start()
        if self._trigger is not None:
            self._trigger(self._node, *args, **kwargs)
        with self._changed:
            return self._changed.wait_for(lambda: not self.topics_not_received(), timeout_s)

    def shutdown(self) -> None:
        """End the node; calling it again does nothing."""
        if self._is_shut_down:
            return
        self._is_shut_down = True
        self._executor.shutdown()
        if self._thread.is_alive():
            self._thread.join()
        self._node.destroy_node()
        self._context.try_shutdown()

    def topics_received(self) -> set[str]:
        """Return the topics that have had a message."""
        return {topic for topic, _ in self.topic_tuples if topic in self._received}

    def topics_not_received(self) -> set[str]:
        """Return the topics that have had none."""
        return {topic for topic, _ in self.topic_tuples} - self.topics_received()

    def received_messages(self, topic_name: str) -> list[Any]:
        """Return the last messages of a topic, the newest last.

        Raises:
            KeyError: the topic is none of those that are waited for.
        """
        topic_names = [topic for topic, _ in self.topic_tuples]
        if topic_name not in topic_names:
            raise KeyError(f"No topic '{topic_name}' is waited for; those are: {', '.join(topic_names)}")
        with self._changed:
            return list(self._received.get(topic_name, ()))

    def __enter__(self) -> WaitForTopics:  # noqa: PYI034  # Python 3.10 has no Self
        try:
            has_all = self.wait()
        except BaseException:
            self.shutdown()
            raise
        if not has_all:
            missing = ", ".join(sorted(self.topics_not_received()))
            self.shutdown()
            raise RuntimeError(f"Did not receive messages on these topics: {missing}")
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.shutdown()

    def _receiver(self, topic: str) -> Callable[[Any], None]:
        def receive(message: Any) -> None:
            with self._changed:
                kept = self._received.setdefault(topic, deque(maxlen=self.messages_received_buffer_length))
                kept.append(message)
                self._changed.notify_all()

        return receive
