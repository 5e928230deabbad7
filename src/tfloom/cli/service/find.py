"""List the services of a type."""

from __future__ import annotations

import argparse

from tfloom.cli import graph
from tfloom.cli.listing import print_names
from tfloom.cli.service.common import add_hidden_flag, service_types


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `service find`."""
    parser.set_defaults(spin_time=graph.MAX_WAIT_S)
    parser.add_argument("service_type", help="type of the services, for example std_srvs/srv/Empty")
    parser.add_argument("-c", "--count-services", action="store_true", help="print only the number")
    add_hidden_flag(parser)
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print the services in order of their names."""
    with graph.settled_graph(args) as found:
        services = service_types(found.service_ends())
    names = [
        name
        for name, types in services.items()
        if args.service_type in types and (args.include_hidden_services or not graph.is_hidden(name))
    ]
    if not names:
        from tfloom.cli.type_names import warn_if_unknown

        warn_if_unknown(
            args.service_type, "srv", {type_name for types in services.values() for type_name in types}
        )
    print_names(names, as_json=args.json, only_count=args.count_services)
    return 0
