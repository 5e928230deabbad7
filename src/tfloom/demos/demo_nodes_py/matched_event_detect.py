"""matched_event_detect: log the matched events of a publisher and a subscription."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.endpoints.subscription import Subscription
from tfloom.node.executing.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["MatchedEventDetectNode", "MultiPubNode", "MultiSubNode", "main"]

DEPTH = 10
PATIENCE_S = 10.0


class MatchedEventDetectNode(Node):
    """Logs the peers that match and leave its publisher and its subscription.

    Args:
        pub_topic_name: Topic of the publisher.
        sub_topic_name: Topic of the subscription.
    """

    def __init__(self, pub_topic_name: str, sub_topic_name: str) -> None:
        super().__init__("matched_event_detection_node")
        self._connected: set[str] = set()
        self._next: Future[bool] = Future()
        self.pub = self.create_publisher(
            String,
            pub_topic_name,
            DEPTH,
            event_callbacks=PublisherEventCallbacks(matched=partial(self._on_matched, "subscription")),
        )
        self.sub = self.create_subscription(
            String,
            sub_topic_name,
            _ignore,
            DEPTH,
            event_callbacks=SubscriptionEventCallbacks(matched=partial(self._on_matched, "publisher")),
        )

    def _on_matched(self, other: str, info: Any) -> None:
        log = self.get_logger().info
        if other not in self._connected:
            if info.current_count:
                self._connected.add(other)
                log(f"First {other} is connected.")
        elif info.current_count:
            log(
                f"The changed number of connected {other} is {info.current_count_change} and "
                f"current number of connected {other} is {info.current_count}"
            )
        else:
            self._connected.remove(other)
            log(f"Last {other} is disconnected.")
        self._next.set_result(True)

    def get_future(self) -> Future[bool]:
        """Return a future that the next change completes."""
        self._next = Future()
        return self._next


class MultiSubNode(Node):
    """Has any number of subscriptions to a topic."""

    def __init__(self, topic_name: str) -> None:
        super().__init__("multi_sub_node")
        self._topic_name = topic_name

    def create_one_sub(self) -> Subscription[String]:
        """Add a subscription."""
        self.get_logger().info("Create a new subscription.")
        return self.create_subscription(String, self._topic_name, _ignore, DEPTH)

    def destroy_one_sub(self, sub: Subscription[String]) -> None:
        """Remove a subscription."""
        self.get_logger().info("Destroy a subscription.")
        self.destroy_subscription(sub)


class MultiPubNode(Node):
    """Has any number of publishers on a topic."""

    def __init__(self, topic_name: str) -> None:
        super().__init__("multi_pub_node")
        self._topic_name = topic_name

    def create_one_pub(self) -> Publisher[String]:
        """Add a publisher."""
        self.get_logger().info("Create a new publisher.")
        return self.create_publisher(String, self._topic_name, DEPTH)

    def destroy_one_pub(self, pub: Publisher[String]) -> None:
        """Remove a publisher."""
        self.get_logger().info("Destroy a publisher.")
        self.destroy_publisher(pub)


def _ignore(_: String) -> None:
    """Ignore the message, because its content is irrelevant here."""


def run() -> None:
    """Add and remove two subscriptions, then two publishers; each step waits for its event."""
    topics = "pub_topic_matched_event_detect", "sub_topic_matched_event_detect"
    with SingleThreadedExecutor() as executor:
        detector = MatchedEventDetectNode(*topics)
        subscriber, publisher = MultiSubNode(topics[0]), MultiPubNode(topics[1])
        for node in (detector, subscriber, publisher):
            executor.add_node(node)

        def step(change: Callable[..., Any], *args: Any) -> Any:
            future = detector.get_future()
            outcome = change(*args)
            executor.spin_until_future_complete(future, PATIENCE_S)
            return outcome

        subscriptions = [step(subscriber.create_one_sub) for _ in range(2)]
        for subscription in subscriptions:
            step(subscriber.destroy_one_sub, subscription)
        publishers = [step(publisher.create_one_pub) for _ in range(2)]
        for open_publisher in publishers:
            step(publisher.destroy_one_pub, open_publisher)


def main(args: list[str] | None = None) -> int:
    """Show the events; return the exit code."""
    expect_no_arguments("matched_event_detect", "Log the matched events of endpoints of two topics.", args)
    return run_program(args, run)
