"""List the services that have a server or a client."""

from __future__ import annotations

import argparse

from tfloom.cli.service.service_ends import add_hidden_flag, service_types
from tfloom.cli.shared import graph
from tfloom.cli.shared.listing import print_types


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `service list`."""
    graph.add_arguments(parser)
    parser.add_argument("-t", "--show-types", action="store_true", help="show each service's types")
    parser.add_argument("-c", "--count-services", action="store_true", help="show only the number")
    add_hidden_flag(parser)
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print the services in order of their names."""
    with graph.settled_graph(args.spin_time) as found:
        ends = found.service_ends()
    shown = [end for end in ends if args.include_hidden_services or not graph.is_hidden(end.name)]
    print_types(service_types(shown), args, only_count=args.count_services)
    return 0
