"""The in-process wire: what is written is in the matched readers before `write` returns.

Participants of one process on the same domain hear each other, as on DDS: same topic, same type, compatible qualities
of service. Nothing leaves the process, no thread runs, and the order of samples is the order of writes.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from itertools import count
from typing import NamedTuple

from tfloom._native import ReadyQueue, Sink
from tfloom.rmw.base import EndpointInfo, NodeName, Sample, Topic
from tfloom.rmw.compatibility import incompatible_policies
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.qos import INFINITE_NS, DurabilityPolicy, HistoryPolicy, QoS

_domains: dict[int, _Domain] = {}
_domains_lock = threading.Lock()
_participant_numbers = count(1)


def open_participant(domain_id: int, enclave: str = "/") -> LocalParticipant:
    """Join a domain of this process. The enclave means nothing here."""
    with _domains_lock:
        domain = _domains.setdefault(domain_id, _Domain())
        participant = LocalParticipant(domain_id, enclave, domain)
        domain.add_participant(participant)
    return participant


class _Stored(NamedTuple):
    sample: Sample
    expires_ns: int


def _keep(qos: QoS) -> deque[_Stored]:
    """Return an empty store that holds what `qos` keeps."""
    return deque(maxlen=None if qos.history == HistoryPolicy.KEEP_ALL else qos.depth)


class _Domain:
    """Everybody on one domain of this process.

    Locks are taken in this order: a domain's, a writer's, a reader's.
    """

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.participants: list[LocalParticipant] = []
        self.nodes: list[NodeName] = []
        self.writers: list[LocalWriter] = []
        self.readers: list[LocalReader] = []
        self.changes = 0

    def add_participant(self, participant: LocalParticipant) -> None:
        with self.lock:
            self.participants.append(participant)

    def remove_participant(self, participant: LocalParticipant) -> bool:
        """Say goodbye to a participant and tell whether it was the last."""
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

    def add_node(self, node: NodeName) -> None:
        with self.lock:
            self.nodes.append(node)
            self._changed()

    def remove_node(self, node: NodeName) -> None:
        with self.lock:
            self.nodes.remove(node)
            self._changed()

    def _changed(self) -> None:
        self.changes += 1
        for participant in self.participants:
            participant.graph.post_change()


class LocalGraph:
    """What everybody on the domain has; see `base.Graph`."""

    def __init__(self, domain: _Domain) -> None:
        self._domain = domain
        self._listener: tuple[ReadyQueue, int] | None = None

    def nodes(self) -> list[NodeName]:
        """Return the nodes, one entry for each, in order of their full names."""
        with self._domain.lock:
            return sorted(self._domain.nodes, key=lambda node: node.full)

    def endpoints(self) -> list[EndpointInfo]:
        """Return writers and readers, in order of topic name."""
        with self._domain.lock:
            ends: list[LocalWriter | LocalReader] = [*self._domain.writers, *self._domain.readers]
        return sorted((end.info for end in ends), key=lambda info: info.topic.name)

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` whenever the graph has changed; None ends it."""
        self._listener = None if queue is None else (queue, token)

    def changes(self) -> int:
        """Return a number that grows with each change."""
        return self._domain.changes

    def post_change(self) -> None:
        """Tell whoever asked to be told."""
        if listener := self._listener:
            listener[0].post(listener[1])


class LocalWriter:
    """The sending end; see `base.Writer`."""

    def __init__(self, domain: _Domain, info: EndpointInfo) -> None:
        self.info = info
        self.gid = info.gid
        self._domain = domain
        self._lock = threading.Lock()
        self._readers: list[LocalReader] = []
        self._late = _keep(info.qos)
        self._closed = False

    def write(self, data: bytes) -> None:
        """Put a sample into every matched reader.

        Raises:
            ClosedError: the writer has left its topic.
        """
        with self._lock:
            if self._closed:
                raise ClosedError(f"cannot write to {self.info.topic.name}: its writer is closed")
            now_ns = time.time_ns()
            stored = _Stored(Sample(bytes(data), now_ns, now_ns, self.gid), self._expiry_ns(now_ns))
            if self.info.qos.durability == DurabilityPolicy.TRANSIENT_LOCAL:
                self._late.append(stored)
            for reader in self._readers:
                reader.deliver(stored)

    def _expiry_ns(self, now_ns: int) -> int:
        lifespan_ns = self.info.qos.lifespan_ns
        return INFINITE_NS if lifespan_ns == INFINITE_NS else now_ns + lifespan_ns

    def match(self, reader: LocalReader) -> None:
        """Connect a reader if it is of the same topic, type and compatible qualities; send it what it missed."""
        mine, theirs = self.info, reader.info
        if (mine.topic.name, mine.topic.type_name) != (theirs.topic.name, theirs.topic.type_name):
            return
        if incompatible_policies(mine.qos, theirs.qos):
            return
        with self._lock:
            if self._closed:
                return
            self._readers.append(reader)
            reader.count_writer(1)
            if theirs.qos.durability == DurabilityPolicy.TRANSIENT_LOCAL:
                for stored in self._late:
                    reader.deliver(stored)

    def unmatch(self, reader: LocalReader) -> None:
        """Disconnect a reader that leaves."""
        with self._lock:
            if reader in self._readers:
                self._readers.remove(reader)

    def matched_count(self) -> int:
        """Return how many readers are connected now."""
        with self._lock:
            return len(self._readers)

    def close(self) -> None:
        """Leave the topic; what readers have not taken yet stays with them."""
        with self._lock:
            if self._closed:
                return
            self._closed = True
            readers, self._readers = self._readers, []
        for reader in readers:
            reader.count_writer(-1)
        self._domain.remove_writer(self)


class LocalReader:
    """The receiving end; see `base.Reader`."""

    def __init__(self, domain: _Domain, info: EndpointInfo) -> None:
        self.info = info
        self.gid = info.gid
        self._domain = domain
        self._lock = threading.Lock()
        self._waiting = _keep(info.qos)
        self._listener: tuple[ReadyQueue, int] | None = None
        self._sink: Sink | None = None
        self._writers = 0
        self._closed = False

    def deliver(self, stored: _Stored) -> None:
        """Take in one sample, on the writer's thread."""
        with self._lock:
            if self._closed:
                return
            if self._sink is not None:
                _push(self._sink, stored)
                return
            self._waiting.append(stored)
            if self._listener is not None:
                self._listener[0].post(self._listener[1])

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there is something to take, at once if there already is; None ends it."""
        with self._lock:
            self._listener = None if queue is None else (queue, token)
            if queue is not None and self._waiting:
                queue.post(token)

    def take(self) -> Sample | None:
        """Remove and return the oldest waiting sample whose lifespan hasn't ended, or None."""
        with self._lock:
            while self._waiting:
                stored = self._waiting.popleft()
                if stored.expires_ns > time.time_ns():
                    return stored.sample
        return None

    def feed(self, sink: Sink) -> None:
        """Push every sample into `sink` from now on, those already waiting first."""
        with self._lock:
            self._sink = sink
            while self._waiting:
                _push(sink, self._waiting.popleft())

    def count_writer(self, change: int) -> None:
        """Note that a writer has come (1) or gone (-1)."""
        with self._lock:
            self._writers += change

    def matched_count(self) -> int:
        """Return how many writers are connected now."""
        return self._writers

    def close(self) -> None:
        """Leave the topic; what waits is dropped."""
        with self._lock:
            if self._closed:
                return
            self._closed = True
            self._sink = None
            self._listener = None
            self._waiting.clear()
            self._writers = 0
        self._domain.remove_reader(self)


def _push(sink: Sink, stored: _Stored) -> None:
    if stored.expires_ns > time.time_ns():
        sink.push(*stored.sample)


class LocalParticipant:
    """This process on one domain; see `base.Participant`."""

    def __init__(self, domain_id: int, enclave: str, domain: _Domain) -> None:
        self.domain_id = domain_id
        self.enclave = enclave
        self.graph = LocalGraph(domain)
        self._domain = domain
        self._gid_prefix = b"local" + next(_participant_numbers).to_bytes(5, "big")
        self._entity_numbers = count(1)
        self._nodes: list[NodeName] = []
        self._closed = False

    def add_node(self, node: NodeName) -> None:
        """Show a node on the graph."""
        self._nodes.append(node)
        self._domain.add_node(node)

    def remove_node(self, node: NodeName) -> None:
        """Take a node off the graph.

        Raises:
            ValueError: this participant has no such node.
        """
        self._nodes.remove(node)
        self._domain.remove_node(node)

    def create_writer(self, node: NodeName, topic: Topic, qos: QoS) -> LocalWriter:
        """Offer a topic on behalf of `node`."""
        writer = LocalWriter(self._domain, self._describe(node, topic, qos, is_writer=True))
        self._domain.add_writer(writer)
        return writer

    def create_reader(self, node: NodeName, topic: Topic, qos: QoS) -> LocalReader:
        """Ask for a topic on behalf of `node`."""
        reader = LocalReader(self._domain, self._describe(node, topic, qos, is_writer=False))
        self._domain.add_reader(reader)
        return reader

    def _describe(self, node: NodeName, topic: Topic, qos: QoS, *, is_writer: bool) -> EndpointInfo:
        if self._closed:
            raise ClosedError(f"cannot open {topic.name}: its participant is closed")
        gid = self._gid_prefix + next(self._entity_numbers).to_bytes(6, "big")
        return EndpointInfo(topic, node, is_writer, gid, qos.resolved())

    def close(self) -> None:
        """Close all writers and readers and leave the domain."""
        if self._closed:
            return
        self._closed = True
        for end in self._domain.ends_of(self._gid_prefix):
            end.close()
        for node in self._nodes:
            self._domain.remove_node(node)
        with _domains_lock:
            if self._domain.remove_participant(self):
                del _domains[self.domain_id]
