"""List the topics of a type."""

from __future__ import annotations

import argparse

from tfloom.cli.graph import add_arguments as add_graph_arguments
from tfloom.cli.graph import is_hidden, known_topics, settled_graph
from tfloom.cli.listing import print_names


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic find`."""
    add_graph_arguments(parser)
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
    with settled_graph(args) as graph:
        topics = known_topics(graph.endpoints())
    names = [
        name
        for name, types in topics.items()
        if args.topic_type in types and (args.include_hidden_topics or not is_hidden(name))
    ]
    if not names:
        from tfloom.cli.type_names import warn_if_unknown

        warn_if_unknown(
            args.topic_type, "msg", {type_name for types in topics.values() for type_name in types}
        )
    print_names(names, as_json=args.json, only_count=args.count_topics)
    return 0
