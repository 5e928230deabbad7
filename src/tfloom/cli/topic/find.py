"""List the topics of a type."""

from __future__ import annotations

import argparse

from tfloom.cli.shared import graph
from tfloom.cli.shared.listing import print_names


def add_arguments(parser: argparse.ArgumentParser) -> None:
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


def main(args: argparse.Namespace) -> int:
    """Print the topics in order of their names."""
    with graph.settled_graph(args.spin_time) as found:
        topics = graph.known_topics(found.endpoints())
    names = graph.names_of_type(topics, args.topic_type, "msg", hidden=args.include_hidden_topics)
    print_names(names, as_json=args.json, only_count=args.count_topics)
    return 0
