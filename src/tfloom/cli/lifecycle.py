"""`lifecycle`: states and transitions of lifecycle nodes."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from tfloom.cli.parser import help_since
from tfloom.cli.shared import graph
from tfloom.cli.shared.calls import NodeServices, call_each
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listen import cli_node, shown_node
from tfloom.cli.shared.listing import print_json, print_names
from tfloom.cli.shared.names import find_full_name
from tfloom.cli.shared.numbers import seconds
from tfloom.interfaces.lifecycle_msgs import srv
from tfloom.rmw.base import Graph

TIMEOUT_S = 10.0
STATE_SERVICE = "/get_state"


def add_common_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the flags of the verbs about one node."""
    graph.add_arguments(parser)
    parser.add_argument(
        "--include-hidden-nodes",
        action="store_true",
        help="see nodes whose name begins with an underscore, too",
    )
    parser.add_argument(
        "--timeout",
        metavar="N",
        type=seconds,
        default=TIMEOUT_S,
        help=help_since(
            "lyrical", f"longest wait for a service, and for its response, in seconds (default {TIMEOUT_S:g})"
        ),
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
        yield [Lifecycle(participant, own, name, args.timeout) for name in names]


def add_get_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `lifecycle get`."""
    add_common_arguments(parser)
    parser.add_argument("node_name", nargs="?", help="full name of the node")
    parser.add_argument("--json", action="store_true", help="print JSON for programs")


def get_main(args: argparse.Namespace) -> int:
    """Print label and id of the state, after the node's name if all nodes are listed."""
    with lifecycles(args, args.node_name) as nodes:
        states = call_each({node.node: node.state for node in nodes})
    if args.json:
        print_json(states)
        return 0
    for node_name, state in states.items():
        name = f"{node_name}: " if args.node_name is None else ""
        print(f"{name}{state.label} [{state.id}]")
    return 0


def add_list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `lifecycle list`."""
    add_common_arguments(parser)
    parser.add_argument(
        "-a",
        "--all",
        action="store_true",
        help="list the transitions of all states, not only of the present one",
    )
    parser.add_argument("node_name", help="full name of the node")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def list_main(args: argparse.Namespace) -> int:
    """Print each transition with its start and goal states."""
    with lifecycles(args, args.node_name) as nodes:
        transitions = nodes[0].transitions(of_all_states=args.all)
    if args.json:
        print_json(transitions)
        return 0
    for description in transitions:
        print(f"- {description.transition.label} [{description.transition.id}]")
        print(f"\tStart: {description.start_state.label}")
        print(f"\tGoal: {description.goal_state.label}")
    return 0


def add_nodes_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `lifecycle nodes`."""
    graph.add_arguments(parser)
    parser.add_argument(
        "-a", "--all", action="store_true", help="show nodes whose name begins with an underscore, too"
    )
    parser.add_argument("-c", "--count-nodes", action="store_true", help="show only the number")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def nodes_main(args: argparse.Namespace) -> int:
    """Print the nodes' full names in order."""
    with graph.settled_graph(args.spin_time) as found:
        names = lifecycle_nodes(found, hidden=args.all)
    print_names(names, as_json=args.json, only_count=args.count_nodes)
    return 0


def add_set_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `lifecycle set`."""
    add_common_arguments(parser)
    parser.add_argument("node_name", help="full name of the node")
    parser.add_argument("transition", help="label or id of the transition, for example configure")


def set_main(args: argparse.Namespace) -> int:
    """Request the transition and print the outcome."""
    with lifecycles(args, args.node_name) as nodes:
        transitions = [description.transition for description in nodes[0].transitions()]
        wanted = [
            transition
            for transition in transitions
            if args.transition in {transition.label, str(transition.id)}
        ]
        if not wanted:
            listed = "".join(f"\n- {transition.label} [{transition.id}]" for transition in transitions)
            raise CommandError(f"Unknown transition requested, available ones are:{listed}")
        if not nodes[0].change(wanted[0]):
            raise CommandError("Transitioning failed")
    print("Transitioning successful")
    return 0
