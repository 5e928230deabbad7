"""`node`: inspect nodes."""

from __future__ import annotations

import argparse
from collections.abc import Iterable

from tfloom.cli.shared import graph
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listing import print_json, print_names
from tfloom.common.terminal import report
from tfloom.rmw.base import Graph, NodeName

ACTION_SUFFIX = "/_action/send_goal"
ACTION_TYPE_SUFFIX = "_SendGoal"


def add_info_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `node info`."""
    graph.add_arguments(parser)
    parser.add_argument("node_name", help="full name of the node, for example /turtlesim")
    parser.add_argument(
        "--include-hidden",
        action="store_true",
        help="show names with a part that begins with an underscore, too",
    )
    parser.add_argument("--json", action="store_true", help="print JSON for programs")


def info_main(args: argparse.Namespace) -> int:
    """Print the node's topics, services and actions with their types."""
    with graph.settled_graph(args.spin_time) as found:
        node = find_node(found, args.node_name)
        if graph.is_hidden(node.full) and not args.include_hidden:
            raise CommandError(f"Unable to find node '{args.node_name}'\nit is hidden: add --include-hidden")
        sections = ends_of_node(found, node, hidden=args.include_hidden)
        twins = sum(other == node for other in found.nodes())
    if args.json:
        print_json(
            {"node": node.full} | {key.lower().replace(" ", "_"): value for key, value in sections.items()}
        )
        return 0
    if twins > 1:
        report(
            f'There are {twins} nodes in the graph with the exact name "{node.full}". '
            "You are seeing information about all of them."
        )
    print(node.full)
    for title, ends in sections.items():
        print(f"  {title}:")
        print("\n".join(f"    {name}: {', '.join(types)}" for name, types in ends.items()))
    return 0


def find_node(found: Graph, name: str) -> NodeName:
    """Return the node of a full name; its first slash may be omitted.

    Raises:
        CommandError: there is none; the text has the nearest names.
    """
    from tfloom.cli.shared.names import find_full_name

    nodes = {node.full: node for node in found.nodes()}
    return nodes[find_full_name(name, nodes, f"Unable to find node '{name}'")]


def ends_of_node(found: Graph, node: NodeName, *, hidden: bool) -> dict[str, dict[str, list[str]]]:
    """Return names and types of a node's endpoints, by the title of their kind."""
    topics = [
        (end.is_writer, end.topic.name, end.topic.type_name) for end in found.endpoints() if end.node == node
    ]
    services = [(end.is_server, end.name, end.type_name) for end in found.service_ends() if end.node == node]
    actions = [
        (is_server, name.removesuffix(ACTION_SUFFIX), type_name.removesuffix(ACTION_TYPE_SUFFIX))
        for is_server, name, type_name in services
        if name.endswith(ACTION_SUFFIX)
    ]
    return {
        "Subscribers": _types(topics, False, hidden),
        "Publishers": _types(topics, True, hidden),
        "Service Servers": _types(services, True, hidden),
        "Service Clients": _types(services, False, hidden),
        "Action Servers": _types(actions, True, hidden),
        "Action Clients": _types(actions, False, hidden),
    }


def _types(ends: Iterable[tuple[bool, str, str]], side: bool, hidden: bool) -> dict[str, list[str]]:
    return graph.types_by_name(
        (name, type_name)
        for of_side, name, type_name in ends
        if of_side == side and (hidden or not graph.is_hidden(name))
    )


def add_list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `node list`."""
    graph.add_arguments(parser)
    parser.add_argument(
        "-a", "--all", action="store_true", help="show nodes whose name begins with an underscore, too"
    )
    parser.add_argument("-c", "--count-nodes", action="store_true", help="show only the number")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def list_main(args: argparse.Namespace) -> int:
    """Print the nodes' full names in order."""
    with graph.settled_graph(args.spin_time) as found:
        names = [node.full for node in found.nodes()]
    if not args.all:
        names = [name for name in names if not graph.is_hidden(name)]
    if len(set(names)) < len(names) and not args.count_nodes:
        report(
            "WARNING: Be aware that there are nodes in the graph that share an exact name, "
            "which can have unintended side effects."
        )
    print_names(names, as_json=args.json, only_count=args.count_nodes)
    return 0
