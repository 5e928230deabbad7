"""The wire of rmw_zenoh: topics, services and the graph over eclipse-zenoh.

Keys and tokens are in `tokens`, the session in `session`. Nothing here holds a lock during a call of Zenoh:
own tokens, samples and requests arrive within it.
"""

from __future__ import annotations

import os
import threading
from itertools import count
from typing import Any, TypeVar
from weakref import WeakSet

from tfloom.common.signals import signals_deferred
from tfloom.rmw.base import EndpointInfo, NodeName, Participant, Service, Topic
from tfloom.rmw.compatibility import chosen_qos
from tfloom.rmw.errors import ClosedError, WireError
from tfloom.rmw.forks import forbid_children
from tfloom.rmw.qos import QoS
from tfloom.rmw.zenoh.config import reason_of
from tfloom.rmw.zenoh.end import end_declarations
from tfloom.rmw.zenoh.endpoints import ZenohReader, ZenohWriter
from tfloom.rmw.zenoh.events import Timers
from tfloom.rmw.zenoh.graph import ZenohGraph
from tfloom.rmw.zenoh.library import open_library
from tfloom.rmw.zenoh.services import ServiceEndpoint, ZenohRequester, ZenohResponder
from tfloom.rmw.zenoh.session import FORK_ADVICE, ZenohSession, open_session, refuse_fork
from tfloom.rmw.zenoh.tokens import End, Kind, Token, data_key, gid_of, token_key, wire_qos

_TopicEnd = TypeVar("_TopicEnd", ZenohWriter, ZenohReader)
_ServiceEnd = TypeVar("_ServiceEnd", ZenohRequester, ZenohResponder)
_AnyEnd = ZenohWriter | ZenohReader | ZenohRequester | ZenohResponder

_KINDS: dict[type, Kind] = {
    ZenohWriter: Kind.PUBLISHER,
    ZenohReader: Kind.SUBSCRIPTION,
    ZenohRequester: Kind.CLIENT,
    ZenohResponder: Kind.SERVER,
}

_open_participants: WeakSet[ZenohParticipant] = WeakSet()


def open_participant(domain_id: int, enclave: str = "/") -> Participant:
    """Join a domain.

    Args:
        domain_id: 0 to 232.
        enclave: Security enclave to announce.

    Raises:
        NoBackendError: eclipse-zenoh or xxhash isn't installed.
        ConfigurationError: a variable is invalid.
        ForkedError: this process was forked from one with a session.
        WireError: Zenoh can't open a session.
    """
    session = open_session(domain_id)
    try:
        participant = ZenohParticipant(domain_id, enclave, session)
    except BaseException:
        session.close()
        raise
    _open_participants.add(participant)
    forbid_children(FORK_ADVICE)
    return participant


def _invalidate_all_after_fork() -> None:
    for participant in list(_open_participants):
        participant.invalidate_after_fork()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_invalidate_all_after_fork)


class _OwnToken:
    """A token of this session, which is on its own graph until it is undeclared."""

    def __init__(self, token: Any, key: str, graph: ZenohGraph) -> None:
        self._token = token
        self._key = key
        self._graph = graph

    def undeclare(self) -> None:
        """Remove the entity from the graph, here and for the others."""
        self._graph.remove_own(self._key)
        self._token.undeclare()


class ZenohParticipant:
    """This process on one domain; see `base.Participant`.

    Args:
        domain_id: The domain.
        enclave: Security enclave to announce.
        session: Closed with the participant.
    """

    def __init__(self, domain_id: int, enclave: str, session: ZenohSession) -> None:
        self.domain_id = domain_id
        self.enclave = enclave
        self._session = session
        self._zid = session.zid
        self._lock = threading.Lock()
        self._numbers = count()
        """Of nodes and endpoints alike."""
        self._nodes: list[tuple[NodeName, int, Any]] = []
        """Each node with its number and its token."""
        self._ends: set[_AnyEnd] = set()
        self._timers = Timers()
        self.is_closed = False
        self._is_forked = False
        self.graph = ZenohGraph(
            session.session,
            domain_id,
            self._zid,
            open_client=session.open_client if session.endpoints and not session.is_meeting_point else None,
        )

    def add_node(self, node: NodeName) -> None:
        """Add a node to the graph.

        Raises:
            ClosedError: the participant is closed.
        """
        self._check_open(f"add the node {node.full}")
        number = next(self._numbers)
        key = token_key(Token(self.domain_id, self._zid, number, number, Kind.NODE, self.enclave, node, None))
        token = self._declare_token(key)
        with self._lock:
            self._nodes.append((node, number, token))

    def remove_node(self, node: NodeName) -> None:
        """Remove a node from the graph.

        Raises:
            ValueError: this participant has no such node.
        """
        if self._is_forked:
            return
        with self._lock:
            entry = next((entry for entry in self._nodes if entry[0] == node), None)
            if entry is None:
                raise ValueError(f"{node.full} is not a node of this participant")
            self._nodes.remove(entry)
        end_declarations([entry[2]])

    def create_writer(self, node: NodeName, topic: Topic, qos: QoS) -> ZenohWriter:
        """Open a writer of a topic for `node`.

        Raises:
            WireError: its type's hash is unknown, or Zenoh refuses it.
        """
        if not topic.type_hash:
            raise WireError(
                f"cannot write to {topic.name}: the hash of {topic.type_name} is unknown, and the key has it on Zenoh"
            )
        return self._open_topic(ZenohWriter, node, topic, qos)

    def create_reader(self, node: NodeName, topic: Topic, qos: QoS) -> ZenohReader:
        """Open a reader of a topic for `node`. Without the type's hash, it receives from writers of each hash.

        Raises:
            WireError: Zenoh refuses it.
        """
        return self._open_topic(ZenohReader, node, topic, qos)

    def create_requester(self, node: NodeName, service: Service, qos: QoS) -> ZenohRequester:
        """Open a client of a service for `node`.

        Raises:
            WireError: its type's hash is unknown, or Zenoh refuses it.
        """
        return self._open_service(ZenohRequester, node, service, qos)

    def create_responder(self, node: NodeName, service: Service, qos: QoS) -> ZenohResponder:
        """Open a server of a service for `node`.

        Raises:
            WireError: its type's hash is unknown, or Zenoh refuses it.
        """
        return self._open_service(ZenohResponder, node, service, qos)

    def _open_topic(self, kind: type[_TopicEnd], node: NodeName, topic: Topic, qos: QoS) -> _TopicEnd:
        self._check_open(f"open {topic.name}")
        is_writer = kind is ZenohWriter
        qos = wire_qos(chosen_qos(qos, self.graph, topic.name, is_writer=is_writer))
        key = self._token_key(kind, node, End(topic.name, topic.type_name, topic.type_hash, qos))
        info = EndpointInfo(topic, node, is_writer, gid_of(key), qos)
        end = kind(info, self.graph, self._timers, self._forget)
        type_hash = "" if topic.other_hash else topic.type_hash
        self._open(end, key, data_key(self.domain_id, topic.name, topic.type_name, type_hash))
        try:
            end.start_timers()
        except RuntimeError as error:
            end.close()
            raise WireError(
                f"cannot watch the deadline of {topic.name}, which takes a thread: {error}"
            ) from None
        return end

    def _open_service(
        self, kind: type[_ServiceEnd], node: NodeName, service: Service, qos: QoS
    ) -> _ServiceEnd:
        self._check_open(f"open {service.name}")
        if not service.type_hash:
            raise WireError(
                f"cannot open {service.name}: the hash of {service.type_name} is unknown, and the key has it on Zenoh"
            )
        qos = wire_qos(qos)
        key = self._token_key(kind, node, End(service.name, service.type_name, service.type_hash, qos))
        end = kind(ServiceEndpoint(gid_of(key), node, service, qos, self._timers), self.graph, self._forget)
        self._open(end, key, data_key(self.domain_id, service.name, service.type_name, service.type_hash))
        return end

    def _token_key(self, kind: type, node: NodeName, end: End) -> str:
        with self._lock:
            own = next((number for name, number, _ in self._nodes if name == node), None)
        node_number = next(self._numbers) if own is None else own
        token = Token(
            self.domain_id, self._zid, node_number, next(self._numbers), _KINDS[kind], self.enclave, node, end
        )
        return token_key(token)

    def _open(self, end: Any, token_text: str, key: str) -> None:
        """Open what Zenoh has of an endpoint, and then announce it."""
        zenoh = open_library()
        declared: list[Any] = []
        try:
            with signals_deferred():
                declared.insert(0, end.declare(self._session.session, key))
            # Known to its peers from the token on, which comes second, so that it is ready when they know of it.
            declared.insert(0, self._declare_token(token_text))
        except zenoh.ZError as error:
            end_declarations(declared)
            raise WireError(f"cannot open {end.watched_name}: {reason_of(error)}") from None
        except BaseException:
            end_declarations(declared)
            raise
        end.adopt(*declared)
        self.graph.watch(end)
        with self._lock:
            self._ends.add(end)
            is_late = self.is_closed
        if is_late:
            end.close()
            raise ClosedError(f"cannot open {end.watched_name}: its participant is closed")

    def _declare_token(self, key: str) -> Any:
        zenoh = open_library()
        try:
            with signals_deferred():
                token = self._session.session.liveliness().declare_token(key)
        except zenoh.ZError as error:
            raise WireError(f"cannot announce {key}: {reason_of(error)}") from None
        self.graph.add_own(key)
        return _OwnToken(token, key, self.graph)

    def _forget(self, end: _AnyEnd) -> None:
        with self._lock:
            self._ends.discard(end)

    def _check_open(self, what: str) -> None:
        if self._is_forked:
            refuse_fork("the participant")
        if self.is_closed:
            raise ClosedError(f"cannot {what}: its participant is closed")

    def invalidate_after_fork(self) -> None:
        """Become the copy of the parent's participant in a forked child."""
        if self.is_closed:
            return
        self._is_forked = True
        self._lock = threading.Lock()
        self.graph.invalidate_after_fork()
        for end in list(self._ends):
            end.invalidate_after_fork()
        _kept_after_fork.append(self)

    def close(self) -> None:
        """Close all writers and readers and leave the domain. Closing again does nothing."""
        if self._is_forked:
            return
        with self._lock:
            if self.is_closed:
                return
            self.is_closed = True
            ends, nodes = list(self._ends), list(self._nodes)
            self._nodes.clear()
        for end in ends:
            end.close()
        end_declarations([token for _, _, token in nodes])
        self._timers.close()
        self.graph.close()
        self._session.close()


_kept_after_fork: list[ZenohParticipant] = []
"""What a child has inherited: Zenoh's objects can't be freed there, because their threads are the parent's."""
