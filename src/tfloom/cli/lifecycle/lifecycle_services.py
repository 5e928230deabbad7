"""The lifecycle nodes on the graph, their services, and the flags of the verbs about one."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from tfloom.cli.shared import graph
from tfloom.cli.shared.calls import NodeServices
from tfloom.cli.shared.listen import cli_node, shown_node
from tfloom.cli.shared.names import find_full_name
from tfloom.interfaces.lifecycle_msgs import srv
from tfloom.rmw.base import Graph

TIMEOUT_S = 10.0
STATE_SERVICE = "/get_state"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the flags of the verbs about one node."""
    graph.add_arguments(parser)
    parser.add_argument(
        "--include-hidden-nodes",
        action="store_true",
        help="see nodes whose name begins with an underscore, too",
    )


class Lifecycle(NodeServices):
    """The lifecycle services of one node."""

    def state(self) -> Any:
        """Return the state that the node is in: id and label."""
        return self.call("get_state", srv.GetState, srv.GetState.Request()).current_state

    def transitions(self, *, of_all_states: bool = False) -> list[Any]:
        """Return the transitions that are available in the present state, or all of the node."""
        service = "get_transition_graph" if of_all_states else "get_available_transitions"
        request = srv.GetAvailableTransitions.Request()
        return list(self.call(service, srv.GetAvailableTransitions, request).available_transitions)

    def change(self, transition: Any) -> bool:
        """Request a transition and return whether it succeeded."""
        request = srv.ChangeState.Request(transition=transition)
        return bool(self.call("change_state", srv.ChangeState, request).success)


def lifecycle_nodes(found: Graph, *, hidden: bool) -> list[str]:
    """Return the full names of the nodes that have a lifecycle, in order."""
    names = {
        end.name.removesuffix(STATE_SERVICE)
        for end in found.service_ends()
        if end.is_server and end.type_name == srv.GetState._TYPE_NAME and end.name.endswith(STATE_SERVICE)
    }
    return sorted(name for name in names if hidden or not graph.is_hidden(name))


@contextmanager
def lifecycles(args: argparse.Namespace, asked: str | None) -> Iterator[list[Lifecycle]]:
    """Yield the lifecycle of the named node, or, with None, of each lifecycle node.

    Raises:
        CommandError: there is no such lifecycle node; the text has the nearest names.
    """
    with (
        graph.settled_participant(args.spin_time) as participant,
        shown_node(participant, cli_node()) as own,
    ):
        names = lifecycle_nodes(participant.graph, hidden=args.include_hidden_nodes)
        if asked is not None:
            names = [find_full_name(asked, names, "Node not found")]
        yield [Lifecycle(participant, own, name, TIMEOUT_S) for name in names]
