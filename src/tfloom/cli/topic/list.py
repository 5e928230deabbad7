"""List the topics that have a publisher or a subscription."""

from __future__ import annotations

import argparse
from collections import Counter

from tfloom.cli.shared import graph
from tfloom.cli.shared.listing import print_json, print_types
from tfloom.rmw.base import EndpointInfo


def add_arguments(parser: argparse.ArgumentParser) -> None:
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


def main(args: argparse.Namespace) -> int:
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
