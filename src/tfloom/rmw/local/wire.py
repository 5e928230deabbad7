"""The in-process wire: a sample is in the matched readers before `write` returns.

Participants of one process on the same domain match as on DDS: same topic, same type, compatible qualities of service.
No data leaves the process, there is no thread, and the order of samples is the order of writes.
"""

from __future__ import annotations

import threading
from itertools import count

from tfloom._native import ReadyQueue
from tfloom.rmw.base import (
    EndpointInfo,
    NodeName,
    Participant,
    ParticipantInfo,
    Service,
    ServiceEndInfo,
    Topic,
)
from tfloom.rmw.compatibility import chosen_qos
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.local.endpoints import LocalReader, LocalWriter
from tfloom.rmw.local.services import LocalClients, LocalServers
from tfloom.rmw.qos import QoS
from tfloom.rmw.services import HeaderRequester, HeaderResponder, waiting_qos
from tfloom.rmw.topic_names import (
    request_topic,
    response_topic,
    service_from_request_topic,
    topic_to_dds,
    type_to_dds,
)

_domains: dict[int, _Domain] = {}
_domains_lock = threading.Lock()
_participant_numbers = count(1)


def open_participant(domain_id: int, enclave: str = "/") -> Participant:
    """Join a domain of this process."""
    with _domains_lock:
        domain = _domains.setdefault(domain_id, _Domain())
        participant = LocalParticipant(domain_id, enclave, domain)
        domain.add_participant(participant)
    return participant


class _Domain:
    """The participants on one domain of this process."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.participants: list[LocalParticipant] = []
        self.nodes: list[tuple[NodeName, str]] = []
        self.writers: list[LocalWriter] = []
        self.readers: list[LocalReader] = []
        self.changes = 0

    def add_participant(self, participant: LocalParticipant) -> None:
        with self.lock:
            self.participants.append(participant)

    def remove_participant(self, participant: LocalParticipant) -> bool:
        """Remove a participant and return whether it was the last."""
        with self.lock:
            self.participants.remove(participant)
            return not self.participants

    def add_writer(self, writer: LocalWriter) -> None:
        with self.lock:
            self.writers.append(writer)
            for reader in self.readers:
                writer.match(reader)
            self._changed()

    def add_reader(self, reader: LocalReader) -> None:
        with self.lock:
            self.readers.append(reader)
            for writer in self.writers:
                writer.match(reader)
            self._changed()

    def remove_writer(self, writer: LocalWriter) -> None:
        with self.lock:
            self.writers.remove(writer)
            self._changed()

    def remove_reader(self, reader: LocalReader) -> None:
        with self.lock:
            self.readers.remove(reader)
            for writer in self.writers:
                writer.unmatch(reader)
            self._changed()

    def ends_of(self, gid_prefix: bytes) -> list[LocalWriter | LocalReader]:
        with self.lock:
            ends: list[LocalWriter | LocalReader] = [*self.writers, *self.readers]
        return [end for end in ends if end.gid.startswith(gid_prefix)]

    def add_node(self, node: NodeName, enclave: str) -> None:
        with self.lock:
            self.nodes.append((node, enclave))
            self._changed()

    def remove_node(self, node: NodeName, enclave: str) -> None:
        with self.lock:
            self.nodes.remove((node, enclave))
            self._changed()

    def _changed(self) -> None:
        self.changes += 1
        for participant in self.participants:
            participant.graph.post_change()


class LocalGraph:
    """The entities of all participants on the domain; see `base.Graph`."""

    def __init__(self, domain: _Domain) -> None:
        self._domain = domain
        self._listener: tuple[ReadyQueue, int] | None = None

    def nodes(self) -> list[NodeName]:
        """Return the nodes, one entry for each, in order of their full names."""
        return [node for node, _ in self.enclaves()]

    def enclaves(self) -> list[tuple[NodeName, str]]:
        """Return the nodes as `nodes` does, each with the enclave it is in."""
        with self._domain.lock:
            return sorted(self._domain.nodes, key=lambda node: node[0].full)

    def participants(self) -> list[ParticipantInfo]:
        """Return one entry, because all nodes are in this process."""
        return [ParticipantInfo(b"tfloom::".ljust(16, b"\0"), self.nodes(), is_own=True)]

    def endpoints(self) -> list[EndpointInfo]:
        """Return writers and readers of topics, in order of topic name."""
        infos = [info for info in self._infos() if _is_ros(info.topic)]
        return sorted(infos, key=lambda info: info.topic.name)

    def raw_endpoints(self) -> list[EndpointInfo]:
        """Return all writers and readers, by the names that topics and types have on DDS, in order of these."""
        infos = [info._replace(topic=_on_dds(info.topic)) for info in self._infos()]
        return sorted(infos, key=lambda info: info.topic.name)

    def service_ends(self) -> list[ServiceEndInfo]:
        """Return servers and clients, in order of service name."""
        ends = []
        for info in self._infos():
            if service := service_from_request_topic(info.topic.name, info.topic.type_name):
                is_server = not info.is_writer
                ends.append(
                    ServiceEndInfo(*service, info.node, is_server=is_server, gid=info.gid, qos=info.qos)
                )
        return sorted(ends, key=lambda end: end.name)

    def _infos(self) -> list[EndpointInfo]:
        with self._domain.lock:
            ends: list[LocalWriter | LocalReader] = [*self._domain.writers, *self._domain.readers]
        return [end.info for end in ends]

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` whenever the graph has changed; None ends it."""
        self._listener = None if queue is None else (queue, token)

    def is_whole(self) -> bool:
        """Return True, because all entities are visible at once."""
        return True

    def delivers_incompatible(self) -> bool:
        """Return False: such endpoints aren't connected."""
        return False

    def late_count(self) -> int:
        """Return 0, for the same reason."""
        return 0

    def changes(self) -> int:
        """Return a number that grows with each change."""
        return self._domain.changes

    def post_change(self) -> None:
        """Post the token of `notify`."""
        if listener := self._listener:
            listener[0].post(listener[1])


def _is_ros(topic: Topic) -> bool:
    return topic.name.startswith("/") and not topic.is_native


def _on_dds(topic: Topic) -> Topic:
    name = topic_to_dds(topic.name) if _is_ros(topic) else topic.name
    return topic._replace(name=name, type_name=type_to_dds(topic.type_name))


class LocalParticipant:
    """This process on one domain; see `base.Participant`."""

    def __init__(self, domain_id: int, enclave: str, domain: _Domain) -> None:
        self.domain_id = domain_id
        self.enclave = enclave
        self.graph = LocalGraph(domain)
        self._domain = domain
        self._gid_prefix = b"tfloom::" + next(_participant_numbers).to_bytes(4, "big")
        self._entity_numbers = count(1)
        self._nodes: list[NodeName] = []
        self._closed = False

    def add_node(self, node: NodeName) -> None:
        """Add a node to the graph."""
        self._nodes.append(node)
        self._domain.add_node(node, self.enclave)

    def remove_node(self, node: NodeName) -> None:
        """Remove a node from the graph.

        Raises:
            ValueError: this participant has no such node.
        """
        self._nodes.remove(node)
        self._domain.remove_node(node, self.enclave)

    def create_writer(self, node: NodeName, topic: Topic, qos: QoS) -> LocalWriter:
        """Open a writer of a topic for `node`."""
        writer = LocalWriter(self._describe(node, topic, qos, is_writer=True), self._domain.remove_writer)
        self._domain.add_writer(writer)
        return writer

    def create_reader(self, node: NodeName, topic: Topic, qos: QoS) -> LocalReader:
        """Open a reader of a topic for `node`."""
        reader = LocalReader(self._describe(node, topic, qos, is_writer=False), self._domain.remove_reader)
        self._domain.add_reader(reader)
        return reader

    def create_requester(self, node: NodeName, service: Service, qos: QoS) -> HeaderRequester:
        """Open a client of a service for `node`."""
        responses = self.create_reader(node, response_topic(service), waiting_qos(qos, is_client=True))
        requests = self.create_writer(node, request_topic(service), qos)
        return HeaderRequester(requests, responses, LocalServers(requests, responses), requests.gid[-8:])

    def create_responder(self, node: NodeName, service: Service, qos: QoS) -> HeaderResponder:
        """Open a server of a service for `node`."""
        responses = self.create_writer(node, response_topic(service), qos)
        requests = self.create_reader(node, request_topic(service), waiting_qos(qos, is_client=False))
        return HeaderResponder(requests, responses, LocalClients(requests))

    def _describe(self, node: NodeName, topic: Topic, qos: QoS, *, is_writer: bool) -> EndpointInfo:
        if self._closed:
            raise ClosedError(f"cannot open {topic.name}: its participant is closed")
        qos = chosen_qos(qos, self.graph, topic.name, is_writer=is_writer)
        gid = self._gid_prefix + next(self._entity_numbers).to_bytes(4, "big")
        return EndpointInfo(topic, node, is_writer, gid, qos.resolved())

    def close(self) -> None:
        """Close all writers and readers and leave the domain."""
        if self._closed:
            return
        self._closed = True
        for end in self._domain.ends_of(self._gid_prefix):
            end.close()
        for node in self._nodes:
            self._domain.remove_node(node, self.enclave)
        with _domains_lock:
            if self._domain.remove_participant(self) and _domains.get(self.domain_id) is self._domain:
                del _domains[self.domain_id]
