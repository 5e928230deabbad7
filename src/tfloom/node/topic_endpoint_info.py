"""What the graph tells of one publisher or subscription."""

from __future__ import annotations

from enum import IntEnum
from typing import TYPE_CHECKING

from tfloom.node.qos import QoSProfile
from tfloom.node.type_hash import TypeHash

if TYPE_CHECKING:
    from tfloom.rmw.base import EndpointInfo

__all__ = ["TopicEndpointInfo", "TopicEndpointTypeEnum"]

UNKNOWN_NODE_NAME = "_NODE_NAME_UNKNOWN_"
UNKNOWN_NODE_NAMESPACE = "_NODE_NAMESPACE_UNKNOWN_"


class TopicEndpointTypeEnum(IntEnum):
    """Which end of a topic."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2


class TopicEndpointInfo:
    """A publisher or subscription, anybody's."""

    __slots__ = ("_info",)

    def __init__(self, info: EndpointInfo) -> None:
        self._info = info

    @property
    def node_name(self) -> str:
        """Whose it is; `_NODE_NAME_UNKNOWN_` while that isn't known."""
        return UNKNOWN_NODE_NAME if self._info.node is None else self._info.node.name

    @property
    def node_namespace(self) -> str:
        """In which namespace; `_NODE_NAMESPACE_UNKNOWN_` while that isn't known."""
        return UNKNOWN_NODE_NAMESPACE if self._info.node is None else self._info.node.namespace

    @property
    def topic_type(self) -> str:
        """The type's name, e.g. `std_msgs/msg/String`."""
        return self._info.topic.type_name

    @property
    def topic_type_hash(self) -> TypeHash:
        """The hash of the type's definition."""
        return TypeHash.from_text(self._info.topic.type_hash)

    @property
    def endpoint_type(self) -> TopicEndpointTypeEnum:
        """Publisher or subscription."""
        if self._info.is_writer:
            return TopicEndpointTypeEnum.PUBLISHER
        return TopicEndpointTypeEnum.SUBSCRIPTION

    @property
    def endpoint_gid(self) -> list[int]:
        """Who it is on the wire: 16 octets."""
        return list(self._info.gid)

    @property
    def qos_profile(self) -> QoSProfile:
        """What it offers or asks for."""
        return QoSProfile.from_wire(self._info.qos)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TopicEndpointInfo) and self._info == other._info

    def __hash__(self) -> int:
        return hash((self._info.gid, self._info.is_writer))

    def __str__(self) -> str:
        gid = ".".join(f"{octet:02x}" for octet in self._info.gid)
        profile = self.qos_profile
        return "\n".join(
            [
                f"Node name: {self.node_name}",
                f"Node namespace: {self.node_namespace}",
                f"Topic type: {self.topic_type}",
                f"Topic type hash: {self.topic_type_hash}",
                f"Endpoint type: {self.endpoint_type.name}",
                f"GID: {gid}",
                "QoS profile:",
                f"  Reliability: {profile.reliability.name}",
                f"  History (Depth): {profile.history_text()}",
                f"  Durability: {profile.durability.name}",
                f"  Lifespan: {profile.lifespan}",
                f"  Deadline: {profile.deadline}",
                f"  Liveliness: {profile.liveliness.name}",
                f"  Liveliness lease duration: {profile.liveliness_lease_duration}",
            ]
        )
