"""The common part of the verbs about components: the containers, and their services."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from tfloom.cli import graph
from tfloom.cli.calls import service_client
from tfloom.cli.errors import CommandError
from tfloom.cli.listen import cli_node, shown_node
from tfloom.cli.names import did_you_mean
from tfloom.interfaces.composition_interfaces import srv
from tfloom.rmw.base import Graph, NodeName, Participant

TIMEOUT_S = 5.0
"""Longest wait for a container's service, and for the response of those that only list or unload [s]."""
_SERVICES: dict[str, type[Any]] = {
    "load_node": srv.LoadNode,
    "unload_node": srv.UnloadNode,
    "list_nodes": srv.ListNodes,
}


class Container:
    """The services of one node that loads others into its process."""

    def __init__(self, participant: Participant, own: NodeName, name: str) -> None:
        self.name = name
        self._participant = participant
        self._own = own

    def components(self) -> dict[int, str]:
        """Return the full names of the loaded nodes by their ids."""
        response = self._call("list_nodes", srv.ListNodes.Request(), TIMEOUT_S)
        return dict(zip(response.unique_ids, response.full_node_names, strict=False))

    def load(self, request: srv.LoadNode_Request) -> tuple[int, str]:
        """Load a node; return its id and full name. Loading takes as long as the node's constructor.

        Raises:
            CommandError: the container has rejected it; the text has its reason.
        """
        response = self._call("load_node", request, float("inf"))
        if not response.success:
            raise CommandError(f"Failed to load component: {response.error_message.capitalize()}")
        return response.unique_id, response.full_node_name

    def unload(self, unique_id: int) -> None:
        """Unload a node.

        Raises:
            CommandError: the container has rejected it; the text has its reason.
        """
        response = self._call("unload_node", srv.UnloadNode.Request(unique_id=unique_id), TIMEOUT_S)
        if not response.success:
            reason = response.error_message.capitalize()
            raise CommandError(
                f"Failed to unload component {unique_id} from '{self.name}' container node\n    {reason}"
            )

    def _call(self, service: str, request: Any, timeout_s: float) -> Any:
        name = _service_name(self.name, service)
        with service_client(self._participant, self._own, name, _SERVICES[service]) as client:
            client.wait_for_server(TIMEOUT_S)
            return client.call(request, timeout_s)


def container_names(found: Graph) -> list[str]:
    """Return the full names of the nodes that have the services of a container, in order."""
    served = {(end.name, end.type_name) for end in found.service_ends() if end.is_server}
    return sorted(
        node.full
        for node in found.nodes()
        if all(
            (_service_name(node.full, service), service_class._TYPE_NAME) in served
            for service, service_class in _SERVICES.items()
        )
    )


def _service_name(container: str, service: str) -> str:
    return f"{container}/_container/{service}"


@contextmanager
def containers(args: argparse.Namespace, asked: str | None) -> Iterator[list[Container]]:
    """Yield the named container, or, with None, all containers.

    Raises:
        CommandError: there is no such container; the text has the nearest names.
    """
    with graph.joined_participant() as participant:
        graph.wait_until_quiet(participant.graph, args.spin_time)
        names = container_names(participant.graph)
        if asked is not None:
            full = asked if asked.startswith("/") else f"/{asked}"
            if full not in names:
                raise CommandError(f"Unable to find container node '{asked}'{did_you_mean(full, names)}")
            names = [full]
        with shown_node(participant, cli_node()) as own:
            yield [Container(participant, own, name) for name in names]
