"""The seam between nodes and wires: bytes, a topic, a quality of service.

A backend is a module with `open_participant(domain_id, enclave) -> Participant`. Names and types cross the seam as
ROS writes them (`/turtle1/pose`, `turtlesim/msg/Pose`); each backend puts them into its wire's form.
"""

from __future__ import annotations

from typing import NamedTuple, Protocol

from tfloom._native import ReadyQueue, Sink
from tfloom.rmw.events import Event, Status
from tfloom.rmw.qos import QoS


class Sample(NamedTuple):
    """One message off the wire."""

    data: bytes
    """Encapsulation header (4 octets) and CDR; on DDS padded with zeros to a multiple of 4 octets."""
    source_stamp_ns: int
    """When it was written, by the writer's clock [ns since epoch]."""
    received_stamp_ns: int
    """When it was taken off the wire here [ns since epoch]."""
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
    is_native: bool = False
    """Whether DDS has the name as it stands, without ROS's prefix; on the graph it is then no ROS topic."""


class EndpointInfo(NamedTuple):
    """A writer or a reader on the graph, anybody's."""

    topic: Topic
    node: NodeName | None
    """None while its participant has not told which node it belongs to, or for a program that is no ROS node."""
    is_writer: bool
    gid: bytes
    """16 octets."""
    qos: QoS


class Service(NamedTuple):
    """What is called or served."""

    name: str
    """Fully qualified: `/spawn`."""
    type_name: str
    """`turtlesim/srv/Spawn`."""
    request_hash: str = ""
    """`RIHS01_` and 64 hex digits of the request's part; empty if not known."""
    response_hash: str = ""
    """The same of the response's part."""


class ServiceEndInfo(NamedTuple):
    """A server or a client on the graph, anybody's."""

    name: str
    type_name: str
    node: NodeName | None
    """None where an `EndpointInfo` has None."""
    is_server: bool
    gid: bytes
    """16 octets: of a server's reader of requests, of a client's writer of requests."""
    qos: QoS


class RequestId(NamedTuple):
    """What a server sends back with its response, for the client to know which request it answers."""

    client_gid: bytes
    """16 octets."""
    sequence_number: int
    """From 1, counted by each client."""


class Request(NamedTuple):
    """One request off the wire, without any header of the wire's own."""

    data: bytes
    """Encapsulation header (4 octets) and CDR."""
    id: RequestId
    source_stamp_ns: int
    received_stamp_ns: int


class Response(NamedTuple):
    """One response to a request of ours."""

    data: bytes
    """Encapsulation header (4 octets) and CDR."""
    id: RequestId
    source_stamp_ns: int
    received_stamp_ns: int


class Graph(Protocol):
    """Everything a participant has heard of, its own included. Each answer is a snapshot."""

    def nodes(self) -> list[NodeName]:
        """Return the nodes, one entry for each, in order of their full names; twins are listed twice."""

    def endpoints(self) -> list[EndpointInfo]:
        """Return writers and readers of ROS topics (`rt/…` on DDS), in order of topic name."""

    def raw_endpoints(self) -> list[EndpointInfo]:
        """Return all writers and readers, by the names that topics and types have on DDS, in order of these."""

    def service_ends(self) -> list[ServiceEndInfo]:
        """Return servers and clients, in order of service name."""

    def enclaves(self) -> list[tuple[NodeName, str]]:
        """Return the nodes as `nodes` does, each with the enclave it is in; empty if that isn't known."""

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` whenever the graph has changed; None ends it."""

    def changes(self) -> int:
        """Return a number that grows with each change, for "wait until it is quiet"."""

    def is_whole(self) -> bool:
        """Tell whether all has come of what is known to come; there may be others of whom nothing came yet."""


class Endpoint(Protocol):
    """What a writer and a reader have in common."""

    gid: bytes

    def matched_count(self) -> int:
        """Return how many peers are connected now."""

    def notify_event(self, event: Event, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when `take_event(event)` may have news, once at the start too; None ends it.

        Raises:
            UnsupportedEventError: this wire, or a such an endpoint, has no such event.
        """

    def take_event(self, event: Event) -> Status | None:
        """Return what has become of `event` since it was taken last, or None if nothing has happened.

        Raises:
            UnsupportedEventError: this wire, or a such an endpoint, has no such event.
        """

    def close(self) -> None:
        """Leave the topic. Closing again does nothing; writing afterwards raises RuntimeError."""


class Writer(Endpoint, Protocol):
    """The sending end of a topic."""

    def write(self, data: bytes) -> None:
        """Send one sample: encapsulation header and CDR. Never blocks for longer than the wire's own limit."""

    def assert_liveliness(self) -> None:
        """Say that this writer is alive, as `LivelinessPolicy.MANUAL_BY_TOPIC` wants it; a write says so too."""

    def wait_for_acks(self, timeout_ns: int) -> bool:
        """Wait until all connected reliable readers have all that was written; False on a timeout.

        Does not wait with a timeout of 0, waits for ever with a negative one.
        """


class Reader(Endpoint, Protocol):
    """The receiving end of a topic."""

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there is something to take, at once if there may be already; None ends it.

        One post may stand for many samples: take one, and post the token again if there was one.
        """

    def take(self) -> Sample | None:
        """Remove and return the oldest waiting sample, or None. Never blocks."""

    def feed(self, sink: Sink) -> None:
        """From now on push every sample into `sink` on the wire's thread, those already waiting first.

        Python never sees them: `take` returns None and `notify` posts nothing. The reader keeps the sink alive,
        and pushes nothing more once `close` has returned.
        """


class Requester(Protocol):
    """A client of a service."""

    gid: bytes
    client_gid: bytes
    """What its `RequestId`s hold: 16 octets."""

    def send(self, data: bytes) -> int:
        """Send a request, encapsulation header and CDR, and return its sequence number.

        Who isn't ready to take it never sees it.

        Raises:
            ForeignPeerError: a server of this service speaks another vendor's form and would misread the request.
            ClosedError: the requester is closed.
        """

    def take(self) -> Response | None:
        """Remove and return the oldest waiting response to a request of this client, or None. Never blocks."""

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there may be something to take; see `Reader.notify`."""

    def notify_ready(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when `is_ready` may have changed, once at the start too; None ends it."""

    def is_ready(self) -> bool:
        """Tell whether a server is connected both ways, so that a request sent now will be answered."""

    def obstacle(self) -> str:
        """Return why this client will never be ready as things stand, for the user to read; empty if it may be."""

    def close(self) -> None:
        """Leave the service. Closing again does nothing."""


class Responder(Protocol):
    """A server of a service."""

    gid: bytes

    def take(self) -> Request | None:
        """Remove and return the oldest waiting request, or None. Never blocks."""

    def send(self, request_id: RequestId, data: bytes) -> None:
        """Answer a request: encapsulation header and CDR. A client that has left is not an error.

        May wait, for 0.1 s at most, for a client that can't hear the answer yet.

        Raises:
            ClosedError: the responder is closed.
        """

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there may be something to take; see `Reader.notify`."""

    def obstacle(self) -> str:
        """Return why some client can't be served as things stand, for the user to read; empty if all can be."""

    def refusal(self) -> str:
        """Return why a request was dropped the last time that one was, for the user to read; empty if none was."""

    def close(self) -> None:
        """Leave the service. Closing again does nothing."""


class Participant(Protocol):
    """This process on one domain. All of its methods may be called from any thread."""

    domain_id: int

    @property
    def graph(self) -> Graph:
        """What this participant has heard of."""

    def add_node(self, node: NodeName) -> None:
        """Show a node on the graph."""

    def remove_node(self, node: NodeName) -> None:
        """Take a node off the graph; its writers and readers are to be closed before."""

    def create_writer(self, node: NodeName, topic: Topic, qos: QoS) -> Writer:
        """Offer a topic on behalf of `node`."""

    def create_reader(self, node: NodeName, topic: Topic, qos: QoS) -> Reader:
        """Ask for a topic on behalf of `node`."""

    def create_requester(self, node: NodeName, service: Service, qos: QoS) -> Requester:
        """Become a client of a service on behalf of `node`."""

    def create_responder(self, node: NodeName, service: Service, qos: QoS) -> Responder:
        """Serve a service on behalf of `node`."""

    def close(self) -> None:
        """Close all writers and readers and leave the domain. Closing again does nothing."""
