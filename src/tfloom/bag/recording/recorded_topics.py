"""The topics of a recording: which ones appear, and the readers that feed them into the writer."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from tfloom.bag.qos_profiles import adapted, profiles_text, unmet_policies, warnings_of
from tfloom.bag.topic_choice import TopicChoice, is_service_event
from tfloom.bag.values import Topic
from tfloom.bag.writing.bag_writer import BagWriter
from tfloom.bag.writing.definition_text import find_definition, hash_of
from tfloom.node.base.node_base import open_endpoint
from tfloom.node.log.logging import get_logger
from tfloom.rmw import base
from tfloom.rmw.errors import ClosedError, UnsupportedEventError
from tfloom.rmw.events import Count, Event
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, QoS

if TYPE_CHECKING:
    from tfloom.node.node import Node

__all__ = ["RecordOptions", "RecordedTopics"]


@dataclass
class RecordOptions:
    """The options of a recorder; the bag's are in `WriterSettings`."""

    choice: TopicChoice = field(default_factory=TopicChoice)
    is_discovery_disabled: bool = False
    """Whether only topics are recorded that exist at the start."""
    polling_interval_s: float = 0.1
    include_hidden_topics: bool = False
    include_unpublished_topics: bool = False
    ignore_leaf_topics: bool = False
    """Whether topics without a subscription, but for the recorder's own, are left out."""
    qos_overrides: Mapping[str, QoS] = field(default_factory=dict)
    """The subscriptions' profiles, by topic."""
    is_start_paused: bool = False
    use_sim_time: bool = False
    has_keyboard: bool = True
    static_topics: Mapping[str, str] = field(default_factory=dict)
    """Types by topics that are recorded from the start on, whether or not anybody publishes."""
    losses_hz: float = 0.0
    """How often it is published at most which messages were lost [Hz]; 0: never."""
    repeated: Mapping[str, int] = field(default_factory=dict)
    """By topic, how many of its last messages each further file and each snapshot begins with."""
    repeats_all: int = 0
    """The same for all other topics whose publishers are transient local; 0: none."""


MAX_SEARCHES = 5
"""How often a definition is searched for again, where no node had one."""
SEARCH_S = 1.0
"""Time between two searches [s]."""


class _TopicInfo:
    """What the graph says of one topic."""

    def __init__(self) -> None:
        self.types: dict[str, str] = {}
        """Hashes by types."""
        self.writers: list[base.EndpointInfo] = []
        self.has_subscription = False


class _Recorded:
    """A topic that is recorded. It is an endpoint of the node, which destroys it."""

    def __init__(self, qos: QoS, number: int) -> None:
        self.qos = qos
        self.number = number
        """Of its channel."""
        self.reader: base.Reader | None = None
        self.refused: set[bytes] = set()
        self.lost = 0

    def destroy(self) -> None:
        """Close the reader, and keep how many messages it has lost."""
        if self.reader is not None:
            self.lost = self.count_lost()
            self.reader.close()
            self.reader = None

    def count_lost(self) -> int:
        """Return how many messages the wire has lost."""
        if self.reader is None:
            return self.lost
        try:
            status = self.reader.take_event(Event.MESSAGE_LOST)
        except (UnsupportedEventError, ClosedError):  # it may be closed on another thread meanwhile
            return self.lost
        return status.total_count if isinstance(status, Count) else self.lost


class RecordedTopics:
    """Subscribes to wanted topics. One thread at a time calls its methods."""

    def __init__(
        self,
        node: Node,
        writer: BagWriter,
        options: RecordOptions,
        learn: Callable[[base.Participant, str], object] | None,
    ) -> None:
        self._node = node
        self._writer = writer
        self._options = options
        self._learn = learn
        self._recorded: dict[str, _Recorded] = {}
        self._reported: set[str] = set()
        self._changes = -1
        self._participant: base.Participant | None = None
        self._undefined: dict[int, tuple[Topic, int]] = {}
        """By number, topics whose types have no definition yet, and how many searches for it are left."""
        self._search_s = 0.0
        """When the definitions are searched for again, on the monotonic clock [s]."""

    @property
    def is_complete(self) -> bool:
        """Whether all topics are recorded that may ever be wanted."""
        choice = self._options.choice
        has_all = choice.is_by_name_only and choice.wanted_names() <= self._recorded.keys()
        return has_all and not self._undefined

    def subscribe_changed(self) -> None:
        """Subscribe to what has appeared since the last call."""
        if self._graph().changes() != self._changes:
            self.subscribe_all()
        if self._undefined and time.monotonic() >= self._search_s:
            for number, (topic, left) in list(self._undefined.items()):
                self._define(number, topic, left - 1)

    def subscribe_all(self) -> None:
        """Subscribe to all wanted topics that exist."""
        graph = self._graph()
        self._changes = graph.changes()
        self._subscribe_to_static(graph)
        for name, topic_info in sorted(self._topics(graph).items()):
            if name in self._recorded:
                self._warn_of_refused(name, topic_info)
            elif self._is_wanted(name, topic_info):
                self._subscribe(name, topic_info)

    def _subscribe_to_static(self, graph: base.Graph) -> None:
        """Subscribe to the topics that are recorded whether or not anybody publishes them."""
        missing = self._options.static_topics.keys() - self._recorded.keys()
        topics = self._topics(graph) if missing else {}
        for name in sorted(missing):
            type_name = self._options.static_topics[name]
            topic_info = topics.get(name, _TopicInfo())
            if topic_info.types.keys() - {type_name}:
                types = ", ".join(sorted(topic_info.types))
                self._report(f"Static topic '{name}' has another type than {type_name}: {types}")
            topic_info.types = {type_name: topic_info.types.get(type_name, "")}
            topic_info.writers = [end for end in topic_info.writers if end.topic.type_name == type_name]
            self._subscribe(name, topic_info)

    def lost_count(self) -> int:
        """Return how many messages the wire has lost."""
        return sum(topic.count_lost() for topic in self._recorded.values())

    def losses(self) -> dict[str, tuple[int, int]]:
        """Return how many messages of each topic were lost: on the wire, in a full cache. Any thread may call it."""
        dropped = self._writer.queue.dropped_counts()
        return {
            name: (topic.count_lost(), dropped[topic.number] if topic.number < len(dropped) else 0)
            for name, topic in list(self._recorded.items())
        }

    def _repeated_count(self, name: str, offers: list[QoS]) -> int:
        """Return how many of a topic's last messages further files begin with."""
        if name in self._options.repeated:
            return self._options.repeated[name]
        is_kept = offers and all(offer.durability == DurabilityPolicy.TRANSIENT_LOCAL for offer in offers)
        return self._options.repeats_all if is_kept else 0

    def close(self) -> None:
        """Close the readers of all topics. A definition that was searched for only once is searched for again."""
        for number, (topic, left) in list(self._undefined.items()):
            try:
                if left == MAX_SEARCHES:
                    self._define(number, topic, 0)
                else:
                    self._report_undefined(topic)
            except Exception:  # of the wire, which may have ended: the bag is completed all the same
                self._report_undefined(topic)
        self._undefined.clear()
        for recorded in self._recorded.values():
            recorded.destroy()

    def _graph(self) -> base.Graph:
        if self._participant is None:
            self._participant = open_endpoint(self._node, _NoEndpoint(), lambda participant, _: participant)
        return self._participant.graph

    def _topics(self, graph: base.Graph) -> dict[str, _TopicInfo]:
        topics: dict[str, _TopicInfo] = {}
        for end in graph.endpoints():
            topic_info = topics.setdefault(end.topic.name, _TopicInfo())
            # The type's hash is that of a publisher; a subscription's counts only where there is none.
            if end.is_writer or end.topic.type_name not in topic_info.types:
                topic_info.types[end.topic.type_name] = end.topic.type_hash
            if end.is_writer:
                topic_info.writers.append(end)
            else:  # or it is the recorder's own, of a topic that is recorded: nobody asks of it
                topic_info.has_subscription = True
        return topics

    def _is_wanted(self, name: str, topic_info: _TopicInfo) -> bool:
        if len(topic_info.types) > 1:
            if any(self._options.choice.wants(name, type_name) for type_name in topic_info.types):
                types = ", ".join(sorted(topic_info.types))
                self._report(f"Topic '{name}' has more than one type, and can't be recorded: {types}")
            return False
        type_name = next(iter(topic_info.types))
        if not self._options.choice.wants(name, type_name):
            return False
        if not topic_info.writers and not self._options.include_unpublished_topics:
            return False
        if self._options.ignore_leaf_topics and not topic_info.has_subscription:
            return False
        is_named = name in self._options.choice.wanted_names()
        is_of_other = is_service_event(name, type_name) or self._options.choice.wants_as_action(name)
        is_shown = is_named or self._options.include_hidden_topics or is_of_other
        if "/_" in name and not is_shown:
            self._warn_of_hidden()
            return False
        return True

    def _subscribe(self, name: str, topic_info: _TopicInfo) -> None:
        type_name, type_hash = next(iter(topic_info.types.items()))
        offers = [end.qos for end in topic_info.writers]
        override = self._options.qos_overrides.get(name)
        qos = adapted(offers) if override is None else override._replace(history=HistoryPolicy.KEEP_ALL)
        if override is None:
            for text in warnings_of(name, offers):
                self._node.get_logger().warning(text)
        type_hash = type_hash or hash_of(type_name)
        topic = Topic(
            name, type_name, "cdr", type_hash, profiles_text(offers), find_definition(type_name, type_hash)
        )
        number = self._writer.add_topic(topic)
        if depth := self._repeated_count(name, offers):
            self._writer.repeat(number, depth)
            if not offers and override is None:
                qos = qos._replace(durability=DurabilityPolicy.TRANSIENT_LOCAL)
        recorded = _Recorded(qos, number)
        wire_topic = base.Topic(name, type_name, type_hash)
        recorded.reader = open_endpoint(
            self._node, recorded, lambda participant, node: participant.create_reader(node, wire_topic, qos)
        )
        # From here on the wire's threads push messages into the queue, with the number under which the writer knows the
        # topic. So the topic is added first, although it may turn out to have no message.
        recorded.reader.feed(self._writer.sink(number))
        self._recorded[name] = recorded
        self._node.get_logger().info(f"Subscribed to topic '{name}'")
        # Asking peers for the definition takes time: messages are recorded meanwhile, and the definition comes later.
        if topic.definition is None:
            self._define(number, topic, MAX_SEARCHES)

    def _define(self, number: int, topic: Topic, searches_left: int) -> None:
        """Look for the definition of a type that is unknown here, and again later where there is none."""
        if self._learn is not None and self._participant is not None:
            self._learn(self._participant, topic.type)
        definition = find_definition(topic.type)
        self._undefined.pop(number, None)
        if definition is not None:
            self._writer.set_topic(number, topic._replace(definition=definition))
        elif searches_left and self._learn is not None:
            # A node may be known after its endpoints, or too busy to respond in time.
            self._undefined[number] = topic, searches_left
            self._search_s = time.monotonic() + SEARCH_S
        else:
            self._report_undefined(topic)

    def _report_undefined(self, topic: Topic) -> None:
        self._report(
            f"There is no definition of '{topic.type}' here, and no node describes it. The messages of '{topic.name}' "
            "are recorded without it."
        )

    def _warn_of_refused(self, name: str, topic_info: _TopicInfo) -> None:
        recorded = self._recorded[name]
        # The profile was adapted to the publishers of the time at which the topic was subscribed to. One that comes
        # later may offer less, and isn't matched with the reader; each is named once, by its gid.
        for end in topic_info.writers:
            if end.gid in recorded.refused:
                continue
            if policies := unmet_policies(end.qos, recorded.qos):
                recorded.refused.add(end.gid)
                kinds = ", ".join(policy.name for policy in policies)
                self._node.get_logger().warning(
                    f"A new publisher of '{name}' offers a lower quality than was requested ({kinds}). Its messages "
                    "are not recorded."
                )

    def _warn_of_hidden(self) -> None:
        text = "Hidden topics are not recorded. Enable them with --include-hidden-topics"
        if text not in self._reported:
            self._reported.add(text)
            get_logger("ROSBAG2_TRANSPORT").warning(text)

    def _report(self, text: str) -> None:
        """Log a warning, unless the same text was logged before."""
        if text not in self._reported:
            self._reported.add(text)
            self._node.get_logger().warning(text)


class _NoEndpoint:
    """An endpoint that is not on the wire."""

    def destroy(self) -> None:
        """Do nothing, because there is nothing on the wire to close."""
