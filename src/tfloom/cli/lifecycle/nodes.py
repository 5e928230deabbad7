"""List the nodes that have a lifecycle."""

from __future__ import annotations

import argparse

from tfloom.cli.lifecycle.lifecycle_services import lifecycle_nodes
from tfloom.cli.shared import graph
from tfloom.cli.shared.listing import print_names


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `lifecycle nodes`."""
    graph.add_arguments(parser)
    parser.add_argument(
        "-a", "--all", action="store_true", help="show nodes whose name begins with an underscore, too"
    )
    parser.add_argument("-c", "--count-nodes", action="store_true", help="show only the number")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print the nodes' full names in order."""
    with graph.settled_graph(args.spin_time) as found:
        names = lifecycle_nodes(found, hidden=args.all)
    print_names(names, as_json=args.json, only_count=args.count_nodes)
    return 0
