"""Description of one publisher or subscription on the graph, and the hash of its type."""

from __future__ import annotations

from enum import IntEnum
from typing import TYPE_CHECKING, Any

from tfloom.node.qos.qos import QoSProfile, qos_profile_unknown
from tfloom.rmw.base import NodeName
from tfloom.rmw.shared.endpoint_text import UNKNOWN_NODE, endpoint_text
from tfloom.ros_imports.guard import ros_repr

if TYPE_CHECKING:
    from typing_extensions import Self

    from tfloom.rmw.base import EndpointInfo

__all__ = ["TopicEndpointInfo", "TopicEndpointTypeEnum", "TypeHash"]


_SIZE = 32


class TypeHash:
    """A version and 32 bytes; version -1: unknown."""

    __slots__ = ("_value", "_version")

    def __init__(self, version: int = -1, value: bytes = bytes(_SIZE)) -> None:
        self._version = version
        self._value = value

    @classmethod
    def from_text(cls, text: str) -> TypeHash:
        """Return the hash written as `RIHS01_` and 64 hex digits; for any other text, an unknown hash."""
        version, _, digits = text.removeprefix("RIHS").partition("_")
        try:
            value = bytes.fromhex(digits)
            number = int(version, 16)
        except ValueError:
            return cls()
        return cls(number, value) if len(value) == _SIZE else cls()

    @property
    def version(self) -> int:
        """Version of the algorithm; -1: unknown."""
        return self._version

    @property
    def value(self) -> bytes:
        """The hash, 32 bytes."""
        return self._value

    def __str__(self) -> str:
        if self._version == -1 or len(self._value) != _SIZE:
            return "INVALID"
        return f"RIHS{self._version:02x}_{self._value.hex()}"

    def __repr__(self) -> str:
        return f"TypeHash(version={self._version}, value={self._value!r})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, TypeHash):
            return False
        return (self._version, self._value) == (other._version, other._value)

    def __hash__(self) -> int:
        return hash((self._version, self._value))


class TopicEndpointTypeEnum(IntEnum):
    """Kind of an endpoint of a topic."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2


class TopicEndpointInfo:
    """A publisher or subscription of any node.

    Args:
        kwargs: Any of the properties below; the others are empty.

    Raises:
        TypeError: there is no such property.
    """

    __slots__ = (
        "endpoint_gid",
        "endpoint_type",
        "node_name",
        "node_namespace",
        "qos_profile",
        "topic_type",
        "topic_type_hash",
    )

    node_name: str
    """Name of its node; `_NODE_NAME_UNKNOWN_` while that isn't known."""
    node_namespace: str
    """Namespace of its node; `_NODE_NAMESPACE_UNKNOWN_` while that isn't known."""
    topic_type: str
    """The type's name, e.g. `std_msgs/msg/String`."""
    topic_type_hash: TypeHash
    """The hash of the type's definition."""
    endpoint_type: TopicEndpointTypeEnum
    """Publisher or subscription."""
    endpoint_gid: list[int]
    """Global id on the wire: 16 bytes."""
    qos_profile: QoSProfile
    """The offered or requested QoS."""

    def __init__(self, **kwargs: Any) -> None:
        self.node_name = ""
        self.node_namespace = ""
        self.topic_type = ""
        self.topic_type_hash = TypeHash()
        self.endpoint_type = TopicEndpointTypeEnum.INVALID
        self.endpoint_gid = []
        self.qos_profile = qos_profile_unknown
        for name, value in kwargs.items():
            if name not in self.__slots__:
                raise TypeError(
                    f"'{name}' is not a property of an endpoint; known are {', '.join(self.__slots__)}"
                )
            setattr(self, name, TopicEndpointTypeEnum(value) if name == "endpoint_type" else value)

    def __repr__(self) -> str:
        return ros_repr(self)

    @classmethod
    def from_graph(cls, info: EndpointInfo) -> Self:
        """Return the description of an endpoint on the graph."""
        node = info.node or UNKNOWN_NODE
        kinds = TopicEndpointTypeEnum
        return cls(
            node_name=node.name,
            node_namespace=node.namespace,
            topic_type=info.topic.type_name,
            topic_type_hash=TypeHash.from_text(info.topic.type_hash),
            endpoint_type=kinds.PUBLISHER if info.is_writer else kinds.SUBSCRIPTION,
            endpoint_gid=list(info.gid),
            qos_profile=QoSProfile.from_wire(info.qos),
        )

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, TopicEndpointInfo):
            return False
        return all(getattr(self, name) == getattr(other, name) for name in self.__slots__)

    def __hash__(self) -> int:
        return hash((tuple(self.endpoint_gid), self.endpoint_type))

    def __str__(self) -> str:
        return endpoint_text(
            NodeName(self.node_namespace, self.node_name),
            self.topic_type,
            str(self.topic_type_hash),
            self.endpoint_type.name,
            self.endpoint_gid,
            self.qos_profile.as_stated(),
        )
