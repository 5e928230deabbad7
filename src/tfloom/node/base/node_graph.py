"""The names of a node, and its queries of the graph."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from tfloom.node.qos.topic_endpoint_info import TopicEndpointInfo
from tfloom.node.values.exceptions import NodeNameNonExistentError
from tfloom.node.values.names import expansion_error
from tfloom.rmw.base import NodeName

if TYPE_CHECKING:
    from tfloom.node.base.node_names import NodeNames
    from tfloom.rmw.base import EndpointInfo, Graph, ServiceEndInfo

__all__ = ["NodeGraph"]

NamesAndTypes = list[tuple[str, list[str]]]
_POLL_PERIOD_S = 0.02


class NodeGraph:
    """The names of a node, and its queries of the graph. Node's methods of the same names describe each of these.

    Args:
        names: The node's names.
        graph: Graph of its participant.
    """

    def __init__(self, names: NodeNames, graph: Graph) -> None:
        self._names = names
        self._graph = graph

    def get_name(self) -> str:
        """Return the node's name."""
        return self._names.node.name

    def get_namespace(self) -> str:
        """Return the node's namespace, `/` or `/a/b`."""
        return self._names.node.namespace

    def get_fully_qualified_name(self) -> str:
        """Return namespace and name."""
        return self._names.node.full

    def resolved(self, name: str, *, only_expand: bool, is_service: bool) -> str | Exception:
        """Return a topic's or a service's full name, remapped unless `only_expand`, or the error of the name."""
        return self._names.resolved(name, only_expand=only_expand, is_service=is_service)

    def query_error(self, name: object, *, is_service: bool = False) -> Exception | None:
        """Return the error of a name in a query, or None."""
        if (error := expansion_error(name)) is not None:
            return error
        resolved = self._names.resolved(str(name), only_expand=False, is_service=is_service)
        return resolved if isinstance(resolved, Exception) else None

    def get_node_names(self) -> list[str]:
        """Return the names of all nodes, without their namespaces."""
        return [node.name for node in self._graph.nodes()]

    def get_fully_qualified_node_names(self) -> list[str]:
        """Return the full names of all nodes."""
        return [node.full for node in self._graph.nodes()]

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """Return names and namespaces of all nodes."""
        return [(node.name, node.namespace) for node in self._graph.nodes()]

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        """Return names, namespaces and enclaves of all nodes."""
        return [(node.name, node.namespace, enclave) for node, enclave in self._graph.enclaves()]

    def wait_for_node(self, fully_qualified_node_name: str, timeout: float) -> bool:
        """Wait until a node is on the graph; False if it isn't after `timeout` [s]."""
        end = time.monotonic() + timeout
        full_name = fully_qualified_node_name
        if not full_name.startswith("/"):
            full_name = f"/{full_name}"
        while full_name not in self.get_fully_qualified_node_names():
            if time.monotonic() >= end:
                return False
            time.sleep(_POLL_PERIOD_S)
        return True

    def get_topic_names_and_types(self, no_demangle: bool = False) -> NamesAndTypes:
        """Return all topics, and the types they are written or read as."""
        return self._names_and_types(lambda _: True, no_demangle)

    def get_publisher_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Return the topics that a node publishes, with their types; `no_demangle` as in the above."""
        return self._of_node(node_name, node_namespace, True, no_demangle)

    def get_subscriber_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Return the topics that a node subscribes to, with their types; `no_demangle` as in the above."""
        return self._of_node(node_name, node_namespace, False, no_demangle)

    def _of_node(self, name: str, namespace: str, is_writer: bool, no_demangle: bool) -> NamesAndTypes:
        self._check_node(name, namespace)
        return self._names_and_types(
            lambda info: (
                info.is_writer == is_writer
                and info.node is not None
                and (info.node.name, info.node.namespace) == (name, namespace)
            ),
            no_demangle,
        )

    def _names_and_types(self, matches: Callable[[EndpointInfo], bool], no_demangle: bool) -> NamesAndTypes:
        types_by_name: dict[str, set[str]] = {}
        for info in self._graph.raw_endpoints() if no_demangle else self._graph.endpoints():
            if matches(info):
                types_by_name.setdefault(info.topic.name, set()).add(info.topic.type_name)
        return [(name, sorted(types)) for name, types in sorted(types_by_name.items())]

    def get_service_names_and_types(self) -> NamesAndTypes:
        """Return all services that have a server, with their types."""
        return self._services(lambda info: info.is_server)

    def get_service_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the services that a node serves, with their types; RuntimeError if there is no such node."""
        return self._services_of(node_name, node_namespace, True)

    def get_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the services that a node is a client of; RuntimeError if there is no such node."""
        return self._services_of(node_name, node_namespace, False)

    def count_services(self, service_name: str) -> int:
        """Return how many servers a service has; the name is expanded and remapped."""
        return self._count_service_ends(service_name, True)

    def count_clients(self, service_name: str) -> int:
        """Return how many clients a service has; the name is expanded and remapped."""
        return self._count_service_ends(service_name, False)

    def _count_service_ends(self, service_name: str, is_server: bool) -> int:
        self._names.expand(service_name)  # a name that isn't valid has rclpy's error of an expansion
        name = self._names.resolve(service_name, is_service=True)
        ends = self._graph.service_ends()
        return sum(info.name == name and info.is_server == is_server for info in ends)

    def _services_of(self, name: str, namespace: str, is_server: bool) -> NamesAndTypes:
        self._check_node(name, namespace)
        return self._services(
            lambda info: info.is_server == is_server and info.node == NodeName(namespace, name)
        )

    def _services(self, matches: Callable[[ServiceEndInfo], bool]) -> NamesAndTypes:
        types_by_name: dict[str, set[str]] = {}
        for info in self._graph.service_ends():
            if matches(info):
                types_by_name.setdefault(info.name, set()).add(info.type_name)
        return [(name, sorted(types)) for name, types in sorted(types_by_name.items())]

    def _check_node(self, name: str, namespace: str) -> None:
        if not (isinstance(name, str) and isinstance(namespace, str)):
            raise TypeError(f"name and namespace of a node must be str, not {name!r} and {namespace!r}")
        if (name, namespace) not in self.get_node_names_and_namespaces():
            raise NodeNameNonExistentError(f"no node '{namespace.rstrip('/')}/{name}' on the graph")

    def count_publishers(self, topic_name: str) -> int:
        """Return how many publishers a topic has, of all nodes; the name is expanded and remapped."""
        return len(self._endpoints_of(self._full_topic_name(topic_name), True))

    def count_subscribers(self, topic_name: str) -> int:
        """Return how many subscriptions a topic has, of all nodes; the name is expanded and remapped."""
        return len(self._endpoints_of(self._full_topic_name(topic_name), False))

    def get_publishers_info_by_topic(
        self, topic_name: str, no_mangle: bool = False
    ) -> list[TopicEndpointInfo]:
        """Return the publishers of a topic."""
        return self._infos(topic_name, True, no_mangle)

    def get_subscriptions_info_by_topic(
        self, topic_name: str, no_mangle: bool = False
    ) -> list[TopicEndpointInfo]:
        """Return the subscriptions of a topic."""
        return self._infos(topic_name, False, no_mangle)

    def _infos(self, topic_name: str, is_writer: bool, no_mangle: bool) -> list[TopicEndpointInfo]:
        name = topic_name if no_mangle else self._full_topic_name(topic_name)
        return [TopicEndpointInfo.from_graph(info) for info in self._endpoints_of(name, is_writer, no_mangle)]

    def _full_topic_name(self, topic_name: str) -> str:
        self._names.expand(topic_name)  # a name that isn't valid has rclpy's error of an expansion
        return self._names.resolve(topic_name, is_service=False)

    def _endpoints_of(self, name: str, is_writer: bool, no_mangle: bool = False) -> list[EndpointInfo]:
        return [
            info
            for info in (self._graph.raw_endpoints() if no_mangle else self._graph.endpoints())
            if info.topic.name == name and info.is_writer == is_writer
        ]
