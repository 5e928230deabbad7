"""Descriptions of publishers, subscriptions, clients and servers on the graph, and the hash of a type."""

from __future__ import annotations

from enum import IntEnum
from typing import TYPE_CHECKING, Any, ClassVar

from tfloom.node.qos.qos import QoSProfile, qos_profile_unknown
from tfloom.rmw.base import NodeName
from tfloom.rmw.shared.endpoint_text import UNKNOWN_NODE, endpoint_text, policy_texts
from tfloom.ros_imports.guard import ros_repr

if TYPE_CHECKING:
    from typing_extensions import Self

    from tfloom.rmw.base import EndpointInfo, ServiceEndInfo

__all__ = [
    "EndpointTypeEnum",
    "ServiceEndpointInfo",
    "TopicEndpointInfo",
    "TopicEndpointTypeEnum",
    "TypeHash",
]


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


class EndpointTypeEnum(IntEnum):
    """Kind of an endpoint of a topic or a service."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2
    CLIENT = 3
    SERVER = 4


TopicEndpointTypeEnum = EndpointTypeEnum
"""The name that it had before services had endpoints, too."""


class _EndpointInfo:
    """The properties that endpoints of topics and of services have in common.

    Args:
        kwargs: Any of the properties; the others are empty.

    Raises:
        TypeError: there is no such property.
    """

    __slots__ = ("endpoint_type", "node_name", "node_namespace")
    _properties: ClassVar[tuple[str, ...]] = ()

    node_name: str
    """Name of its node; `_NODE_NAME_UNKNOWN_` while that isn't known."""
    node_namespace: str
    """Namespace of its node; `_NODE_NAMESPACE_UNKNOWN_` while that isn't known."""
    endpoint_type: EndpointTypeEnum
    """Its kind."""

    def __init__(self, **kwargs: Any) -> None:
        self.node_name = ""
        self.node_namespace = ""
        self.endpoint_type = EndpointTypeEnum.INVALID
        for name, value in kwargs.items():
            if name not in self._properties:
                raise TypeError(
                    f"'{name}' is not a property of an endpoint; known are {', '.join(self._properties)}"
                )
            setattr(self, name, EndpointTypeEnum(value) if name == "endpoint_type" else value)

    def __repr__(self) -> str:
        return ros_repr(self)

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return False
        return all(getattr(self, name) == getattr(other, name) for name in self._properties)

    def __hash__(self) -> int:
        return hash((self.node_namespace, self.node_name, self.endpoint_type))


class TopicEndpointInfo(_EndpointInfo):
    """A publisher or subscription of any node.

    Args:
        kwargs: Any of the properties below; the others are empty.

    Raises:
        TypeError: there is no such property.
    """

    __slots__ = ("endpoint_gid", "qos_profile", "topic_type", "topic_type_hash")
    _properties = (
        "endpoint_gid",
        "endpoint_type",
        "node_name",
        "node_namespace",
        "qos_profile",
        "topic_type",
        "topic_type_hash",
    )

    topic_type: str
    """The type's name, e.g. `std_msgs/msg/String`."""
    topic_type_hash: TypeHash
    """The hash of the type's definition."""
    endpoint_gid: list[int]
    """Global id on the wire: 16 bytes."""
    qos_profile: QoSProfile
    """The offered or requested QoS."""

    def __init__(self, **kwargs: Any) -> None:
        self.topic_type = ""
        self.topic_type_hash = TypeHash()
        self.endpoint_gid = []
        self.qos_profile = qos_profile_unknown
        super().__init__(**kwargs)

    @classmethod
    def from_graph(cls, info: EndpointInfo) -> Self:
        """Return the description of an endpoint on the graph."""
        node = info.node or UNKNOWN_NODE
        kinds = EndpointTypeEnum
        return cls(
            node_name=node.name,
            node_namespace=node.namespace,
            topic_type=info.topic.type_name,
            topic_type_hash=TypeHash.from_text(info.topic.type_hash),
            endpoint_type=kinds.PUBLISHER if info.is_writer else kinds.SUBSCRIPTION,
            endpoint_gid=list(info.gid),
            qos_profile=QoSProfile.from_wire(info.qos),
        )

    def __str__(self) -> str:
        return endpoint_text(
            NodeName(self.node_namespace, self.node_name),
            self.topic_type,
            str(self.topic_type_hash),
            self.endpoint_type.name,
            self.endpoint_gid,
            self.qos_profile.as_stated(),
        )


class ServiceEndpointInfo(_EndpointInfo):
    """A client or a server of a service, of any node.

    Args:
        kwargs: Any of the properties below; the others are empty.

    Raises:
        TypeError: there is no such property.
    """

    __slots__ = ("endpoint_count", "endpoint_gids", "qos_profiles", "service_type", "service_type_hash")
    _properties = (
        "node_name",
        "node_namespace",
        "service_type",
        "service_type_hash",
        "qos_profiles",
        "endpoint_gids",
        "endpoint_type",
        "endpoint_count",
    )

    service_type: str
    """The type's name, e.g. `std_srvs/srv/SetBool`."""
    service_type_hash: TypeHash
    """The hash of the type's definition; unknown where the wire tells those of its messages alone."""
    qos_profiles: list[QoSProfile]
    """The QoS of each of its endpoints on the wire, that of requests first."""
    endpoint_gids: list[list[int]]
    """The global id of each of its endpoints on the wire, in the same order: 16 bytes."""
    endpoint_count: int
    """How many endpoints it has on the wire: on DDS two, of requests and of responses; elsewhere one."""

    def __init__(self, **kwargs: Any) -> None:
        self.service_type = ""
        self.service_type_hash = TypeHash()
        self.qos_profiles = []
        self.endpoint_gids = []
        self.endpoint_count = 0
        super().__init__(**kwargs)

    @classmethod
    def from_graph(cls, info: ServiceEndInfo, responses: EndpointInfo | None = None) -> Self:
        """Return the description of a client or a server on the graph.

        Args:
            info: The client or server, by its endpoint of requests.
            responses: Its endpoint of responses; None where it has none of its own, or that isn't known yet.
        """
        node = info.node or UNKNOWN_NODE
        ends: list[ServiceEndInfo | EndpointInfo] = [info] if responses is None else [info, responses]
        return cls(
            node_name=node.name,
            node_namespace=node.namespace,
            service_type=info.type_name,
            service_type_hash=TypeHash.from_text(info.type_hash),
            endpoint_type=EndpointTypeEnum.SERVER if info.is_server else EndpointTypeEnum.CLIENT,
            qos_profiles=[QoSProfile.from_wire(end.qos) for end in ends],
            endpoint_gids=[list(end.gid) for end in ends],
            endpoint_count=len(ends),
        )

    def __str__(self) -> str:
        lines = [
            f"Node name: {self.node_name}",
            f"Node namespace: {self.node_namespace}",
            f"Service type: {self.service_type}",
            f"Service type hash: {self.service_type_hash}",
            f"Endpoint type: {self.endpoint_type.name}",
            f"Endpoint count: {self.endpoint_count}",
        ]
        for gid, profile in zip(self.endpoint_gids, self.qos_profiles, strict=True):
            lines += [f"GID: {'.'.join(f'{byte:02x}' for byte in gid)}", "QoS profile:"]
            lines += [f"  {title}: {text}" for title, text in policy_texts(profile.as_stated()).items()]
        return "\n".join(lines)
