"""The seam between nodes and wires: bytes, a topic, a quality of service.

A backend is a module with `open_participant(domain_id, enclave) -> Participant`. Names and types cross the seam as
ROS writes them (`/turtle1/pose`, `turtlesim/msg/Pose`); each backend puts them into its wire's form.
"""

from __future__ import annotations

from typing import NamedTuple, Protocol

from tfloom._native import ReadyQueue, Sink
from tfloom.rmw.qos import QoS


class Sample(NamedTuple):
    """One message off the wire."""

    data: bytes
    """Encapsulation header (4 octets) and CDR."""
    source_stamp_ns: int
    """When it was written, by the writer's clock [ns since epoch]."""
    received_stamp_ns: int
    """When it arrived here [ns since epoch]."""
    publisher_gid: bytes
    """Who wrote it: 16 octets."""


class NodeName(NamedTuple):
    """A node on the graph."""

    namespace: str
    """`/` or `/a/b`, never with a slash at its end."""
    name: str

    @property
    def full(self) -> str:
        """Fully qualified name, `/a/b/name`."""
        return f"{self.namespace.rstrip('/')}/{self.name}"


class Topic(NamedTuple):
    """What is written or read."""

    name: str
    """Fully qualified: `/turtle1/pose`."""
    type_name: str
    """`turtlesim/msg/Pose`."""
    type_hash: str
    """`RIHS01_` and 64 hex digits; empty if not known."""


class EndpointInfo(NamedTuple):
    """A writer or a reader on the graph, anybody's."""

    topic: Topic
    node: NodeName | None
    """None while its participant has not told which node it belongs to, or for a program that is no ROS node."""
    is_writer: bool
    gid: bytes
    """16 octets."""
    qos: QoS


class Graph(Protocol):
    """Everything a participant has heard of, its own included. Each answer is a snapshot."""

    def nodes(self) -> list[NodeName]:
        """Return the nodes, one entry for each, in order of their full names; twins are listed twice."""

    def endpoints(self) -> list[EndpointInfo]:
        """Return writers and readers of ROS topics (`rt/…` on DDS), in order of topic name."""

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` whenever the graph has changed; None ends it."""

    def changes(self) -> int:
        """Return a number that grows with each change, for "wait until it is quiet"."""


class Writer(Protocol):
    """The sending end of a topic."""

    gid: bytes

    def write(self, data: bytes) -> None:
        """Send one sample: encapsulation header and CDR. Never blocks for longer than the wire's own limit."""

    def matched_count(self) -> int:
        """Return how many readers are connected now."""

    def close(self) -> None:
        """Leave the topic. Closing again does nothing; writing afterwards raises RuntimeError."""


class Reader(Protocol):
    """The receiving end of a topic."""

    gid: bytes

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there is something to take, at once if there already is; None ends it.

        One post may stand for many samples: take one, and post the token again if there was one.
        """

    def take(self) -> Sample | None:
        """Remove and return the oldest waiting sample, or None. Never blocks."""

    def feed(self, sink: Sink) -> None:
        """From now on push every sample into `sink` on the wire's thread, those already waiting first.

        Python never sees them: `take` returns None and `notify` posts nothing. The reader keeps the sink alive,
        and pushes nothing more once `close` has returned.
        """

    def matched_count(self) -> int:
        """Return how many writers are connected now."""

    def close(self) -> None:
        """Leave the topic. Closing again does nothing."""


class Participant(Protocol):
    """This process on one domain. All of its methods may be called from any thread."""

    domain_id: int
    graph: Graph

    def add_node(self, node: NodeName) -> None:
        """Show a node on the graph."""

    def remove_node(self, node: NodeName) -> None:
        """Take a node off the graph; its writers and readers are to be closed before."""

    def create_writer(self, node: NodeName, topic: Topic, qos: QoS) -> Writer:
        """Offer a topic on behalf of `node`."""

    def create_reader(self, node: NodeName, topic: Topic, qos: QoS) -> Reader:
        """Ask for a topic on behalf of `node`."""

    def close(self) -> None:
        """Close all writers and readers and leave the domain. Closing again does nothing."""
