"""The verbs of `service` that print names and types, and the ends of services on the graph."""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Iterator
from contextlib import contextmanager

from tfloom.cli.shared import graph
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listing import print_json, print_names, print_types
from tfloom.cli.shared.names import did_you_mean, full_topic_name
from tfloom.rmw.base import Graph, ServiceEndInfo


def add_hidden_flag(parser: argparse.ArgumentParser) -> None:
    """Add the flag that shows hidden services."""
    parser.add_argument(
        "--include-hidden-services",
        action="store_true",
        default=argparse.SUPPRESS,
        help="include services with a part that begins with an underscore",
    )


def service_types(ends: Iterable[ServiceEndInfo]) -> dict[str, list[str]]:
    """Return the types of each service by the service's name, both in order."""
    return graph.types_by_name((end.name, end.type_name) for end in ends)


def add_find_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `service find`."""
    parser.set_defaults(spin_time=graph.MAX_WAIT_S)
    parser.add_argument("service_type", help="type of the services, for example std_srvs/srv/Empty")
    parser.add_argument("-c", "--count-services", action="store_true", help="print only the number")
    add_hidden_flag(parser)
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def find_main(args: argparse.Namespace) -> int:
    """Print the services in order of their names."""
    with graph.settled_graph(args.spin_time) as found:
        services = service_types(found.service_ends())
    names = graph.names_of_type(services, args.service_type, "srv", hidden=args.include_hidden_services)
    print_names(names, as_json=args.json, only_count=args.count_services)
    return 0


def add_info_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `service info`."""
    graph.add_arguments(parser)
    parser.add_argument("service_name", help="name of the service")
    parser.add_argument(
        "-v", "--verbose", action="store_true", help="show each server and client with its node and QoS"
    )
    parser.add_argument("--json", action="store_true", help="print JSON for programs, with the nodes")


def info_main(args: argparse.Namespace) -> int:
    """Print type and numbers; with --verbose, each server and client."""
    with _settled_service(args) as (name, ends, found):
        types = service_types(ends)[name]
        servers = [end for end in ends if end.is_server]
        clients = [end for end in ends if not end.is_server]
        texts = {is_server: _descriptions(found, name, is_server, args) for is_server in (False, True)}
    if args.json:
        sides = {
            side: [end.node.full if end.node else None for end in these]
            for side, these in (("servers", servers), ("clients", clients))
        }
        print_json({"name": name, "types": types, **sides})
        return 0
    blank = "\n" if args.verbose else ""
    print(f"Type: {types[0] if len(types) == 1 else types}{blank}")
    print(f"Clients count: {len(clients)}{blank}")
    for text in texts[False]:
        print(f"{text}\n")
    print(f"Services count: {len(servers)}{blank}")
    for text in texts[True]:
        print(f"{text}\n")
    return 0


def _descriptions(found: Graph, name: str, is_server: bool, args: argparse.Namespace) -> list[str]:
    """Return the lines that describe each server or client, with --verbose."""
    if not args.verbose or args.json:
        return []
    from tfloom.node.base.node_graph import service_endpoints

    return [str(end) for end in service_endpoints(found, name, is_server=is_server)]


@contextmanager
def _settled_service(args: argparse.Namespace) -> Iterator[tuple[str, list[ServiceEndInfo], Graph]]:
    """Yield the full name of the service in the arguments, its servers and clients, and the graph.

    Raises:
        CommandError: there is no such service; the text has the nearest names.
    """
    name = full_topic_name(args.service_name, "service")
    with graph.settled_graph(args.spin_time) as found:
        everything = found.service_ends()
        ends = [end for end in everything if end.name == name]
        if not ends:
            raise CommandError(f"Unknown service '{name}'{did_you_mean(name, service_types(everything))}")
        yield name, ends, found


def add_list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `service list`."""
    graph.add_arguments(parser)
    parser.add_argument("-t", "--show-types", action="store_true", help="show each service's types")
    parser.add_argument("-c", "--count-services", action="store_true", help="show only the number")
    add_hidden_flag(parser)
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def list_main(args: argparse.Namespace) -> int:
    """Print the services in order of their names."""
    with graph.settled_graph(args.spin_time) as found:
        ends = found.service_ends()
    shown = [end for end in ends if args.include_hidden_services or not graph.is_hidden(end.name)]
    print_types(service_types(shown), args, only_count=args.count_services)
    return 0


def add_type_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `service type`."""
    parser.set_defaults(spin_time=graph.MAX_WAIT_S)
    parser.add_argument("service_name", help="name of the service")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def type_main(args: argparse.Namespace) -> int:
    """Print each of its types on a line."""
    with _settled_service(args) as (name, ends, _):
        types = service_types(ends)[name]
    print_names(types, as_json=args.json)
    return 0
