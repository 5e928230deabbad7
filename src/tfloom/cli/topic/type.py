"""Print a topic's type."""

from __future__ import annotations

import argparse

from tfloom.cli.errors import CommandError
from tfloom.cli.graph import add_arguments as add_graph_arguments
from tfloom.cli.graph import is_hidden, known_topics, settled_graph
from tfloom.cli.listing import print_names
from tfloom.cli.names import did_you_mean, full_topic_name


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic type`."""
    add_graph_arguments(parser)
    parser.add_argument("topic_name", help="name of the topic")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print each of its types on a line."""
    name = full_topic_name(args.topic_name)
    with settled_graph(args.spin_time) as graph:
        topics = known_topics(graph.endpoints())
    if name not in topics:
        raise CommandError(f"Unknown topic '{name}'{did_you_mean(name, topics)}")
    if is_hidden(name) and not args.include_hidden_topics:
        raise CommandError(f"Hidden topic '{name}': {args.prog} topic --include-hidden-topics type {name}")
    print_names(topics[name], as_json=args.json)
    return 0
