"""The topics to which clients publish."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom.node.qos.qos import QoSProfile
from tfloom.rosidl import cdr
from tfloom.rosidl.registry import get_message_class

if TYPE_CHECKING:
    from tfloom.foxglove.settings import Settings
    from tfloom.node.endpoints.publisher import Publisher
    from tfloom.node.node import Node

__all__ = ["ClientTopic", "ClientTopicError", "ClientTopics"]

MAX_TOPICS = 256
"""Number of topics that all clients may advertise."""
DEPTH = 10


class ClientTopicError(Exception):
    """A client can't publish this; the text says why."""


class ClientTopic(NamedTuple):
    """What a client wants to publish."""

    name: str
    type_name: str
    encoding: str


class ClientTopics:
    """Keeps a publisher for each topic of each client. Used on the node's thread alone."""

    def __init__(self, node: Node, settings: Settings) -> None:
        self._node = node
        self._settings = settings
        self._publishers: dict[tuple[int, int], tuple[Publisher[Any], type[Any]]] = {}

    def advertise(self, client: int, channel_id: int, topic: ClientTopic) -> None:
        """Create a publisher.

        Raises:
            ClientTopicError: the client may not, or its type or encoding can't be used.
        """
        try:
            full_name = self._node.resolve_topic_name(topic.name)  # what other nodes see
        except ValueError as error:  # no name of a topic
            raise ClientTopicError(f"{topic.name} can't be advertised: {error}") from None
        if full_name not in self._settings.client_topics:
            raise ClientTopicError(f"clients may not publish to {full_name}")
        if topic.encoding != "cdr":
            raise ClientTopicError(f"messages to {topic.name} have to be cdr, not {topic.encoding}")
        if len(self._publishers) >= MAX_TOPICS:
            raise ClientTopicError(f"{topic.name} can't be advertised: clients have {MAX_TOPICS} topics")
        try:
            message_class = get_message_class(topic.type_name)
        except (LookupError, ValueError, OSError) as error:
            raise ClientTopicError(f"{topic.name} can't be advertised: {error}") from None
        self.unadvertise(client, channel_id)
        publisher = self._node.create_publisher(message_class, topic.name, QoSProfile(depth=DEPTH))
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
            self._node.destroy_publisher(advertised[0])
