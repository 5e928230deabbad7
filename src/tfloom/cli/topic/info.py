"""Print a topic's type, publishers and subscriptions."""

from __future__ import annotations

import argparse

from tfloom.cli.shared import graph
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listing import print_json
from tfloom.cli.shared.names import did_you_mean, full_topic_name
from tfloom.rmw.base import EndpointInfo
from tfloom.rmw.shared.endpoint_text import UNKNOWN_NODE, endpoint_text, policy_texts


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic info`."""
    graph.add_arguments(parser)
    parser.add_argument("topic_name", help="name of the topic")
    parser.add_argument(
        "-v",
        "--verbose",
        action="store_true",
        help="show each publisher and subscription with its node and QoS",
    )
    parser.add_argument("--json", action="store_true", help="print JSON for programs, as with --verbose")


def main(args: argparse.Namespace) -> int:
    """Print type and numbers; with --verbose, each endpoint."""
    name = full_topic_name(args.topic_name)
    with graph.settled_graph(args.spin_time) as found:
        everything = found.endpoints()
    topics = graph.known_topics(everything)
    if name not in topics:
        raise CommandError(f"Unknown topic '{name}'{did_you_mean(name, topics)}")
    ends = [end for end in everything if end.topic.name == name]
    types = topics[name]
    publishers = [end for end in ends if end.is_writer]
    subscriptions = [end for end in ends if not end.is_writer]
    if args.json:
        ends_of_sides = {"publishers": publishers, "subscriptions": subscriptions}
        sides = {title: list(map(_plain, side)) for title, side in ends_of_sides.items()}
        print_json({"name": name, "types": types, **sides})
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
    """Return the lines that describe a writer or a reader."""
    return endpoint_text(
        end.node or UNKNOWN_NODE,
        end.topic.type_name,
        end.topic.type_hash or "INVALID",
        "PUBLISHER" if end.is_writer else "SUBSCRIPTION",
        end.gid,
        end.qos,
    )


def _plain(end: EndpointInfo) -> dict[str, object]:
    return {
        "node": end.node.full if end.node else None,
        "type": end.topic.type_name,
        "type_hash": end.topic.type_hash,
        "gid": end.gid.hex(),
        "qos": policy_texts(end.qos),
    }
