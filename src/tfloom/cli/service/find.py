"""List the services of a type."""

from __future__ import annotations

import argparse

from tfloom.cli.service.service_ends import add_hidden_flag, service_types
from tfloom.cli.shared import graph
from tfloom.cli.shared.listing import print_names


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `service find`."""
    parser.set_defaults(spin_time=graph.MAX_WAIT_S)
    parser.add_argument("service_type", help="type of the services, for example std_srvs/srv/Empty")
    parser.add_argument("-c", "--count-services", action="store_true", help="print only the number")
    add_hidden_flag(parser)
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print the services in order of their names."""
    with graph.settled_graph(args.spin_time) as found:
        services = service_types(found.service_ends())
    names = graph.names_of_type(services, args.service_type, "srv", hidden=args.include_hidden_services)
    print_names(names, as_json=args.json, only_count=args.count_services)
    return 0
