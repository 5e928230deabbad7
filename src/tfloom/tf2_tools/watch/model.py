"""What an observer of /tf and /tf_static knows: publishers, edges, and frames that were children."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from tfloom._native import EdgeStatistics, TfChild, TfSnapshot, TfTraffic
from tfloom.rmw.base import EndpointInfo, NodeName
from tfloom.rmw.compatibility import incompatible_policies
from tfloom.rmw.qos import DurabilityPolicy, QoS, QoSPolicyKind

TF_TOPIC = "/tf"
STATIC_TOPIC = "/tf_static"
TOPICS = (TF_TOPIC, STATIC_TOPIC)
"""The topics of moving and of static transforms."""
LISTENER_QOS = (QoS(depth=100), QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=100))
"""What a transform listener requests for the topics of moving and of static transforms."""

MAX_SQUARED_NORM_ERROR = 0.01
"""From this difference of a quaternion's squared length from 1 on, a buffer rejects the transform."""


def stored_name(frame: str) -> str:
    """Return the name under which a buffer stores a frame: without a slash at its start, if there is one."""
    return frame.removeprefix("/")


@dataclass(frozen=True)
class Publisher:
    """A publisher of transforms on one topic."""

    gid: bytes
    """The 16 bytes that identify its writer on DDS, or, in a recording, its topic."""
    topic: str
    is_static: bool
    """Whether the topic is that of static transforms."""
    node: NodeName | None = None
    """None if no participant lists the publisher, or the source has no nodes, as a recording."""
    qos: QoS | None = None
    """The offered quality of service; None if it is unknown."""
    origin: str = ""
    """What its transforms were read from, where that isn't a graph: the name of a file."""
    traffic: TfTraffic | None = None
    """What it has sent; None: it is on the graph, and nothing has come."""

    @property
    def name(self) -> str:
        """Full name of its node, or of the file it was read from, or `unknown`."""
        return self.node.full if self.node is not None else self.origin or "unknown"

    @property
    def gid_text(self) -> str:
        """The gid as `topic info -v` prints it."""
        return ".".join(f"{octet:02x}" for octet in self.gid)

    @property
    def label(self) -> str:
        """The name, followed by the gid where no node is known."""
        return self.name if self.node is not None or self.origin else f"unknown (GID {self.gid_text})"

    @property
    def mismatches(self) -> list[QoSPolicyKind]:
        """The policies for which a transform listener receives nothing from it; empty if it does, or if unknown."""
        if self.qos is None:
            return []
        return incompatible_policies(self.qos.resolved(), LISTENER_QOS[self.is_static].resolved())

    @property
    def has_left(self) -> bool:
        """Whether it has left the graph."""
        return self.traffic is not None and self.traffic.has_left


@dataclass(frozen=True)
class Edge:
    """The transforms of one child to one parent from one publisher."""

    child: str
    parent: str
    publisher: Publisher
    statistics: EdgeStatistics

    @property
    def frames(self) -> tuple[str, str]:
        """The child and the parent, by their names in a buffer."""
        return stored_name(self.child), stored_name(self.parent)

    @property
    def is_static(self) -> bool:
        """Whether they came on the topic of static transforms."""
        return self.publisher.is_static

    @property
    def topic(self) -> str:
        """The topic on which they came."""
        return self.publisher.topic

    @property
    def rejection(self) -> str:
        """Why a buffer doesn't store its last transform, as the end of a sentence; empty if it does."""
        child, parent = self.frames
        if not (child and parent):
            return "a frame id is empty"
        if child == parent:
            return "the frame is its own parent"
        if self.statistics.count == self.statistics.non_finite:
            return "its numbers are not finite"
        # The same test as a buffer's, on the squared length, so that both agree at the limit.
        squares = math.fsum(part * part for part in self.statistics.rotation_xyzw)
        if abs(squares - 1.0) >= MAX_SQUARED_NORM_ERROR:
            return f"its quaternion has the length {math.sqrt(squares):.4g}, not 1"
        return ""

    @property
    def rate_hz(self) -> float:
        """Rate by stamps; by receipt where stamps don't advance; 0 with fewer than two transforms."""
        # The period of stamps is that of the sender: delays of the network don't change it. Stamps that never advance,
        # as those of a clock that stands still, leave only the times of receipt.
        by_stamp, by_receipt = self.statistics.stamp_period, self.statistics.receipt_period
        period_s = by_stamp.mean if by_stamp.count else by_receipt.mean
        return 1.0 / period_s if period_s > 0.0 else 0.0


@dataclass(frozen=True)
class Observation:
    """All that an observer knows at one time. Lists are in order of first receipt."""

    edges: Sequence[Edge]
    publishers: Sequence[Publisher]
    """Those that have sent something, then those on the graph that have not."""
    children: Mapping[str, TfChild]
    """By the frame's name."""
    started_ns: int
    """When the observation began, by the clock of receipts [ns since epoch].

    Of a recording: the time of its first message.
    """
    taken_ns: int
    """When this was taken, by the clock of receipts; of a recording: the time of its last message."""
    unrecorded: int = 0
    """Number of transforms beyond the observer's limits."""
    is_live: bool = False
    """Whether it is of a graph; then nodes are known, and time goes on."""
    endpoints: Sequence[EndpointInfo] = field(default=())
    """All publishers and subscriptions of the two topics on the graph; the observer's own are left out."""

    @cached_property
    def by_receipt(self) -> Sequence[Edge]:
        """The edges, that of the last receipt last."""
        return sorted(self.edges, key=lambda edge: edge.statistics.last_received_ns)

    def edges_of(self, child: str) -> list[Edge]:
        """Return the edges of a child, by its name in a buffer, of all publishers and parents, as `by_receipt`."""
        return [edge for edge in self.by_receipt if stored_name(edge.child) == child]

    def frames(self) -> list[str]:
        """Return the names of all frames, in order."""
        return sorted({name for edge in self.edges for name in (edge.child, edge.parent)})

    def parents(self) -> dict[str, str]:
        """Return the parent of each child in the transform received last."""
        return {name: child.parent for name, child in self.children.items()}


@dataclass(frozen=True)
class Description:
    """What a source knows of a publisher besides its transforms."""

    node: NodeName | None = None
    qos: QoS | None = None
    origin: str = ""


def observation_of(
    snapshot: TfSnapshot,
    described: Mapping[bytes, Description],
    times_ns: tuple[int, int],
    *,
    topics: tuple[str, str] = TOPICS,
    endpoints: Sequence[EndpointInfo] = (),
    is_live: bool = False,
) -> Observation:
    """Return an observation: a native snapshot, and what else is known of its publishers.

    Args:
        snapshot: The snapshot.
        described: What is known of publishers, by gid.
        times_ns: When the observation began, and when the snapshot was taken, by the clock of receipts [ns since
            epoch].
        topics: The topics of moving and of static transforms.
        endpoints: All other endpoints of these topics on the graph.
        is_live: Whether it is of a graph.
    """
    # First the publishers that have sent something, which the native observer counted: it counts by gid and topic, so
    # the key has both.
    publishers = {}
    for traffic in snapshot.publishers:
        description = described.get(traffic.gid, Description())
        publishers[traffic.gid, traffic.is_static] = Publisher(
            traffic.gid,
            topics[traffic.is_static],
            traffic.is_static,
            description.node,
            description.qos,
            description.origin,
            traffic,
        )
    # Then those that the graph lists and from which nothing has come: they say where a missing frame could come from.
    for end in endpoints:
        is_static = end.topic.name == topics[True]
        if end.is_writer and (end.gid, is_static) not in publishers:
            publishers[end.gid, is_static] = Publisher(end.gid, end.topic.name, is_static, end.node, end.qos)
    # Each edge has traffic, so the first loop has made its publisher.
    edges = [
        Edge(edge.child, edge.parent, publishers[edge.gid, edge.is_static], edge.statistics)
        for edge in snapshot.edges
    ]
    children = {child.child: child for child in snapshot.children}
    return Observation(
        edges,
        list(publishers.values()),
        children,
        *times_ns,
        unrecorded=snapshot.unrecorded,
        is_live=is_live,
        endpoints=endpoints,
    )
