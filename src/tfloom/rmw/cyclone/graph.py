"""The graph, from DDS discovery and the participants' node lists."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any, NamedTuple, cast

from tfloom._native import DdsGraph, DdsParticipant, ReadyQueue
from tfloom.rmw.base import EndpointInfo, NodeName, ParticipantInfo, ServiceEndInfo, Topic
from tfloom.rmw.cyclone import discovery_info
from tfloom.rmw.cyclone.ports import bound_indices, process_count
from tfloom.rmw.forks import Inherited
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoS, ReliabilityPolicy
from tfloom.rmw.topic_names import (
    key_values,
    service_from_request_topic,
    topic_from_dds,
    type_from_dds,
    type_to_dds,
)

FAST_DDS = bytes([1, 0x0F])
"""The vendor of Fast DDS: the first bytes of the gids of its participants and endpoints."""

NODE_LIST_USER_DATA = f"typehash={discovery_info.TYPE_HASH};".encode()

_READ_ALL = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_ALL)


class _View(NamedTuple):
    """The graph at one count of changes."""

    changes: int
    enclaves: list[tuple[NodeName, str]]
    process_count: int
    is_whole: bool
    late: frozenset[bytes]
    """The participants of Fast DDS of which a node list is to come, or an endpoint on it."""
    raw_endpoints: list[EndpointInfo]
    endpoints: list[EndpointInfo]
    service_ends: list[ServiceEndInfo]


class _Endpoint(NamedTuple):
    """A writer or reader, by DDS's names, and by those of its topic or service as far as these are ROS's."""

    announced: tuple[Any, ...]
    raw: EndpointInfo
    info: EndpointInfo | None
    service_end: ServiceEndInfo | None


class CycloneGraph:
    """All that a participant has discovered; see `base.Graph`."""

    def __init__(self, participant: DdsParticipant, domain_id: int) -> None:
        self._domain_id = domain_id
        self._own_gid = participant.gid
        self._native = DdsGraph(
            participant,
            discovery_info.TOPIC_NAME,
            type_to_dds(discovery_info.TYPE_NAME),
            _READ_ALL,
            NODE_LIST_USER_DATA,
        )
        self._lock = threading.Lock()
        self._view = _View(-1, [], 0, False, frozenset(), [], [], [])
        self._endpoints: dict[bytes, _Endpoint] = {}
        """Those of the view, by gid: a change concerns few of them, so the others are not decoded anew."""

    def nodes(self) -> list[NodeName]:
        """Return the nodes, one entry for each, in order of their full names."""
        return [node for node, _ in self._current().enclaves]

    def enclaves(self) -> list[tuple[NodeName, str]]:
        """Return the nodes as `nodes` does, each with the enclave it is in; empty if unknown."""
        return list(self._current().enclaves)

    def raw_endpoints(self) -> list[EndpointInfo]:
        """Return all writers and readers, by DDS's names of topics and types, in order of these."""
        return list(self._current().raw_endpoints)

    def endpoints(self) -> list[EndpointInfo]:
        """Return writers and readers of ROS topics, in order of topic name."""
        return list(self._current().endpoints)

    def service_ends(self) -> list[ServiceEndInfo]:
        """Return servers and clients, in order of service name."""
        return list(self._current().service_ends)

    def participants(self) -> list[ParticipantInfo]:
        """Return the participants, this one included, in order of their gids."""
        participants, _ = self._native.snapshot()
        return sorted(
            ParticipantInfo(gid, [ends.name for ends in _decoded(node_list)], gid == self._own_gid)
            for gid, _, node_list in participants
        )

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` whenever the graph has changed; None ends it."""
        self._native.notify(queue, token)

    def changes(self) -> int:
        """Return a number that grows with each change."""
        return self._native.changes()

    def is_whole(self) -> bool:
        """Return whether all that is announced has arrived.

        These are the node list of each ROS participant, each endpoint on it, and a participant of each process on this
        machine that holds ports of the domain: one that is scheduled late answers late.
        """
        view = self._current()
        return view.is_whole and view.process_count >= len(bound_indices(self._domain_id))

    def delivers_incompatible(self) -> bool:
        """Return False: such endpoints aren't connected."""
        return False

    def late_count(self) -> int:
        """Return how many participants of Fast DDS have not sent their node lists, or not all endpoints on them.

        Fast DDS sends both when it discovers this participant. What arrives before its sender is discovered here is
        dropped. It is repeated with the next heartbeat: endpoints after 1 s, and then node lists at once, because the
        discovery of their writer prompts one.
        """
        return len(self._current().late)

    def invalidate_after_fork(self) -> None:
        """Become the copy of the parent's graph in a forked child."""
        self._native = cast("DdsGraph", Inherited("the graph", self._native))

    def close(self) -> None:
        """Stop listening."""
        self._native.close()

    def _current(self) -> _View:
        with self._lock:
            changes = self._native.changes()
            if changes != self._view.changes:
                self._view = self._read(changes)
            return self._view

    def _read(self, changes: int) -> _View:
        # First the node lists: they say which node each endpoint belongs to, by its gid. A ROS participant announces an
        # enclave; one that has, and has sent no list yet, makes the view incomplete.
        participants, endpoints = self._native.snapshot()
        enclaves: list[tuple[NodeName, str]] = []
        node_of: dict[bytes, NodeName] = {}
        is_whole = True
        silent: set[bytes] = set()
        listed_by: dict[bytes, bytes] = {}
        for participant, participant_data, node_list in participants:
            values = key_values(participant_data)
            enclave = values.get("enclave", "")
            if "enclave" in values and not node_list:
                is_whole = False
                silent.add(participant)
            for ends in _decoded(node_list):
                enclaves.append((ends.name, enclave))
                gids = (*ends.reader_gids, *ends.writer_gids)
                node_of.update(dict.fromkeys(gids, ends.name))
                listed_by.update(dict.fromkeys(gids, participant))
        # Then the endpoints, of which those that are as before are known.
        before, self._endpoints = self._endpoints, {}
        for announced in endpoints:
            gid = announced[0]
            endpoint = before.get(gid)
            if endpoint is None or endpoint.announced != announced or endpoint.raw.node != node_of.get(gid):
                endpoint = _endpoint(announced, node_of.get(gid))
            self._endpoints[gid] = endpoint
        raw = [endpoint.raw for endpoint in self._endpoints.values()]
        infos = [endpoint.info for endpoint in self._endpoints.values() if endpoint.info]
        service_ends = [endpoint.service_end for endpoint in self._endpoints.values() if endpoint.service_end]
        # What is on a list and was not discovered is still to come.
        to_come = node_of.keys() - self._endpoints.keys()
        is_whole = is_whole and not to_come
        late = frozenset(
            gid for gid in silent.union(listed_by[end] for end in to_come) if gid.startswith(FAST_DDS)
        )
        enclaves.sort(key=lambda node: node[0].full)
        raw.sort(key=lambda info: info.topic.name)
        infos.sort(key=lambda info: info.topic.name)
        service_ends.sort(key=lambda end: end.name)
        processes = process_count(participant for participant, _, _ in participants)
        return _View(changes, enclaves, processes, is_whole, late, raw, infos, service_ends)


def _endpoint(announced: tuple[Any, ...], node: NodeName | None) -> _Endpoint:
    """Return an endpoint of a snapshot of the graph, with its node."""
    gid, _, is_writer, dds_topic, dds_type, user_data, qos = announced
    dds_name = dds_topic.decode("utf-8", "replace")
    dds_topic_type = dds_type.decode("utf-8", "replace")
    type_name = type_from_dds(dds_topic_type)
    topic = Topic(dds_name, dds_topic_type, key_values(user_data).get("typehash", ""))
    raw = EndpointInfo(topic, node, is_writer, gid, _qos(qos))
    if name := topic_from_dds(dds_name):
        info = raw._replace(topic=topic._replace(name=name, type_name=type_name))
        return _Endpoint(announced, raw, info, None)
    # A service counts once, by its topic of requests: its reader is a server, its writer a client.
    service = service_from_request_topic(dds_name, type_name)
    service_end = (
        ServiceEndInfo(
            *service,
            node,
            is_server=not is_writer,
            gid=gid,
            qos=raw.qos,
            type_hash=key_values(user_data).get("sertypehash", ""),
        )
        if service
        else None
    )
    return _Endpoint(announced, raw, None, service_end)


def _decoded(node_list: bytes) -> list[discovery_info.NodeEnds]:
    """Return the nodes in a list from the wire; empty before the first list, or for one that can't be decoded."""
    if not node_list:
        return []
    try:
        return discovery_info.decode(node_list)[1]
    except discovery_info.NodeListError:
        return []


_KINDS: tuple[Callable[[int], Any], ...] = (
    *(ReliabilityPolicy, DurabilityPolicy, HistoryPolicy, int),
    *(int, int, LivelinessPolicy, int),
)
"""The classes of the fields of `QoS`, in their order."""


def _qos(fields: tuple[int, ...]) -> QoS:
    return QoS(*(kind(field) for kind, field in zip(_KINDS, fields, strict=True)))
