"""The wire of rmw_cyclonedds: DDS through libddsc.

Samples are raw CDR in both directions. Participants announce `enclave=…;`, endpoints
`typehash=…;`, and each participant lists its nodes on `ros_discovery_info`.
"""

from __future__ import annotations

import atexit
import os
import threading
import time
from collections.abc import Callable
from itertools import count
from typing import TypeVar, cast
from weakref import WeakSet, WeakValueDictionary

from tfloom._native import DdsParticipant, DdsWriter
from tfloom.common.text import describe_machine_clock
from tfloom.rmw.base import NodeName, Participant, Service, Topic
from tfloom.rmw.compatibility import chosen_qos
from tfloom.rmw.cyclone import config as cyclone_config
from tfloom.rmw.cyclone import discovery_info
from tfloom.rmw.cyclone.endpoints import CycloneEndpoint, CycloneReader, CycloneRequestWriter, CycloneWriter
from tfloom.rmw.cyclone.graph import NODE_LIST_USER_DATA, CycloneGraph
from tfloom.rmw.cyclone.library import Library, open_copy, open_library
from tfloom.rmw.cyclone.services import (
    CLIENT_KEY,
    SERVER_KEY,
    CycloneClients,
    CycloneServers,
    Vendors,
    end_id,
    end_user_data,
    start_translation,
)
from tfloom.rmw.cyclone.threads import check_threads
from tfloom.rmw.errors import ClosedError, WireError
from tfloom.rmw.forks import Inherited, refuse
from tfloom.rmw.qos import DurabilityPolicy, QoS
from tfloom.rmw.services import (
    HeaderRequester,
    HeaderResponder,
    RequestsInFlight,
    sending_qos,
    waiting_qos,
)
from tfloom.rmw.topic_names import request_topic, response_topic, topic_to_dds, type_to_dds

MAX_TIME_NS = 2**32 * 1_000_000_000 - 1
"""The latest time that a packet of DDS can hold [ns since the epoch]: its seconds are a uint32."""
_WRITE_LAST = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=1)

_End = TypeVar("_End", CycloneWriter, CycloneRequestWriter, CycloneReader)
_End2 = TypeVar("_End2", CycloneWriter, CycloneRequestWriter, CycloneReader)


_open_participants: WeakSet[CycloneParticipant] = WeakSet()
_open_library: Callable[[], Library] = open_library
"""Opens the library; in a child that has inherited one in use, a copy of it."""


def open_participant(domain_id: int, enclave: str = "/", announce_s: float | None = None) -> Participant:
    """Join a DDS domain.

    Args:
        domain_id: 0 to 232.
        enclave: Security enclave to announce.
        announce_s: See `config.configuration`; of the process's first participant on a domain.

    Raises:
        NoBackendError: there is no libddsc that can be used; see `open_library`.
        ConfigurationError: ROS_AUTOMATIC_DISCOVERY_RANGE or TFLOOM_LEASE_S is invalid, or security is enforced.
        WireError: the library can't join the domain; the text has the reason.
    """
    participant = CycloneParticipant(domain_id, enclave, announce_s)
    _open_participants.add(participant)
    return participant


def is_joined(domain_id: int) -> bool:
    """Return whether this process has a participant on a domain."""
    return any(
        participant.domain_id == domain_id and not participant.is_closed for participant in _open_participants
    )


def _invalidate_all_after_fork() -> None:
    """In a forked child, let the copies of the parent's participants raise errors."""
    global _open_library  # noqa: PLW0603  # guarded by there being one thread after a fork
    # The fork has copied the library's state, but none of its threads. Loading the same path again would return that
    # dead copy, so a participant that this child opens loads another file with the same content.
    in_use = [participant.invalidate_after_fork() for participant in _open_participants]
    if any(in_use):
        _open_library = open_copy
        open_copy.cache_clear()
        _open_participants.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_invalidate_all_after_fork)


@atexit.register
def _close_all() -> None:
    """Close all participants, because their peers would otherwise keep them until the lease ends."""
    for participant in list(_open_participants):
        participant.close()


def _explain(error: RuntimeError, domain_id: int) -> str:
    """Return why this process could not join a domain, and what to do."""
    if not 0 <= (now_ns := time.time_ns()) <= MAX_TIME_NS:
        clock = describe_machine_clock(now_ns)
        return f"{error}, because {clock}, and DDS has no times before 1970 nor after 7 February 2106. Set the clock"
    if "CYCLONEDDS_URI" in os.environ:
        advice = "check CYCLONEDDS_URI"
    else:
        advice = (
            "end some program or choose another ROS_DOMAIN_ID if "
            f"{cyclone_config.local_participants(domain_id)} are on this domain: one machine has room for no more"
        )
    return f"{error}; see Cyclone's message above, and {advice}"


def _user_data(topic: Topic) -> bytes:
    return f"typehash={topic.type_hash};".encode() if topic.type_hash else b""


class CycloneParticipant:
    """This process on one DDS domain; see `base.Participant`.

    Args:
        domain_id: The domain.
        enclave: Its security enclave, which it tells others and does nothing with.
        announce_s: Period of its announcements to others [s]; None: Cyclone's own.
    """

    def __init__(self, domain_id: int, enclave: str, announce_s: float | None = None) -> None:
        self.domain_id = domain_id
        self.enclave = enclave
        self._is_forked = False
        """Whether this is the copy in a forked child, without the library's threads."""
        self._lock = threading.Lock()
        """Guards the nodes and the endpoints, and the order in which lists of them are written."""
        self._nodes: list[NodeName] = []
        self._node_by_end: dict[CycloneEndpoint, NodeName] = {}
        """The endpoints that are open, and the node of each."""
        self._service_end_numbers = count(1)
        self._in_flight: WeakValueDictionary[str, RequestsInFlight] = WeakValueDictionary()
        """What the clients of each service have sent."""
        self.is_closed = False
        try:
            cyclone_config.refuse_enforced_security()
            cyclone_config.look_up_peers()
            opened = _open_library()
            library = opened.path
            check_threads(domain_id)
            self._vendors = Vendors(start_translation(library), self._find_node)
            self._native = DdsParticipant(
                library,
                domain_id,
                cyclone_config.configuration(domain_id, announce_s, opened.version),
                f"enclave={enclave};".encode(),
                is_local=cyclone_config.is_local(),
            )
            self.loopback_failure = self._native.loopback_failure
            """Why the sockets are open to other machines, contrary to the configuration; empty if they aren't."""
            self.graph = CycloneGraph(self._native, domain_id)
            self._node_list_writer = DdsWriter(
                self._native,
                discovery_info.TOPIC_NAME,
                type_to_dds(discovery_info.TYPE_NAME),
                _WRITE_LAST,
                NODE_LIST_USER_DATA,
            )
            self._publish_nodes()  # an empty list, so that others need not wait for one
        except WireError:
            raise
        except RuntimeError as error:
            raise WireError(_explain(error, domain_id)) from None

    def add_node(self, node: NodeName) -> None:
        """Add a node to the graph."""
        with self._lock:
            self._nodes.append(node)
            self._publish_nodes()

    def remove_node(self, node: NodeName) -> None:
        """Remove a node from the graph.

        Raises:
            ValueError: this participant has no such node.
        """
        with self._lock:
            self._nodes.remove(node)
            self._publish_nodes()

    def create_writer(self, node: NodeName, topic: Topic, qos: QoS) -> CycloneWriter:
        """Open a writer of a topic for `node`.

        Raises:
            WireError: the library refuses it; the text has the reason.
        """
        return self._open_topic(CycloneWriter, node, topic, qos)

    def create_reader(self, node: NodeName, topic: Topic, qos: QoS) -> CycloneReader:
        """Open a reader of a topic for `node`.

        Raises:
            WireError: the library refuses it; the text has the reason.
        """
        return self._open_topic(CycloneReader, node, topic, qos)

    def _open_topic(self, kind: type[_End], node: NodeName, topic: Topic, qos: QoS) -> _End:
        qos = chosen_qos(qos, self.graph, topic.name, is_writer=kind is CycloneWriter)
        dds_name = topic.name if topic.is_native else topic_to_dds(topic.name)
        end = self._open(kind, dds_name, topic, qos, _user_data(topic))
        self._remember(node, end)
        return end

    def create_requester(self, node: NodeName, service: Service, qos: QoS) -> HeaderRequester:
        """Open a client of a service for `node`.

        Raises:
            WireError: the library refuses it; the text has the reason.
        """
        requests, responses = self._open_service(
            CLIENT_KEY, CycloneRequestWriter, CycloneReader, node, service, qos
        )
        servers = CycloneServers(requests, responses, service.name, self._vendors)
        key = os.urandom(8)
        requests.join_service(responses, service.name, key)
        in_flight = self._in_flight.setdefault(service.name, RequestsInFlight())
        return HeaderRequester(requests, responses, servers, key, in_flight)

    def create_responder(self, node: NodeName, service: Service, qos: QoS) -> HeaderResponder:
        """Open a server of a service for `node`.

        Raises:
            WireError: the library refuses it; the text has the reason.
        """
        requests, responses = self._open_service(SERVER_KEY, CycloneReader, CycloneWriter, node, service, qos)
        responses.join_service(requests, service.name, None)
        clients = CycloneClients(requests, responses, service.name, self._vendors)
        return HeaderResponder(requests, responses, clients)

    def _open_service(
        self, key: str, asking: type[_End], answering: type[_End2], node: NodeName, service: Service, qos: QoS
    ) -> tuple[_End, _End2]:
        """Open the endpoints of a server or a client: for requests, and for responses."""
        is_client = key == CLIENT_KEY
        waiting, sending = waiting_qos(qos, is_client=is_client), sending_qos(qos, is_client=is_client)
        identifier = end_id(self._native.gid, next(self._service_end_numbers))
        topic = response_topic(service)
        user_data = end_user_data(key, identifier, service.response_hash)
        # The end for responses comes first: a client's reader should be known to its peers when its first request is.
        responses = self._open(
            answering, topic.name, topic, waiting if answering is CycloneReader else sending, user_data
        )
        topic = request_topic(service)
        user_data = end_user_data(key, identifier, service.request_hash)
        try:
            requests = self._open(
                asking, topic.name, topic, waiting if asking is CycloneReader else sending, user_data
            )
        except WireError:
            responses.close()  # or peers would see half of a client or a server
            raise
        self._remember(node, requests, responses)  # together, so that the list of nodes is published once
        return requests, responses

    def _find_node(self, gid: bytes) -> str:
        """Return the full name of the node with an endpoint; empty if it is unknown."""
        node = next((end.node for end in self.graph.raw_endpoints() if end.gid == gid), None)
        return "" if node is None else node.full

    def _open(self, kind: type[_End], dds_name: str, topic: Topic, qos: QoS, user_data: bytes) -> _End:
        if self._is_forked:
            refuse(f"the participant that {topic.name} would be opened with")
        if self.is_closed:
            raise ClosedError(f"cannot open {topic.name}: its participant is closed")
        try:
            native = kind.native_type(
                self._native, dds_name, type_to_dds(topic.type_name), qos.resolved(), user_data
            )
        except RuntimeError as error:
            raise WireError(str(error)) from None
        return kind(native, topic.name, self._forget)

    def _remember(self, node: NodeName, *ends: CycloneEndpoint) -> None:
        with self._lock:
            self._node_by_end.update(dict.fromkeys(ends, node))
            self._publish_nodes()

    def _forget(self, end: CycloneEndpoint) -> None:
        """Remove a closing endpoint from its node's list."""
        # In a forked child there is nothing to publish: the endpoint is the parent's, and still open there.
        if self._is_forked:
            return
        with self._lock:
            if self._node_by_end.pop(end, None) is not None:
                self._publish_nodes()

    def invalidate_after_fork(self) -> bool:
        """Become the copy of the parent's participant in a forked child; return False if it was closed before."""
        if self.is_closed:
            return False
        self._is_forked = True
        self._lock = threading.Lock()  # a thread of the parent may have held the former one
        self.graph.invalidate_after_fork()
        self._node_list_writer = cast("DdsWriter", Inherited("the list of nodes", self._node_list_writer))
        for end in self._node_by_end:
            end.invalidate_after_fork()
        return True

    def _publish_nodes(self) -> None:
        """Publish the node list: this participant's nodes, and the endpoints of each."""
        # The caller holds the lock, so that lists leave in the order of the changes: a reader keeps the last one only.
        nodes = {node: discovery_info.NodeEnds(node, [], []) for node in self._nodes}
        # An endpoint whose node has been removed is on no list.
        for end, node in self._node_by_end.items():
            if entry := nodes.get(node):
                gids = entry.writer_gids if isinstance(end, CycloneWriter) else entry.reader_gids
                gids.append(end.gid)
        self._node_list_writer.write(
            discovery_info.encode(self._native.gid, [nodes[node] for node in self._nodes])
        )

    def close(self) -> None:
        """Close all writers and readers and leave the domain. Closing again does nothing."""
        if self.is_closed or self._is_forked:
            return
        self.is_closed = True
        # Take the endpoints out of the table first. Each calls `_forget` as it closes, which needs the lock, and would
        # otherwise publish a list of nodes for every endpoint of a participant that leaves anyway.
        with self._lock:
            ends, self._node_by_end = list(self._node_by_end), {}
        for end in ends:
            end.close()
        self._node_list_writer.close()
        self.graph.close()
        self._native.close()
