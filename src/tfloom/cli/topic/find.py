"""List the topics of a type."""

from __future__ import annotations

import argparse

from tfloom.cli.graph import add_arguments as add_graph_arguments
from tfloom.cli.graph import is_hidden, settled_graph, topic_types


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add what `topic find` takes."""
    add_graph_arguments(parser)
    parser.add_argument("topic_type", help="type of the topics, as geometry_msgs/msg/Twist")
    parser.add_argument("-c", "--count-topics", action="store_true", help="print only how many there are")
    parser.add_argument(
        "--include-hidden-topics",
        action="store_true",
        default=argparse.SUPPRESS,
        help="count in topics with a part that begins with an underscore",
    )
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print the topics in order of their names."""
    with settled_graph(args) as graph:
        topics = topic_types(graph.endpoints())
    names = [
        name
        for name, types in topics.items()
        if args.topic_type in types and (args.include_hidden_topics or not is_hidden(name))
    ]
    if args.json:
        import json

        print(json.dumps(names, indent=2))
    elif args.count_topics:
        print(len(names))
    else:
        for name in names:
            print(name)
    return 0
