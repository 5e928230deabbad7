"""The verbs of `topic` that print names and types."""

from __future__ import annotations

import argparse
from collections import Counter

from tfloom.cli.shared import graph
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listing import print_json, print_names, print_types
from tfloom.cli.shared.names import did_you_mean, full_topic_name
from tfloom.rmw.base import EndpointInfo


def add_find_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic find`."""
    graph.add_arguments(parser)
    parser.add_argument("topic_type", help="type of the topics, for example geometry_msgs/msg/Twist")
    parser.add_argument("-c", "--count-topics", action="store_true", help="print only the number")
    parser.add_argument(
        "--include-hidden-topics",
        action="store_true",
        default=argparse.SUPPRESS,
        help="include topics with a part that begins with an underscore",
    )
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def find_main(args: argparse.Namespace) -> int:
    """Print the topics in order of their names."""
    with graph.settled_graph(args.spin_time) as found:
        topics = graph.known_topics(found.endpoints())
    names = graph.names_of_type(topics, args.topic_type, "msg", hidden=args.include_hidden_topics)
    print_names(names, as_json=args.json, only_count=args.count_topics)
    return 0


def add_info_arguments(parser: argparse.ArgumentParser) -> None:
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


def info_main(args: argparse.Namespace) -> int:
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
    from tfloom.rmw.shared.endpoint_text import UNKNOWN_NODE, endpoint_text

    return endpoint_text(
        end.node or UNKNOWN_NODE,
        end.topic.type_name,
        end.topic.type_hash or "INVALID",
        "PUBLISHER" if end.is_writer else "SUBSCRIPTION",
        end.gid,
        end.qos,
    )


def _plain(end: EndpointInfo) -> dict[str, object]:
    from tfloom.rmw.shared.endpoint_text import policy_texts

    return {
        "node": end.node.full if end.node else None,
        "type": end.topic.type_name,
        "type_hash": end.topic.type_hash,
        "gid": end.gid.hex(),
        "qos": policy_texts(end.qos),
    }


def add_list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic list`."""
    graph.add_arguments(parser)
    parser.add_argument("-t", "--show-types", action="store_true", help="show each topic's types")
    parser.add_argument("-c", "--count-topics", action="store_true", help="show only the number")
    parser.add_argument(
        "--include-hidden-topics",
        action="store_true",
        default=argparse.SUPPRESS,
        help="show topics with a part that begins with an underscore, too",
    )
    parser.add_argument(
        "-v", "--verbose", action="store_true", help="show types and numbers of publishers and subscribers"
    )
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def list_main(args: argparse.Namespace) -> int:
    """Print the topics in order of their names."""
    with graph.settled_graph(args.spin_time) as found:
        endpoints = found.endpoints()
    if not args.include_hidden_topics:
        endpoints = [endpoint for endpoint in endpoints if not graph.is_hidden(endpoint.topic.name)]
    topics = graph.known_topics(endpoints)
    if args.json:
        _print_json(topics, endpoints)
    elif args.verbose and not args.count_topics:
        _print_side("Published topics:", "publisher", [end for end in endpoints if end.is_writer])
        _print_side("Subscribed topics:", "subscriber", [end for end in endpoints if not end.is_writer])
    else:
        print_types(topics, args, only_count=args.count_topics)
    return 0


def _print_side(title: str, noun: str, endpoints: list[EndpointInfo]) -> None:
    counts = Counter(endpoint.topic.name for endpoint in endpoints)
    print(title)
    for name, types in graph.topic_types(endpoints).items():
        print(f" * {name} [{', '.join(types)}] {counts[name]} {noun}{'s' if counts[name] > 1 else ''}")
    print()


def _print_json(types_of: dict[str, list[str]], endpoints: list[EndpointInfo]) -> None:
    counts = Counter((endpoint.topic.name, endpoint.is_writer) for endpoint in endpoints)
    print_json(
        [
            {
                "name": name,
                "types": types,
                "publishers": counts[name, True],
                "subscribers": counts[name, False],
            }
            for name, types in types_of.items()
        ]
    )


def add_type_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic type`."""
    graph.add_arguments(parser)
    parser.add_argument("topic_name", help="name of the topic")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def type_main(args: argparse.Namespace) -> int:
    """Print each of its types on a line."""
    name = full_topic_name(args.topic_name)
    with graph.settled_graph(args.spin_time) as found:
        topics = graph.known_topics(found.endpoints())
    if name not in topics:
        raise CommandError(f"Unknown topic '{name}'{did_you_mean(name, topics)}")
    if graph.is_hidden(name) and not args.include_hidden_topics:
        raise CommandError(f"Hidden topic '{name}': {args.prog} topic --include-hidden-topics type {name}")
    print_names(topics[name], as_json=args.json)
    return 0
