"""List the nodes that are running."""

from __future__ import annotations

import argparse

from tfloom.cli.shared import graph
from tfloom.cli.shared.listing import print_names
from tfloom.common.terminal import report


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `node list`."""
    graph.add_arguments(parser)
    parser.add_argument(
        "-a", "--all", action="store_true", help="show nodes whose name begins with an underscore, too"
    )
    parser.add_argument("-c", "--count-nodes", action="store_true", help="show only the number")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print the nodes' full names in order."""
    with graph.settled_graph(args.spin_time) as found:
        names = [node.full for node in found.nodes()]
    if not args.all:
        names = [name for name in names if not graph.is_hidden(name)]
    if len(set(names)) < len(names) and not args.count_nodes:
        report(
            "WARNING: Be aware that there are nodes in the graph that share an exact name, "
            "which can have unintended side effects."
        )
    print_names(names, as_json=args.json, only_count=args.count_nodes)
    return 0
