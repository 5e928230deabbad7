"""Print a topic's type."""

from __future__ import annotations

import argparse

from tfloom.cli.shared import graph
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listing import print_names
from tfloom.cli.shared.names import did_you_mean, full_topic_name


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `topic type`."""
    graph.add_arguments(parser)
    parser.add_argument("topic_name", help="name of the topic")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
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
