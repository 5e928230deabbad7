"""The topics of a graph as channels, which are read while clients subscribe to them."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from foxglove import Channel, Context, Schema

from tfloom.bag.qos_profiles import adapted
from tfloom.bag.writing.definition_text import find_definition
from tfloom.node.clock.clock import Clock
from tfloom.node.qos.qos import QoSProfile
from tfloom.node.values.time import ClockType
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, ReliabilityPolicy

if TYPE_CHECKING:
    from tfloom.foxglove.known_types import KnownTypes
    from tfloom.foxglove.settings import Settings
    from tfloom.node.endpoints.subscription import Subscription
    from tfloom.node.executing.timer import Timer
    from tfloom.node.node import Node

__all__ = ["Channels", "schema_of"]

MAX_CHANGES = 100
"""Number of channels that are opened or closed at once. Clients get a message for each, and the server closes the
connections of clients for which too many messages wait."""

KEPT_DEPTH = 1000
"""Least depth of a subscription to publishers that keep messages for late ones, all of which come at once; those on DDS
don't say how many they keep."""
BURST_S = 0.05
"""Period in which a quarter of a client's backlog is sent at most, of messages that publishers keep [s]."""


class Channels:
    """Keeps a channel for each topic and type. Used on the node's thread alone.

    Args:
        node: Subscribes to the topics.
        context: The SDK's, of the server.
        settings: Which topics clients see, and how they are read.
        types: Finds their types.
    """

    def __init__(self, node: Node, context: Context, settings: Settings, types: KnownTypes) -> None:
        self._node = node
        self._context = context
        self._settings = settings
        self._types = types
        self._channels: dict[tuple[str, str], _TopicChannel] = {}
        self._by_id: dict[int, _TopicChannel] = {}

    def update(self, topics: Iterable[tuple[str, str]], max_changes: int = MAX_CHANGES) -> bool:
        """Open channels of new topics, close those of gone ones, and follow changed qualities of service.

        Args:
            topics: Name and type of each topic of the graph.
            max_changes: Number of channels that may be opened or closed.

        Returns:
            Whether that is done; else, the rest is left to the next call.
        """
        topics = {topic for topic in topics if self._settings.shows(topic[0], self._settings.topics)}
        gone = [key for key in self._channels if key not in topics]
        new = {
            key: message_class
            for key in sorted(topics - self._channels.keys())
            if (message_class := self._types.find(key[1], "msg", f"{key[0]} is not shown")) is not None
        }
        for key in gone[:max_changes]:
            channel = self._channels.pop(key)
            del self._by_id[channel.id]
            channel.close()
        for key in list(new)[: max(0, max_changes - len(gone))]:
            opened = self._open(key[0], new[key])
            self._channels[key] = self._by_id[opened.id] = opened
        for channel in self._channels.values():
            channel.follow()
        return len(gone) + len(new) <= max_changes

    def _open(self, name: str, message_class: type[Any]) -> _TopicChannel:
        schema = schema_of(message_class._TYPE_NAME)
        channel = Channel(name, schema=schema, message_encoding="cdr", context=self._context)
        return _TopicChannel(self._node, channel, message_class, self._settings)

    def subscribe(self, client: int, channel_id: int) -> None:
        """Begin to read a channel for a client."""
        if (channel := self._by_id.get(channel_id)) is not None:
            channel.subscribe(client)

    def unsubscribe(self, client: int, channel_id: int) -> None:
        """End to read a channel for a client."""
        if (channel := self._by_id.get(channel_id)) is not None:
            channel.unsubscribe(client)

    def close(self) -> None:
        """Close all channels."""
        for channel in self._channels.values():
            channel.close()
        self._channels.clear()
        self._by_id.clear()


def schema_of(type_name: str) -> Schema:
    """Return the definition of a type, empty where it has none here."""
    definition = find_definition(type_name)
    encoding, text = ("ros2msg", "") if definition is None else (definition.encoding, definition.text)
    return Schema(name=type_name, encoding=encoding, data=text.encode())


class _TopicChannel:
    """A topic of one type, and the clients that read it."""

    def __init__(self, node: Node, channel: Channel, message_class: type[Any], settings: Settings) -> None:
        self.id = channel.id()
        self._node = node
        self._channel = channel
        self._topic = channel.topic()
        self._message_class = message_class
        self._settings = settings
        self._clients: set[int] = set()
        self._subscription: Subscription[Any] | None = None
        self._qos = QoSProfile(depth=1)
        self._waiting: deque[tuple[int, bytes]] = deque()
        """Time [ns] and data of kept messages that are not sent yet."""
        self._burst_s = 0.0
        """When the present burst of them began, on the monotonic clock [s]."""
        self._burst_count = 0
        self._timer: Timer | None = None
        """Sends what waits."""

    def subscribe(self, client: int) -> None:
        self._clients.add(client)
        # Publishers send kept messages to a new subscription alone, and this client needs them, too.
        if self._subscription is None or self._qos.durability is DurabilityPolicy.TRANSIENT_LOCAL:
            self._open()

    def unsubscribe(self, client: int) -> None:
        self._clients.discard(client)
        if not self._clients:
            self._close_subscription()
            self._forget_waiting()

    def follow(self) -> None:
        """Subscribe anew if the topic's publishers have changed so that this matters."""
        if self._subscription is not None:
            qos = self._wanted_qos()
            if (qos.reliability, qos.durability) != (self._qos.reliability, self._qos.durability):
                self._open()

    def _open(self) -> None:
        self._close_subscription()
        self._qos = self._wanted_qos()
        self._waiting = deque(self._waiting, maxlen=max(self._qos.depth, KEPT_DEPTH))
        self._subscription = self._node.create_subscription(
            self._message_class, self._topic, self._log, self._qos, raw=True
        )

    def _log(self, data: bytes) -> None:
        now_ns = self._node.get_clock().now().nanoseconds
        # What comes after publishers have changed their quality stays behind what waits.
        if self._waiting or self._qos.durability is DurabilityPolicy.TRANSIENT_LOCAL:
            self._waiting.append((now_ns, bytes(data)))
            self._send_waiting()
        else:
            self._channel.log(bytes(data), log_time=now_ns)

    def _send_waiting(self) -> None:
        # All kept messages of a topic come at once. The SDK drops the oldest of those that are more than a client's
        # backlog, which another thread sends; unlike others, these do not come again.
        now_s = time.monotonic()
        if now_s >= self._burst_s + BURST_S:
            self._burst_s, self._burst_count = now_s, 0
        while self._waiting and self._burst_count < max(1, self._settings.backlog // 4):
            self._burst_count += 1
            stamp_ns, data = self._waiting.popleft()
            self._channel.log(data, log_time=stamp_ns)
        if not self._waiting:
            self._end_timer()
        elif self._timer is None:
            clock = Clock(clock_type=ClockType.STEADY_TIME)
            self._timer = self._node.create_timer(BURST_S, self._send_waiting, clock=clock)

    def _end_timer(self) -> None:
        if self._timer is not None:
            self._node.destroy_timer(self._timer)
            self._timer = None

    def _wanted_qos(self) -> QoSProfile:
        """Return a quality of service that all publishers match, so reliable only if all of them are."""
        publishers = [
            info.qos_profile
            for info in self._node.get_publishers_info_by_topic(self._topic)
            if info.topic_type == self._message_class._TYPE_NAME
        ]
        requested = adapted([qos.as_stated() for qos in publishers])
        is_best_effort = self._topic in self._settings.best_effort_topics
        depth = max(sum(max(1, qos.depth) for qos in publishers), self._settings.min_depth)
        is_kept = requested.durability is DurabilityPolicy.TRANSIENT_LOCAL
        return QoSProfile(
            history=HistoryPolicy.KEEP_LAST,
            depth=max(depth, KEPT_DEPTH) if is_kept else min(depth, self._settings.max_depth),
            reliability=ReliabilityPolicy.BEST_EFFORT if is_best_effort else requested.reliability,
            durability=requested.durability,
        )

    def _close_subscription(self) -> None:
        if self._subscription is not None:
            self._node.destroy_subscription(self._subscription)
            self._subscription = None

    def _forget_waiting(self) -> None:
        self._waiting.clear()
        self._end_timer()

    def close(self) -> None:
        self._close_subscription()
        self._forget_waiting()
        self._channel.close()
