"""The names of a node, and its queries of the graph, until it is destroyed."""

from __future__ import annotations

import math
import time
from collections.abc import Iterable
from typing import TYPE_CHECKING

from tfloom.node.qos.endpoint_info import ServiceEndpointInfo, TopicEndpointInfo
from tfloom.node.values.exceptions import InvalidHandle, NodeNameNonExistentError
from tfloom.node.values.names import expansion_error
from tfloom.rmw.base import PREFIX_LENGTH, NodeName, Service
from tfloom.rmw.topic_names import response_topic
from tfloom.rmw.typed_names import FEEDBACK

if TYPE_CHECKING:
    from tfloom.node.base.node_names import NodeNames
    from tfloom.rmw.base import EndpointInfo, Graph, ServiceEndInfo

__all__ = ["NamesAndTypes", "NodeGraph", "actions_of_topics", "service_endpoints"]

NamesAndTypes = list[tuple[str, list[str]]]
_POLL_PERIOD_S = 0.02
FEEDBACK_TYPE_SUFFIX = "_FeedbackMessage"


class NodeGraph:
    """The names of a node, and its queries of the graph, which are by full names.

    Args:
        names: The node's names.
        graph: Graph of its participant.
    """

    def __init__(self, names: NodeNames, graph: Graph) -> None:
        self._names = names
        self._graph = graph
        self._has_left = False

    @property
    def node(self) -> NodeName:
        """Name and namespace of the node.

        Raises:
            InvalidHandle: the node was destroyed, as in all methods below.
        """
        return self._existing_names().node

    @property
    def wire_graph(self) -> Graph:
        """Graph of its participant."""
        self._existing_names()
        return self._graph

    def _existing_names(self) -> NodeNames:
        if self._has_left:
            raise InvalidHandle(f"cannot use the node {self._names.node.full}: it was destroyed")
        return self._names

    def check_exists(self) -> None:
        """Raise InvalidHandle if the node was destroyed."""
        self._existing_names()

    def leave(self) -> None:
        """Answer no longer, because the node is destroyed."""
        self._has_left = True

    def resolved(self, name: str, *, only_expand: bool, is_service: bool) -> str | Exception:
        """Return a topic's or a service's full name, remapped unless `only_expand`, or the error of the name."""
        return self._existing_names().resolved(name, only_expand=only_expand, is_service=is_service)

    def queried_name(self, name: object, *, is_service: bool = False) -> str:
        """Return the full name of a topic or service in a query, expanded and remapped.

        Raises:
            NameValidationException: the name isn't valid; the text is rclpy's of an expansion.
            TypeError: the name is not a str.
        """
        if (error := expansion_error(name)) is not None:
            raise error
        full_name = self._existing_names().resolved(str(name), only_expand=False, is_service=is_service)
        if isinstance(full_name, Exception):
            raise full_name
        return full_name

    def wait_for_node(self, full_name: str, timeout_s: float | None) -> bool:
        """Wait until a node is on the graph; False if it isn't after `timeout_s` (None: no limit).

        Without time, a node that was destroyed answers False, as that of rclpy does.
        """
        if timeout_s == 0.0 and self._has_left:
            return False
        end = math.inf if timeout_s is None else time.monotonic() + timeout_s
        if not full_name.startswith("/"):
            full_name = f"/{full_name}"
        while all(node.full != full_name for node in self.wire_graph.nodes()):
            if time.monotonic() >= end:
                return False
            time.sleep(_POLL_PERIOD_S)
        return True

    def topics(self, no_demangle: bool) -> NamesAndTypes:
        """Return all topics, and the types they are written or read as."""
        return _topics(self._all_endpoints(no_demangle))

    def topics_of_node(
        self, name: str, namespace: str, *, is_writer: bool, no_demangle: bool
    ) -> NamesAndTypes:
        """Return the topics that a node writes, or reads, with their types.

        Raises:
            NodeNameNonExistentError: there is no such node.
        """
        node = self._existing_node(name, namespace)
        ends = self._all_endpoints(no_demangle)
        return _topics(info for info in ends if info.is_writer == is_writer and info.node == node)

    def services(self) -> NamesAndTypes:
        """Return all services that have a server, with their types."""
        return _services(info for info in self.wire_graph.service_ends() if info.is_server)

    def services_of_node(self, name: str, namespace: str, *, is_server: bool) -> NamesAndTypes:
        """Return the services that a node serves, or is a client of, with their types.

        Raises:
            NodeNameNonExistentError: there is no such node.
        """
        node = self._existing_node(name, namespace)
        ends = self.wire_graph.service_ends()
        return _services(info for info in ends if info.is_server == is_server and info.node == node)

    def _existing_node(self, name: str, namespace: str) -> NodeName:
        if not (isinstance(name, str) and isinstance(namespace, str)):
            raise TypeError(f"name and namespace of a node must be str, not {name!r} and {namespace!r}")
        node = NodeName(namespace, name)
        if node not in self.wire_graph.nodes():
            raise NodeNameNonExistentError(f"no node '{namespace.rstrip('/')}/{name}' on the graph")
        return node

    def service_end_count(self, name: str, *, is_server: bool) -> int:
        """Return how many servers, or clients, a service has."""
        ends = self.wire_graph.service_ends()
        return sum(info.name == name and info.is_server == is_server for info in ends)

    def endpoints(self, name: str, *, is_writer: bool, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """Return the writers, or the readers, of a topic; `no_mangle`: by DDS's own name."""
        return [
            TopicEndpointInfo.from_graph(info)
            for info in self._all_endpoints(no_mangle)
            if info.topic.name == name and info.is_writer == is_writer
        ]

    def service_endpoints(
        self, name: str, *, is_server: bool, no_mangle: bool = False
    ) -> list[ServiceEndpointInfo]:
        """Return the servers, or the clients, of a service; `no_mangle`: by the name of its topic of requests."""
        return service_endpoints(self.wire_graph, name, is_server=is_server, no_mangle=no_mangle)

    def _all_endpoints(self, is_raw: bool) -> list[EndpointInfo]:
        return self.wire_graph.raw_endpoints() if is_raw else self.wire_graph.endpoints()


def service_endpoints(
    graph: Graph, name: str, *, is_server: bool, no_mangle: bool = False
) -> list[ServiceEndpointInfo]:
    """Return the servers, or the clients, of a service on a graph; see `NodeGraph.service_endpoints`."""
    raw = graph.raw_endpoints()
    if no_mangle:
        gids = {info.gid for info in raw if info.topic.name == name}
        ends = [info for info in graph.service_ends() if info.gid in gids]
    else:
        ends = [info for info in graph.service_ends() if info.name == name]
    ends = [info for info in ends if info.is_server == is_server]
    if not ends:
        return []
    # A server writes its responses, a client reads them.
    topic = response_topic(Service(ends[0].name, ends[0].type_name)).name
    responses = [info for info in raw if info.topic.name == topic and info.is_writer == is_server]
    return [
        ServiceEndpointInfo.from_graph(end, response) for end, response in _with_responses(ends, responses)
    ]


def _with_responses(
    ends: Iterable[ServiceEndInfo], responses: Iterable[EndpointInfo]
) -> Iterable[tuple[ServiceEndInfo, EndpointInfo | None]]:
    """Yield each end of a service with its endpoint of responses, in their order within one participant.

    On the wire nothing links the two but the participant, whose id begins the gids of both. It numbers its endpoints in
    the order in which it creates them.
    """
    waiting: dict[bytes, list[EndpointInfo]] = {}
    for response in sorted(responses, key=lambda info: info.gid):
        waiting.setdefault(response.gid[:PREFIX_LENGTH], []).append(response)
    for end in sorted(ends, key=lambda info: info.gid):
        own = waiting.get(end.gid[:PREFIX_LENGTH])
        yield end, own.pop(0) if own else None


def _topics(endpoints: Iterable[EndpointInfo]) -> NamesAndTypes:
    return _grouped((info.topic.name, info.topic.type_name) for info in endpoints)


def actions_of_topics(topics: Iterable[tuple[str, list[str]]]) -> NamesAndTypes:
    """Return the actions among topics, by their feedback topics, which both servers and clients have."""
    return [
        (name.removesuffix(FEEDBACK), [type_name.removesuffix(FEEDBACK_TYPE_SUFFIX) for type_name in types])
        for name, types in topics
        if name.endswith(FEEDBACK)
    ]


def _services(ends: Iterable[ServiceEndInfo]) -> NamesAndTypes:
    return _grouped((info.name, info.type_name) for info in ends)


def _grouped(names_and_types: Iterable[tuple[str, str]]) -> NamesAndTypes:
    types_by_name: dict[str, set[str]] = {}
    for name, type_name in names_and_types:
        types_by_name.setdefault(name, set()).add(type_name)
    return [(name, sorted(types)) for name, types in sorted(types_by_name.items())]
