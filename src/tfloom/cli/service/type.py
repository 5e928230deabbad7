"""Print a service's type."""

from __future__ import annotations

import argparse

from tfloom.cli import graph
from tfloom.cli.service.common import ends_of_service, service_types


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add what `service type` takes."""
    parser.set_defaults(spin_time=graph.MOST_S)
    parser.add_argument("service_name", help="name of the service")


def main(args: argparse.Namespace) -> int:
    """Print each of its types on a line."""
    name, ends = ends_of_service(args)
    print("\n".join(service_types(ends)[name]))
    return 0
