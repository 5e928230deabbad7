"""The wire of rmw_cyclonedds: DDS through the library of the cyclonedds wheel.

Samples are raw CDR both ways; nothing is marshalled here. Participants announce `enclave=…;`, endpoints
`typehash=…;`, and each participant lists its nodes on `ros_discovery_info`.
"""

from __future__ import annotations

import atexit
import os
import threading
from typing import TypeVar
from weakref import WeakSet

from tfloom._native import DdsParticipant, DdsReader, DdsWriter, ReadyQueue, Sink
from tfloom.rmw import node_lists
from tfloom.rmw.base import NodeName, Sample, Topic
from tfloom.rmw.cyclone_config import configuration
from tfloom.rmw.cyclone_graph import NODE_LIST_USER_DATA, CycloneGraph
from tfloom.rmw.cyclone_library import find_library
from tfloom.rmw.errors import ClosedError, WireError
from tfloom.rmw.qos import DurabilityPolicy, QoS
from tfloom.rmw.topic_names import topic_to_dds, type_to_dds

_WRITE_LAST = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=1)

_Native = TypeVar("_Native", DdsWriter, DdsReader)

_CONFIG_HINT = "; CYCLONEDDS_URI is set: see above what Cyclone says of it"

_open_participants: WeakSet[CycloneParticipant] = WeakSet()


def open_participant(domain_id: int, enclave: str = "/") -> CycloneParticipant:
    """Join a DDS domain.

    Raises:
        NoBackendError: cyclonedds isn't installed, or isn't version 11.
        ConfigurationError: ROS_AUTOMATIC_DISCOVERY_RANGE isn't a range.
        WireError: the library can't join; its text says why.
    """
    participant = CycloneParticipant(domain_id, enclave)
    _open_participants.add(participant)
    return participant


@atexit.register
def _close_all() -> None:
    """Say goodbye to peers, which would else wait for us until our lease ends."""
    for participant in list(_open_participants):
        participant.close()


class CycloneWriter:
    """The sending end; see `base.Writer`."""

    def __init__(self, participant: CycloneParticipant, native: DdsWriter, topic: Topic) -> None:
        self.gid: bytes = native.gid
        self.topic = topic
        self._participant = participant
        self._native = native
        self._closed = False

    def write(self, data: bytes) -> None:
        """Send one sample; waits where readers of a reliable topic don't keep up.

        Raises:
            ClosedError: the writer has left its topic.
            ValueError: the sample doesn't start with the header of little-endian CDR, or ends there.
        """
        try:
            self._native.write(data)
        except RuntimeError as error:
            what = ClosedError if self._closed else WireError
            raise what(f"cannot write to {self.topic.name}: {error}") from None

    def matched_count(self) -> int:
        """Return how many readers are connected now."""
        return self._native.matched_count()

    def close(self) -> None:
        """Leave the topic. Closing again does nothing."""
        if not self._closed:
            self._closed = True
            self._participant.forget(self)
            self._native.close()


class CycloneReader:
    """The receiving end; see `base.Reader`."""

    def __init__(self, participant: CycloneParticipant, native: DdsReader, topic: Topic) -> None:
        self.gid: bytes = native.gid
        self.topic = topic
        self._participant = participant
        self._native = native
        self._closed = False

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` when there is something to take, at once if there may be; None ends it."""
        self._native.notify(queue, token)

    def take(self) -> Sample | None:
        """Remove and return the oldest waiting sample, or None. Its time of receipt is that of its being taken."""
        taken = self._native.take()
        return None if taken is None else Sample(*taken)

    def feed(self, sink: Sink) -> None:
        """Push every sample into `sink` from now on, those already waiting first."""
        self._native.feed(sink)

    def matched_count(self) -> int:
        """Return how many writers are connected now."""
        return self._native.matched_count()

    def close(self) -> None:
        """Leave the topic. Closing again does nothing."""
        if not self._closed:
            self._closed = True
            self._participant.forget(self)
            self._native.close()


class CycloneParticipant:
    """This process on one DDS domain; see `base.Participant`."""

    def __init__(self, domain_id: int, enclave: str) -> None:
        self.domain_id = domain_id
        self.enclave = enclave
        self._process = os.getpid()
        self._lock = threading.Lock()
        self._nodes: list[NodeName] = []
        self._ends: dict[CycloneWriter | CycloneReader, NodeName] = {}
        self._closed = False
        try:
            self._native = DdsParticipant(
                find_library(), domain_id, configuration(), f"enclave={enclave};".encode()
            )
            self.graph = CycloneGraph(self._native)
            self._node_list_writer = DdsWriter(
                self._native,
                node_lists.TOPIC_NAME,
                type_to_dds(node_lists.TYPE_NAME),
                _WRITE_LAST,
                NODE_LIST_USER_DATA,
            )
        except WireError:
            raise
        except RuntimeError as error:
            raise WireError(f"{error}{_CONFIG_HINT if 'CYCLONEDDS_URI' in os.environ else ''}") from None

    def add_node(self, node: NodeName) -> None:
        """Show a node on the graph."""
        with self._lock:
            self._nodes.append(node)
            self._tell()

    def remove_node(self, node: NodeName) -> None:
        """Take a node off the graph.

        Raises:
            ValueError: this participant has no such node.
        """
        with self._lock:
            self._nodes.remove(node)
            self._tell()

    def create_writer(self, node: NodeName, topic: Topic, qos: QoS) -> CycloneWriter:
        """Offer a topic on behalf of `node`.

        Raises:
            WireError: the library refuses it; its text says why.
        """
        native = self._open(DdsWriter, topic, qos)
        writer = CycloneWriter(self, native, topic)
        self._remember(writer, node)
        return writer

    def create_reader(self, node: NodeName, topic: Topic, qos: QoS) -> CycloneReader:
        """Ask for a topic on behalf of `node`.

        Raises:
            WireError: the library refuses it; its text says why.
        """
        native = self._open(DdsReader, topic, qos)
        reader = CycloneReader(self, native, topic)
        self._remember(reader, node)
        return reader

    def _open(self, kind: type[_Native], topic: Topic, qos: QoS) -> _Native:
        if self._closed:
            raise ClosedError(f"cannot open {topic.name}: its participant is closed")
        user_data = f"typehash={topic.type_hash};".encode() if topic.type_hash else b""
        try:
            return kind(
                self._native,
                topic_to_dds(topic.name),
                type_to_dds(topic.type_name),
                qos.resolved(),
                user_data,
            )
        except RuntimeError as error:
            raise WireError(str(error)) from None

    def _remember(self, end: CycloneWriter | CycloneReader, node: NodeName) -> None:
        with self._lock:
            self._ends[end] = node
            self._tell()

    def forget(self, end: CycloneWriter | CycloneReader) -> None:
        """Drop an endpoint that closes from the list of what its node has."""
        if self._is_forked():
            return
        with self._lock:
            if self._ends.pop(end, None) is not None:
                self._tell()

    def _is_forked(self) -> bool:
        """Tell whether this is a child of the process that joined: there the library's threads don't exist."""
        return self._process != os.getpid()

    def _tell(self) -> None:
        """Tell all participants what nodes are here, and what each has open."""
        nodes = {node: node_lists.NodeEnds(node, [], []) for node in self._nodes}
        for end, node in self._ends.items():
            if entry := nodes.get(node):
                gids = entry.writer_gids if isinstance(end, CycloneWriter) else entry.reader_gids
                gids.append(end.gid)
        self._node_list_writer.write(
            node_lists.encode(self._native.gid, [nodes[node] for node in self._nodes])
        )

    def close(self) -> None:
        """Close all writers and readers and leave the domain. Closing again does nothing."""
        if self._closed or self._is_forked():
            return
        self._closed = True
        with self._lock:
            ends, self._ends = list(self._ends), {}
        for end in ends:
            end.close()
        self._node_list_writer.close()
        self.graph.close()
        self._native.close()
