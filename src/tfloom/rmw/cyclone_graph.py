"""The graph, from DDS discovery and the participants' node lists."""

from __future__ import annotations

import threading
from typing import NamedTuple

from tfloom._native import DdsGraph, DdsParticipant, ReadyQueue
from tfloom.rmw import node_lists
from tfloom.rmw.base import EndpointInfo, NodeName, ServiceEndInfo, Topic
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoS, ReliabilityPolicy
from tfloom.rmw.topic_names import (
    key_values,
    service_from_request_topic,
    topic_from_dds,
    type_from_dds,
    type_to_dds,
)

NODE_LIST_USER_DATA = f"typehash={node_lists.TYPE_HASH};".encode()

_READ_ALL = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_ALL)


class _View(NamedTuple):
    """The graph at one count of changes."""

    changes: int
    enclaves: list[tuple[NodeName, str]]
    is_whole: bool
    raw_endpoints: list[EndpointInfo]
    endpoints: list[EndpointInfo]
    service_ends: list[ServiceEndInfo]


class CycloneGraph:
    """All that a participant has discovered; see `base.Graph`."""

    def __init__(self, participant: DdsParticipant) -> None:
        self._native = DdsGraph(
            participant,
            node_lists.TOPIC_NAME,
            type_to_dds(node_lists.TYPE_NAME),
            _READ_ALL,
            NODE_LIST_USER_DATA,
        )
        self._lock = threading.Lock()
        self._view = _View(-1, [], False, [], [], [])

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

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` whenever the graph has changed; None ends it."""
        self._native.notify(queue, token)

    def changes(self) -> int:
        """Return a number that grows with each change."""
        return self._native.changes()

    def is_whole(self) -> bool:
        """Return whether each listed endpoint has arrived, and the node list of each participant with endpoints."""
        return self._current().is_whole

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
        participants, endpoints = self._native.snapshot()
        enclaves: list[tuple[NodeName, str]] = []
        node_of: dict[bytes, NodeName] = {}
        silent: set[bytes] = set()  # ROS participants without a node list so far
        for participant, participant_data, node_list in participants:
            values = key_values(participant_data)
            enclave = values.get("enclave", "")
            if "enclave" in values and not node_list:
                silent.add(participant)
            for ends in _decoded(node_list):
                enclaves.append((ends.name, enclave))
                node_of.update(dict.fromkeys((*ends.reader_gids, *ends.writer_gids), ends.name))
        raw: list[EndpointInfo] = []
        infos: list[EndpointInfo] = []
        service_ends: list[ServiceEndInfo] = []
        is_whole = True
        for gid, participant, is_writer, dds_topic, dds_type, user_data, qos in endpoints:
            dds_name = dds_topic.decode("utf-8", "replace")
            dds_topic_type = dds_type.decode("utf-8", "replace")
            type_name = type_from_dds(dds_topic_type)
            topic = Topic(dds_name, dds_topic_type, key_values(user_data).get("typehash", ""))
            info = EndpointInfo(topic, node_of.get(gid), is_writer, gid, _qos(*qos))
            raw.append(info)
            is_whole = is_whole and not (participant in silent and dds_name.startswith(("rt/", "rq/", "rr/")))
            if name := topic_from_dds(dds_name):
                infos.append(info._replace(topic=topic._replace(name=name, type_name=type_name)))
            elif service := service_from_request_topic(dds_name, type_name):
                service_ends.append(
                    ServiceEndInfo(*service, info.node, is_server=not is_writer, gid=gid, qos=info.qos)
                )
        is_whole = is_whole and node_of.keys() <= {info.gid for info in raw}
        enclaves.sort(key=lambda node: node[0].full)
        raw.sort(key=lambda info: info.topic.name)
        infos.sort(key=lambda info: info.topic.name)
        service_ends.sort(key=lambda end: end.name)
        return _View(changes, enclaves, is_whole, raw, infos, service_ends)


def _decoded(node_list: bytes) -> list[node_lists.NodeEnds]:
    """Return the nodes in a list from the wire; empty before the first list, or for one that can't be decoded."""
    if not node_list:
        return []
    try:
        return node_lists.decode(node_list)[1]
    except node_lists.NodeListError:
        return []


def _qos(
    reliability: int,
    durability: int,
    history: int,
    depth: int,
    deadline_ns: int,
    lifespan_ns: int,
    liveliness: int,
    liveliness_lease_ns: int,
) -> QoS:
    return QoS(
        ReliabilityPolicy(reliability),
        DurabilityPolicy(durability),
        HistoryPolicy(history),
        depth,
        deadline_ns,
        lifespan_ns,
        LivelinessPolicy(liveliness),
        liveliness_lease_ns,
    )
