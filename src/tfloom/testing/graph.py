"""A graph for one test: nodes that the test's own thread spins, and what is waited for on it."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from tfloom.node.values.exceptions import TimeoutException
from tfloom.testing.diagnosis import why_no_message, why_not_spun

if TYPE_CHECKING:
    from tfloom.node.context.context import Context
    from tfloom.node.endpoints.subscription import Subscription

__all__ = ["NotSeenError", "RosGraph"]

AnyNode = TypeVar("AnyNode", bound=Node)

__tracebackhide__ = True  # pytest shows a failure where the test waits

MAX_NAP_S = 0.02
"""How often a condition is checked that another thread may fulfil [s]."""
DEPTH = 1000
"""Messages that may wait for the test's own callbacks."""
BEST_OFFERED = QoSProfile(
    depth=DEPTH,
    reliability=ReliabilityPolicy.BEST_AVAILABLE,
    durability=DurabilityPolicy.BEST_AVAILABLE,
)
LEAST = QoSProfile(
    depth=DEPTH, reliability=ReliabilityPolicy.BEST_EFFORT, durability=DurabilityPolicy.VOLATILE
)
MAX_CALLBACKS = 100_000
"""Callbacks that may follow one another without a pause before the graph counts as one that never rests."""


class NotSeenError(AssertionError):
    """What a test waited for did not happen in time; the text has the likely reason."""


class RosGraph:
    """The nodes of one test, which run while one of the methods below waits. Not for use by several threads.

    Args:
        context: The initialised context of all nodes.
    """

    def __init__(self, context: Context) -> None:
        self.context = context
        self.executor = SingleThreadedExecutor(context=context)
        self._observer: Node | None = None
        self._on_add: list[Callable[[], None]] = []

    @property
    def observer(self) -> Node:
        """A node without services, for the test's own endpoints."""
        if self._observer is None:
            node = Node(
                "test_observer", context=self.context, enable_rosout=False, start_parameter_services=False
            )
            self._observer = node
            self.executor.add_node(node)
        return self._observer

    def add(self, node: AnyNode) -> AnyNode:
        """Spin a node from now on, and return it; it is destroyed at the end of the test.

        Raises:
            TypeError: `node` is not a node, as the class of one.
            ValueError: the node is of another context, as one that was created before the fixture.
        """
        if not isinstance(node, Node):
            what = f"the class {node.__name__}: create a node of it" if isinstance(node, type) else repr(node)
            raise TypeError(f"ros_graph.add takes a node, not {what}")
        if node.context is not self.context:
            raise ValueError(
                f"the node {node.get_fully_qualified_name()} is of another context than this test's: "
                "create it in the test, after its fixtures, and without its own context"
            )
        self.executor.add_node(node)
        for call in self._on_add:
            call()
        return node

    def create_node(self, name: str, **options: Any) -> Node:
        """Return a new node that is spun, with the options of `Node`."""
        return self.add(Node(name, context=self.context, **options))

    def when_added(self, call: Callable[[], None]) -> None:
        """Call a function each time a node was added."""
        self._on_add.append(call)

    def spin_until(self, condition: Callable[[], object], timeout_s: float = 5.0, what: str = "") -> None:
        """Run callbacks until `condition()` is true.

        Args:
            condition: Called after each callback, as `future.done`, or `lambda: len(received) > 2`.
            timeout_s: The longest wait, by the wall clock [s].
            what: What is waited for, for the error.

        Raises:
            NotSeenError: it was not true in time.
            Exception: raised by a callback.
        """
        if not callable(condition):
            raise TypeError(f"spin_until takes a function that returns whether to stop, not {condition!r}")
        if not self._spins_until(condition, timeout_s):
            if not self.context.ok():
                raise NotSeenError(f"rclpy was shut down during the wait for {what or 'a condition'}")
            raise NotSeenError(
                f"gave up after {timeout_s:g} s waiting for {what or 'a condition'}{why_not_spun(self.observer)}"
            )

    def _spins_until(self, condition: Callable[[], object], timeout_s: float) -> bool:
        end = time.monotonic() + timeout_s
        while not condition():
            left_s = end - time.monotonic()
            if left_s <= 0 or not self.context.ok():
                return False
            self.executor.spin_once(timeout_sec=min(left_s, MAX_NAP_S))
        return True

    def spin_until_idle(self) -> None:
        """Run callbacks until none is ready. Timers that are due later, by the wall clock, don't count.

        On DDS, what is on its way does not count.

        Raises:
            NotSeenError: callbacks cause one another without end.
            Exception: raised by a callback.
        """
        for _ in range(MAX_CALLBACKS):
            try:
                task, _entity, _node = self.executor.wait_for_ready_callbacks(timeout_sec=0.0)
            except TimeoutException:
                return
            task()
            if task.done() and (error := task.exception()) is not None:
                raise error
        raise NotSeenError(
            f"callbacks have caused one another {MAX_CALLBACKS} times without a pause: use spin_until with a condition"
        )

    def collect(
        self, msg_type: type[Any], topic: str, qos_profile: QoSProfile | int | None = None
    ) -> list[Any]:
        """Return a list to which each message of a topic is appended from now on.

        Args:
            msg_type: Class of the messages.
            topic: Name of the topic.
            qos_profile: QoS of the subscription; None: the best that all present publishers offer, or, without one, the
                least, which matches any.
        """
        messages: list[Any] = []
        self._subscribe(msg_type, topic, messages.append, qos_profile)
        return messages

    def wait_for_message(
        self,
        msg_type: type[Any],
        topic: str,
        timeout_s: float = 5.0,
        *,
        qos_profile: QoSProfile | int | None = None,
        where: Callable[[Any], object] | None = None,
    ) -> Any:
        """Run callbacks until a message is received, and return it.

        Args:
            msg_type: Class of the message.
            topic: Name of the topic.
            timeout_s: The longest wait, by the wall clock [s].
            qos_profile: QoS of the subscription; None: the best that all present publishers offer, or, without one, the
                least, which matches any.
            where: Whether a message is the one; None: the first is.

        Raises:
            NotSeenError: none was received in time; the text has what is on the topic instead.
            Exception: raised by a callback.
        """
        messages: list[Any] = []
        matches: list[Any] = []

        def on_message(message: Any) -> None:
            messages.append(message)
            if where is None or where(message):
                matches.append(message)

        subscription = self._subscribe(msg_type, topic, on_message, qos_profile)
        try:
            if self._spins_until(lambda: matches, timeout_s):
                return matches[0]
            reason = why_no_message(self.observer, subscription, msg_type, messages)
            name = subscription.topic_name
        finally:
            self.observer.destroy_subscription(subscription)
        raise NotSeenError(f"no message on {name} within {timeout_s:g} s: {reason}")

    def _subscribe(
        self,
        msg_type: type[Any],
        topic: str,
        callback: Callable[[Any], None],
        qos_profile: QoSProfile | int | None,
    ) -> Subscription[Any]:
        if qos_profile is None:
            qos_profile = BEST_OFFERED if self.observer.count_publishers(topic) else LEAST
        return self.observer.create_subscription(msg_type, topic, callback, qos_profile)

    def broadcast(self, table: str) -> None:
        """Publish the transforms of a table on /tf and /tf_static, and run callbacks until none is ready.

        Args:
            table: As described in `tfloom.testing.transform_table`.

        Raises:
            TableError: the table is malformed.
        """
        from tfloom.testing.transform_table import messages_of, read_table
        from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
        from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster

        rows = read_table(table)
        StaticTransformBroadcaster(self.observer).send_transform(messages_of(rows, static=True))
        moving = TransformBroadcaster(self.observer)
        for message in messages_of(rows, static=False):
            moving.send_transform(message)
        self.spin_until_idle()

    def close(self) -> None:
        """Destroy all nodes that were added."""
        nodes = self.executor.get_nodes()
        self.executor.shutdown(timeout_sec=5.0)
        for node in nodes:
            node.destroy_node()
