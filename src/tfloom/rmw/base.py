"""The interface between nodes and wires: bytes, a topic, a quality of service.

A backend is a module with `open_participant(domain_id, enclave) -> Participant`. Names and types are in
ROS's form here (`/turtle1/pose`, `turtlesim/msg/Pose`); each backend converts them to its wire's form.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple, Protocol

from tfloom._native import ReadyQueue, Sink
from tfloom.rmw.events import Event, Status
from tfloom.rmw.qos import QoS

PREFIX_LENGTH = 12
"""The bytes of a gid on DDS that are the participant's."""


class Sample(NamedTuple):
    """One message received from the wire."""

    data: bytes
    """Encapsulation header (4 bytes) and CDR; on DDS padded with zeros to a multiple of 4 bytes."""
    source_stamp_ns: int
    """Time of writing, by the writer's clock [ns since epoch]."""
    received_stamp_ns: int
    """Time of receipt, by this host's clock [ns since epoch]."""
    publisher_gid: bytes
    """Gid of its writer: 16 bytes."""
    publication_sequence_number: int | None = None
    """Number that its writer has given it, from 1; None where the wire doesn't tell."""
    reception_sequence_number: int | None = None
    """Number that its reader has given it, from 0; None where the wire doesn't."""

    @property
    def for_sink(self) -> tuple[bytes, int, int, bytes]:
        """What a `Sink` takes of it."""
        return self[:4]


class NodeName(NamedTuple):
    """A node on the graph."""

    namespace: str
    """`/` or `/a/b`, without a slash at its end."""
    name: str

    @property
    def full(self) -> str:
        """Fully qualified name, `/a/b/name`."""
        return f"{self.namespace.rstrip('/')}/{self.name}"


class Topic(NamedTuple):
    """The topic of a writer or a reader."""

    name: str
    """Fully qualified: `/turtle1/pose`."""
    type_name: str
    """`turtlesim/msg/Pose`."""
    type_hash: str
    """`RIHS01_` and 64 hex digits; empty if unknown."""
    is_native: bool = False
    """Whether DDS has the name unchanged, without ROS's prefix; the graph then does not count it as a ROS topic."""
    other_hash: str = ""
    """Hash of another definition of the type whose samples a reader takes, too; empty: none, and on the graph."""


class EndpointInfo(NamedTuple):
    """A writer or a reader on the graph, of this or any other participant."""

    topic: Topic
    node: NodeName | None
    """None until its participant's node list has arrived, or for a program that is not a ROS node."""
    is_writer: bool
    gid: bytes
    """Identifies the endpoint on its domain: 16 bytes."""
    qos: QoS


class Service(NamedTuple):
    """The service of a client or a server."""

    name: str
    """Fully qualified: `/spawn`."""
    type_name: str
    """`turtlesim/srv/Spawn`."""
    request_hash: str = ""
    """`RIHS01_` and 64 hex digits, of the request's type; empty if unknown."""
    response_hash: str = ""
    """The same for the response's type."""
    type_hash: str = ""
    """The same for the service's own type, which has its events too."""


class ServiceEndInfo(NamedTuple):
    """A server or a client on the graph, of this or any other participant."""

    name: str
    type_name: str
    node: NodeName | None
    """None as in `EndpointInfo`."""
    is_server: bool
    gid: bytes
    """16 bytes: of a server's reader of requests, of a client's writer of requests."""
    qos: QoS
    type_hash: str = ""
    """`RIHS01_` and 64 hex digits, of the service's own type; empty where its messages have theirs alone."""


class RequestId(NamedTuple):
    """The id of a request and of its response."""

    client_gid: bytes
    """The client that has sent the request: 16 bytes."""
    sequence_number: int
    """From 1, counted by each client."""


class Request(NamedTuple):
    """One request received from the wire, without the wire's header."""

    data: bytes
    """Encapsulation header (4 bytes) and CDR."""
    id: RequestId
    source_stamp_ns: int
    received_stamp_ns: int


class Response(NamedTuple):
    """One response to a request of this client."""

    data: bytes
    """Encapsulation header (4 bytes) and CDR."""
    id: RequestId
    source_stamp_ns: int
    received_stamp_ns: int


class ParticipantInfo(NamedTuple):
    """A participant on the graph."""

    gid: bytes
    nodes: list[NodeName]
    """Its nodes, as far as it has listed them."""
    is_own: bool
    """Whether it is the one that asks."""


class Graph(Protocol):
    """All that a participant has discovered, its own entities included. Each result is a snapshot."""

    def nodes(self) -> list[NodeName]:
        """Return the nodes, one entry for each, in order of their full names, which may be equal."""

    def endpoints(self) -> list[EndpointInfo]:
        """Return writers and readers of ROS topics (`rt/…` on DDS), in order of topic name."""

    def raw_endpoints(self) -> list[EndpointInfo]:
        """Return all writers and readers, by the names that topics and types have on the wire, in order of these."""

    def service_ends(self) -> list[ServiceEndInfo]:
        """Return servers and clients, in order of service name."""

    def enclaves(self) -> list[tuple[NodeName, str]]:
        """Return the nodes as `nodes` does, each with the enclave it is in; empty if unknown."""

    def participants(self) -> list[ParticipantInfo]:
        """Return the participants, this one included, in order of their gids."""

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` whenever the graph has changed; None ends it."""

    def changes(self) -> int:
        """Return a number that grows with each change."""

    def is_whole(self) -> bool:
        """Return whether all announced entities have arrived, of each process that is known on this machine."""

    def delivers_incompatible(self) -> bool:
        """Return whether samples pass between a writer and a reader of incompatible qualities of service."""

    def late_count(self) -> int:
        """Return how many known participants are of an implementation that lists its nodes seconds later, and have not.

        That is Fast DDS, whose endpoints may be unknown for as long.
        """


class Endpoint(Protocol):
    """The common methods of writers and readers."""

    gid: bytes

    def matched_count(self) -> int:
        """Return how many peers are connected now."""

    def notify_event(self, event: Event, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when `take_event(event)` may have a new status, and once at the start; None ends it.

        Raises:
            UnsupportedEventError: this wire, or this kind of endpoint, has no such event.
        """

    def take_event(self, event: Event) -> Status | None:
        """Return the status of `event` if it has changed since it was taken last, or None.

        Raises:
            UnsupportedEventError: this wire, or this kind of endpoint, has no such event.
        """

    def close(self) -> None:
        """Leave the topic. Closing again does nothing; writing afterwards raises RuntimeError."""


class Writer(Endpoint, Protocol):
    """A writer of a topic."""

    def write(self, data: bytes) -> None:
        """Send one sample: encapsulation header and CDR. Never blocks for longer than the wire's own limit."""

    def write_message(self, message: object) -> None:
        """Encode and send a message; raise EncodeError, as `cdr.encode`, if a value doesn't fit its field."""

    def assert_liveliness(self) -> None:
        """Assert that this writer is alive, as `LivelinessPolicy.MANUAL_BY_TOPIC` requires; a write does so, too."""

    def wait_for_acks(self, timeout_ns: int) -> bool:
        """Wait until all connected reliable readers have acknowledged all samples; return False on a timeout.

        A timeout of 0 returns at once; a negative one is endless.
        """


class Reader(Endpoint, Protocol):
    """A reader of a topic."""

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there is something to take, at once if there may be already; None ends it.

        One post may cover many samples: take one, and post the token again if there was one.
        """

    def take(self) -> Sample | None:
        """Remove and return the oldest waiting sample, or None. Never blocks."""

    def take_decoded(self, message_class: type) -> Sample | None:
        """As `take`; but the data may be a message of `message_class`, where the wire decodes it without a copy."""

    def publisher_hash(self, gid: bytes) -> str:
        """Return the hash that a publisher has given for its type, by its gid; empty if it is unknown."""

    def announce_filter(self, expression: str, parameters: Sequence[str]) -> None:
        """Tell writers which samples are wanted, by DDS's subset of SQL; an empty expression accepts all.

        Few can filter, and only on some wires: whoever takes must filter all the same.
        """

    def feed(self, sink: Sink) -> None:
        """Push every sample into `sink` on the wire's thread from now on, those already waiting first.

        The samples bypass Python: `take` returns None and `notify` posts nothing. The reader holds a reference to
        the sink, and pushes nothing more once `close` has returned.
        """


class Requester(Protocol):
    """A client of a service."""

    gid: bytes
    client_gid: bytes
    """The `client_gid` of its `RequestId`s: 16 bytes."""

    def send(self, data: bytes) -> int:
        """Send a request, encapsulation header and CDR, and return its sequence number.

        A server that is not yet matched in both directions does not receive the request.

        Raises:
            ForeignPeerError: a server of this service uses another vendor's format and would misread the request.
            CongestedError: too many requests wait for servers that do not take them.
            ClosedError: the requester is closed.
        """

    def give_up(self, sequence_numbers: Iterable[int], *, is_lost: bool = False) -> None:
        """Await no response to these requests any longer. Those that wait for room at a server are never sent.

        Args:
            sequence_numbers: What `send` returned for each.
            is_lost: All servers that had them have left, so they occupy no room.
        """

    def take(self) -> Response | None:
        """Remove and return the oldest waiting response to a request of this client, or None. Never blocks."""

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there may be something to take; see `Reader.notify`."""

    def notify_ready(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when `is_ready` may have changed, and once at the start; None ends it."""

    def is_ready(self) -> bool:
        """Return whether a server is matched in both directions, so that it will receive and reply to a request."""

    def is_synchronising(self) -> bool:
        """Return whether a server is matched in both directions, and may not take data yet; `send` waits for it."""

    def watch_servers(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when a server may have come or left, and once at the start; None ends it.

        A wait that uses `notify_ready` suspends it; the token is posted after the wait.
        """

    def receiving_servers(self) -> frozenset[str]:
        """Return ids of the servers that receive a request sent now."""

    def connected_servers(self) -> frozenset[str]:
        """Return ids of the servers that receive requests, or whose responses may still arrive."""

    def incompatibility(self) -> str:
        """Return a text for the user: why this client cannot become ready with the present servers; empty if it can."""

    def close(self) -> None:
        """Leave the service. Closing again does nothing."""


class Responder(Protocol):
    """A server of a service."""

    gid: bytes

    def take(self) -> Request | None:
        """Remove and return the oldest waiting request, or None. Never blocks."""

    def send(self, request_id: RequestId, data: bytes) -> None:
        """Reply to a request: encapsulation header and CDR. It is not an error if the client has left.

        May wait, for 0.1 s at most, until the client's reader is matched.

        Raises:
            ClosedError: the responder is closed.
        """

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there may be something to take; see `Reader.notify`."""

    def incompatibility(self) -> str:
        """Return a text for the user: why some of the present clients can't be served; empty if all can be."""

    def last_drop_reason(self) -> str:
        """Return a text for the user: why the last dropped request was dropped; empty if none was."""

    def close(self) -> None:
        """Leave the service. Closing again does nothing."""


class Participant(Protocol):
    """This process on one domain. All of its methods may be called from any thread."""

    domain_id: int

    @property
    def graph(self) -> Graph:
        """All that this participant has discovered."""

    def add_node(self, node: NodeName) -> None:
        """Add a node to the graph."""

    def remove_node(self, node: NodeName) -> None:
        """Remove a node from the graph; its writers and readers must be closed before."""

    def create_writer(self, node: NodeName, topic: Topic, qos: QoS) -> Writer:
        """Open a writer of a topic for `node`."""

    def create_reader(self, node: NodeName, topic: Topic, qos: QoS) -> Reader:
        """Open a reader of a topic for `node`."""

    def create_requester(self, node: NodeName, service: Service, qos: QoS) -> Requester:
        """Open a client of a service for `node`."""

    def create_responder(self, node: NodeName, service: Service, qos: QoS) -> Responder:
        """Open a server of a service for `node`."""

    def close(self) -> None:
        """Close all writers and readers and leave the domain. Closing again does nothing."""
