"""Print a service's type, and its numbers of servers and clients."""

from __future__ import annotations

import argparse

from tfloom.cli.service.service_ends import ends_of_service, service_types
from tfloom.cli.shared import graph
from tfloom.cli.shared.listing import print_json


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `service info`."""
    graph.add_arguments(parser)
    parser.add_argument("service_name", help="name of the service")
    parser.add_argument("--json", action="store_true", help="print JSON for programs, with the nodes")


def main(args: argparse.Namespace) -> int:
    """Print type and numbers."""
    name, ends = ends_of_service(args)
    types = service_types(ends)[name]
    servers = [end for end in ends if end.is_server]
    clients = [end for end in ends if not end.is_server]
    if args.json:
        sides = {
            side: [end.node.full if end.node else None for end in these]
            for side, these in (("servers", servers), ("clients", clients))
        }
        print_json({"name": name, "types": types, **sides})
        return 0
    print(f"Type: {types[0] if len(types) == 1 else types}")
    print(f"Clients count: {len(clients)}")
    print(f"Services count: {len(servers)}")
    return 0
