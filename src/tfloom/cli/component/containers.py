"""The containers of components on the graph, and their services."""

from __future__ import annotations

import argparse
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from typing import Any

from tfloom.cli.shared import graph
from tfloom.cli.shared.calls import NodeServices
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listen import cli_node, shown_node
from tfloom.cli.shared.names import find_full_name
from tfloom.interfaces.composition_interfaces import srv
from tfloom.rmw.base import Graph

TIMEOUT_S = 5.0
"""Longest wait for a container's service, and for the response of those that only list or unload [s]."""
LOAD, UNLOAD, LIST = "_container/load_node", "_container/unload_node", "_container/list_nodes"
SERVICES: dict[str, type[Any]] = {LOAD: srv.LoadNode, UNLOAD: srv.UnloadNode, LIST: srv.ListNodes}
"""The services of a container, by their names below its own."""


class Container(NodeServices):
    """The services of one node that loads others into its process."""

    def components(self) -> dict[int, str]:
        """Return the full names of the loaded nodes by their ids."""
        response = self.call(LIST, srv.ListNodes, srv.ListNodes.Request())
        return dict(zip(response.unique_ids, response.full_node_names, strict=False))

    def load(self, request: srv.LoadNode_Request) -> tuple[int, str]:
        """Load a node; return its id and full name. Loading takes as long as the node's constructor.

        Raises:
            CommandError: the container has rejected it; the text has its reason.
        """
        response = self.call(LOAD, srv.LoadNode, request, float("inf"))
        if not response.success:
            raise CommandError(f"Failed to load component: {response.error_message.capitalize()}")
        return response.unique_id, response.full_node_name

    def unload(self, unique_id: int) -> None:
        """Unload a node.

        Raises:
            CommandError: the container has rejected it; the text has its reason.
        """
        response = self.call(UNLOAD, srv.UnloadNode, srv.UnloadNode.Request(unique_id=unique_id))
        if not response.success:
            reason = response.error_message.capitalize()
            raise CommandError(
                f"Failed to unload component {unique_id} from '{self.node}' container node\n    {reason}"
            )


def container_names(found: Graph) -> list[str]:
    """Return the full names of the nodes that have the services of a container, in order."""
    served = {(end.name, end.type_name) for end in found.service_ends() if end.is_server}
    return sorted(node.full for node in found.nodes() if is_container(node.full, served))


def is_container(node: str, served: Collection[tuple[str, str]]) -> bool:
    """Return whether a node, by its full name, has all services of a container among those served, with their types."""
    return all((f"{node}/{name}", kind._TYPE_NAME) in served for name, kind in SERVICES.items())


@contextmanager
def containers(args: argparse.Namespace, asked: str | None) -> Iterator[list[Container]]:
    """Yield the named container, or, with None, all containers.

    Raises:
        CommandError: there is no such container; the text has the nearest names.
    """
    with (
        graph.settled_participant(args.spin_time) as participant,
        shown_node(participant, cli_node()) as own,
    ):
        names = container_names(participant.graph)
        if asked is not None:
            names = [find_full_name(asked, names, f"Unable to find container node '{asked}'")]
        yield [Container(participant, own, name, TIMEOUT_S) for name in names]
