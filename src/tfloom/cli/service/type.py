"""Print a service's type."""

from __future__ import annotations

import argparse

from tfloom.cli.service.service_ends import ends_of_service, service_types
from tfloom.cli.shared import graph
from tfloom.cli.shared.listing import print_names


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `service type`."""
    parser.set_defaults(spin_time=graph.MAX_WAIT_S)
    parser.add_argument("service_name", help="name of the service")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
    """Print each of its types on a line."""
    name, ends = ends_of_service(args)
    print_names(service_types(ends)[name], as_json=args.json)
    return 0
