"""The publishers of a player: one for each topic, which publishes recorded bytes."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING

from tfloom.bag.bag import Bag
from tfloom.bag.playing.play_options import PlayOptions
from tfloom.bag.playing.played_goals import PlayedGoals
from tfloom.bag.playing.played_requests import PlayedRequests
from tfloom.bag.qos_profiles import offered, offers_differ
from tfloom.bag.topic_choice import action_of, is_service_event, service_of_event
from tfloom.bag.values import RawMessage, Topic
from tfloom.bag.writing.definition_text import hash_of
from tfloom.node.base.node_base import open_endpoint
from tfloom.rmw import base
from tfloom.rmw.qos import DurabilityPolicy, QoS, ReliabilityPolicy
from tfloom.rmw.typed_names import SERVICE_EVENTS

if TYPE_CHECKING:
    from tfloom.node.node import Node

__all__ = ["PlayedTopics"]

CLOCK = "/clock"


class PlayedTopics:
    """Publishes the messages of the wanted topics of a bag. One thread at a time uses it.

    Args:
        node: The node that publishes.
        bag: The bag.
        options: What is played.
        is_stopped: Returns whether playing was stopped, which ends waits for action servers.
    """

    def __init__(self, node: Node, bag: Bag, options: PlayOptions, is_stopped: Callable[[], bool]) -> None:
        self._node = node
        self._bag = bag
        self._options = options
        self._publishers: dict[str, _RawPublisher] = {}
        self._requests: dict[str, PlayedRequests] = {}
        self.goals = PlayedGoals(node, options.is_client_source, is_stopped) if options.sends_goals else None
        """The client of the recorded actions, if there is to be one; its `run` is called on a thread."""
        actions: list[Topic] = []
        publishes_clock = bool(options.clock_hz or options.clock_topics or options.is_clock_on_all)
        for topic in bag.topics.values():
            if topic.serialization_format != "cdr":
                node.get_logger().warning(
                    f"Topic '{topic.name}' has the format '{topic.serialization_format}', and is not played."
                )
            elif not self._is_wanted(topic) or (publishes_clock and topic.name == CLOCK):
                continue
            elif self.goals is not None and action_of(topic.name):
                actions.append(topic)
            else:
                self._add(topic)
        if self.goals is not None:
            self.goals.add(actions, options.remaps)
        self._warn_of_missing()

    def _warn_of_missing(self) -> None:
        """Name the wanted topics and services that the bag doesn't have, because nothing of them is played."""
        choice = self._options.choice
        topics = self._bag.topics
        missing = [f"topic '{name}'" for name in choice.topics if name not in topics]
        missing += [f"service '{name}'" for name in choice.services if name + SERVICE_EVENTS not in topics]
        for name in missing:
            self._node.get_logger().warning(
                f"The bag has no {name}, which is not played. It has: {', '.join(sorted(topics)) or 'no topics'}"
            )
        if not self.names and not missing:
            self._node.get_logger().warning("No topic of the bag is to be played.")

    @property
    def names(self) -> set[str]:
        """The topics, by their names in the bag."""
        return {*self._publishers, *self._requests, *(() if self.goals is None else self.goals.names)}

    def publish(self, message: RawMessage) -> None:
        """Publish a message of one of these topics, or send the request or the goal that it records."""
        publisher = self._publishers.get(message.topic)
        if publisher is not None:
            publisher.writer.write(message.data)
        elif (requests := self._requests.get(message.topic)) is not None:
            requests.send(message.data)
        elif self.goals is not None:
            self.goals.send(message.topic, message.data)

    def publish_kept(self, before_ns: int) -> None:
        """Publish what late subscriptions would have received at a time: the last messages of transient local topics.

        Args:
            before_ns: Messages with earlier log times count [ns since epoch].

        Raises:
            BagError: the bag can't be read.
        """
        # A publisher of the recording kept its last messages for late subscriptions. All that were published before the
        # time are read, of these topics alone, and a deque of the publisher's depth keeps what it would have kept.
        kept = {
            name: deque[RawMessage](maxlen=publisher.qos.depth)
            for name, publisher in self._publishers.items()
            if publisher.qos.durability == DurabilityPolicy.TRANSIENT_LOCAL
        }
        if not kept or before_ns <= self._bag.start_ns:
            return
        for message in self._bag.messages(list(kept), end_ns=before_ns - 1):
            kept[message.topic].append(message)
        for messages in kept.values():
            for message in messages:
                self.publish(message)

    def wait_for_acks(self, timeout_ms: int) -> bool:
        """Wait until all reliable subscriptions have acknowledged all messages; False on a timeout.

        Args:
            timeout_ms: The longest wait; 0: no limit.
        """
        # One timeout for all publishers. When it has passed, each of the others is still asked, without a wait.
        end = time.monotonic() + timeout_ms / 1e3
        are_acked = True
        for publisher in self._publishers.values():
            if publisher.qos.reliability == ReliabilityPolicy.RELIABLE:
                left_ns = -1 if timeout_ms == 0 else max(0, int((end - time.monotonic()) * 1e9))
                are_acked = publisher.writer.wait_for_acks(left_ns) and are_acked
        return are_acked

    def _is_wanted(self, topic: Topic) -> bool:
        return self._options.choice.wants(topic.name, topic.type)

    def _add(self, topic: Topic) -> None:
        if self._options.publishes_requests and is_service_event(topic.name, topic.type):
            service = self._options.remaps.get(service_of_event(topic.name), service_of_event(topic.name))
            self._requests[topic.name] = PlayedRequests(
                self._node, service, topic.type.removesuffix("_Event"), self._options.is_client_source
            )
            return
        override = self._options.qos_overrides.get(topic.name)
        if override is None and offers_differ(topic):
            self._node.get_logger().warning(
                f"Not all recorded publishers of '{topic.name}' offered the same QoS. The strongest is offered."
            )
        qos = offered(topic) if override is None else override.resolved()
        name = self._options.remaps.get(topic.name, topic.name)
        self._publishers[topic.name] = _RawPublisher(self._node, topic, name, qos)


class _RawPublisher:
    """A writer of serialized messages, which the node destroys."""

    def __init__(self, node: Node, topic: Topic, name: str, qos: QoS) -> None:
        wire_topic = base.Topic(name, topic.type, topic.type_hash or hash_of(topic.type))
        self.qos = qos
        self.writer = open_endpoint(
            node, self, lambda participant, node_name: participant.create_writer(node_name, wire_topic, qos)
        )

    def destroy(self) -> None:
        """Close the writer."""
        self.writer.close()
