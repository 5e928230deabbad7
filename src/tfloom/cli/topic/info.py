"""Tell a topic's type, and who writes and reads it."""

from __future__ import annotations

import argparse

from tfloom.cli.errors import CommandError
from tfloom.cli.graph import add_arguments as add_graph_arguments
from tfloom.cli.graph import settled_graph, topic_types
from tfloom.cli.names import did_you_mean, full_topic_name
from tfloom.rmw.base import EndpointInfo
from tfloom.rmw.qos import INFINITE_NS, HistoryPolicy, QoS


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add what `topic info` takes."""
    add_graph_arguments(parser)
    parser.add_argument("topic_name", help="name of the topic")
    parser.add_argument(
        "-v",
        "--verbose",
        action="store_true",
        help="show each publisher and subscription with its node and QoS",
    )
    parser.add_argument("--json", action="store_true", help="print JSON for programs, as with --verbose")


def main(args: argparse.Namespace) -> int:
    """Print type and numbers, with --verbose each end."""
    name = full_topic_name(args.topic_name)
    with settled_graph(args) as graph:
        everything = graph.endpoints()
    ends = [end for end in everything if end.topic.name == name]
    if not ends:
        raise CommandError(f"Unknown topic '{name}'{did_you_mean(name, topic_types(everything))}")
    types = topic_types(ends)[name]
    publishers = [end for end in ends if end.is_writer]
    subscriptions = [end for end in ends if not end.is_writer]
    if args.json:
        _print_json(name, types, publishers, subscriptions)
        return 0
    blank = "\n" if args.verbose else ""
    print(f"Type: {types[0] if len(types) == 1 else types}{blank}")
    for title, side in (("Publisher", publishers), ("Subscription", subscriptions)):
        print(f"{title} count: {len(side)}{blank}")
        if args.verbose:
            for end in side:
                print(f"{describe_endpoint(end)}\n")
    return 0


def describe_endpoint(end: EndpointInfo) -> str:
    """Return the lines that tell all about a writer or a reader."""
    node = end.node
    return "\n".join(
        [
            f"Node name: {node.name if node else '_NODE_NAME_UNKNOWN_'}",
            f"Node namespace: {node.namespace if node else '_NODE_NAMESPACE_UNKNOWN_'}",
            f"Topic type: {end.topic.type_name}",
            f"Topic type hash: {end.topic.type_hash or 'INVALID'}",
            f"Endpoint type: {'PUBLISHER' if end.is_writer else 'SUBSCRIPTION'}",
            f"GID: {'.'.join(f'{octet:02x}' for octet in end.gid)}",
            "QoS profile:",
            *(f"  {name}: {value}" for name, value in describe_qos(end.qos).items()),
        ]
    )


def describe_qos(qos: QoS) -> dict[str, str]:
    """Return each policy of a quality of service as text, by its title."""
    depth = f" ({qos.depth})" if qos.history == HistoryPolicy.KEEP_LAST else ""
    return {
        "Reliability": qos.reliability.name,
        "History (Depth)": f"{qos.history.name}{depth}",
        "Durability": qos.durability.name,
        "Lifespan": _duration(qos.lifespan_ns),
        "Deadline": _duration(qos.deadline_ns),
        "Liveliness": qos.liveliness.name,
        "Liveliness lease duration": _duration(qos.liveliness_lease_ns),
    }


def _duration(duration_ns: int) -> str:
    return "Infinite" if duration_ns >= INFINITE_NS else f"{duration_ns} nanoseconds"


def _print_json(name: str, types: list[str], *sides: list[EndpointInfo]) -> None:
    import json

    publishers, subscriptions = (
        [
            {
                "node": end.node.full if end.node else None,
                "type": end.topic.type_name,
                "type_hash": end.topic.type_hash,
                "gid": end.gid.hex(),
                "qos": describe_qos(end.qos),
            }
            for end in side
        ]
        for side in sides
    )
    print(
        json.dumps(
            {"name": name, "types": types, "publishers": publishers, "subscriptions": subscriptions}, indent=2
        )
    )
