"""Services on the graph, by their servers and clients."""

from __future__ import annotations

import argparse
from collections.abc import Iterable

from tfloom.cli.shared import graph
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.names import did_you_mean, full_topic_name
from tfloom.rmw.base import ServiceEndInfo


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


def ends_of_service(args: argparse.Namespace) -> tuple[str, list[ServiceEndInfo]]:
    """Return the full name of the service in the arguments, and its servers and clients.

    Raises:
        CommandError: there is no such service; the text has the nearest names.
    """
    name = full_topic_name(args.service_name, "service")
    with graph.settled_graph(args.spin_time) as found:
        everything = found.service_ends()
    ends = [end for end in everything if end.name == name]
    if not ends:
        raise CommandError(f"Unknown service '{name}'{did_you_mean(name, service_types(everything))}")
    return name, ends
