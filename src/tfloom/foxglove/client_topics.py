"""The topics to which clients publish."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom.foxglove.shares import Shares
from tfloom.node.qos.qos import QoSProfile
from tfloom.rosidl import cdr
from tfloom.rosidl.registry import get_message_class

if TYPE_CHECKING:
    from tfloom.foxglove.settings import Settings
    from tfloom.node.endpoints.publisher import Publisher
    from tfloom.node.node import Node

__all__ = ["ClientTopic", "ClientTopicError", "ClientTopics"]

MAX_TOPICS = 512
"""Number of topics that all clients may advertise."""
MAX_TEXT = 1000
"""Number of characters of a topic's name, its type or its encoding."""
DEPTH = 10


class ClientTopicError(Exception):
    """A client can't publish this; the text says why."""


class ClientTopic(NamedTuple):
    """What a client wants to publish."""

    name: str
    type_name: str
    encoding: str


class ClientTopics:
    """Keeps a publisher for each topic of each client.

    What a client advertises is noted at once, on a thread of the SDK, and published later, on the node's. What was
    refused or dropped is not noted: its messages and its end are not waited with.
    """

    def __init__(self, node: Node, settings: Settings) -> None:
        self._node = node
        self._settings = settings
        self._shares = Shares(MAX_TOPICS)
        self._publishers: dict[tuple[int, int], tuple[Publisher[Any], type[Any]]] = {}
        """Used on the node's thread alone."""
        self._lock = threading.Lock()
        self._noted: dict[tuple[int, int], ClientTopic] = {}
        """What is, or will be, published of each channel of each client; guarded by `_lock`."""

    # On threads of the SDK.

    def note(self, client: int, channel_id: int, topic: ClientTopic) -> None:
        """Note what a client advertises.

        Raises:
            ClientTopicError: its texts are too long to be kept.
        """
        if max(map(len, topic)) > MAX_TEXT:
            raise ClientTopicError(
                f"a topic can't be advertised: its name, its type or its encoding has more than {MAX_TEXT} characters"
            )
        with self._lock:
            self._noted[client, channel_id] = topic

    def is_noted(self, client: int, channel_id: int) -> bool:
        """Return whether what a client publishes to a channel is waited for."""
        with self._lock:
            return (client, channel_id) in self._noted

    def forget(self, client: int, channel_id: int, topic: ClientTopic | None = None) -> bool:
        """Note that a channel is at its end, if it is still of this topic; return whether it was noted."""
        with self._lock:
            noted = self._noted.get((client, channel_id))
            if noted is None or (topic is not None and noted is not topic):
                return False
            del self._noted[client, channel_id]
            return True

    # On the node's thread.

    def advertise(self, client: int, channel_id: int, topic: ClientTopic) -> None:
        """Create a publisher.

        Raises:
            ClientTopicError: the client may not, or its type or encoding can't be used.
        """
        try:
            self._advertise(client, channel_id, topic)
        except BaseException:
            self.forget(client, channel_id, topic)
            raise

    def _advertise(self, client: int, channel_id: int, topic: ClientTopic) -> None:
        try:
            full_name = self._node.resolve_topic_name(topic.name)  # what other nodes see
        except ValueError as error:  # no name of a topic
            raise ClientTopicError(f"{topic.name} can't be advertised: {error}") from None
        if full_name not in self._settings.client_topics:
            raise ClientTopicError(f"clients may not publish to {full_name}")
        if topic.encoding != "cdr":
            raise ClientTopicError(f"messages to {topic.name} have to be cdr, not {topic.encoding}")
        self.unadvertise(client, channel_id)
        if not self._shares.take(client):
            raise ClientTopicError(
                f"{topic.name} can't be advertised: client {client} has all the topics that are left for it, "
                f"of {MAX_TOPICS}"
            )
        try:
            try:
                message_class = get_message_class(topic.type_name)
            except (LookupError, ValueError, OSError) as error:
                raise ClientTopicError(f"{topic.name} can't be advertised: {error}") from None
            publisher = self._node.create_publisher(message_class, topic.name, QoSProfile(depth=DEPTH))
        except BaseException:
            self._shares.give_back(client)
            raise
        self._publishers[client, channel_id] = publisher, message_class

    def publish(self, client: int, channel_id: int, data: bytes) -> None:
        """Publish a message.

        Raises:
            ClientTopicError: its bytes are not a message of the advertised type.
        """
        if (advertised := self._publishers.get((client, channel_id))) is None:
            return  # advertising it was refused
        publisher, message_class = advertised
        try:
            cdr.decode(message_class, data)  # other nodes get no bytes that they can't decode
        except cdr.DecodeError as error:
            raise ClientTopicError(f"a message to {publisher.topic_name} can't be decoded: {error}") from None
        publisher.publish(data)

    def unadvertise(self, client: int, channel_id: int) -> None:
        """Destroy a publisher, if there is one."""
        if (advertised := self._publishers.pop((client, channel_id), None)) is not None:
            self._shares.give_back(client)
            self._node.destroy_publisher(advertised[0])
