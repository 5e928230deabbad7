"""Call a service and print its response."""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterable
from itertools import repeat
from typing import Any

from tfloom.cli.shared import graph, qos
from tfloom.cli.shared.calls import printer, service_client
from tfloom.cli.shared.errors import CommandError, standard_input
from tfloom.cli.shared.interfaces import fill_message, parse_yaml, service_class, yaml_documents
from tfloom.cli.shared.listen import cli_node, shown_node
from tfloom.cli.shared.names import full_topic_name
from tfloom.cli.shared.numbers import rate, seconds
from tfloom.rmw.qos import QoS


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `service call`."""
    parser.add_argument("service_name", help="service to call")
    parser.add_argument("service_type", help="its type, for example turtlesim/srv/Spawn")
    parser.add_argument(
        "values", nargs="?", default="{}", help="the request's fields in YAML, for example '{x: 2.0}'"
    )
    parser.add_argument(
        "--stdin", action="store_true", help="read requests, YAML documents, from standard input"
    )
    parser.add_argument("-r", "--rate", metavar="N", type=rate, help="call repeatedly, with this rate in Hz")
    qos.add_arguments(parser, default="that of services")
    parser.add_argument(
        "--timeout",
        metavar="N",
        type=seconds,
        default=float("inf"),
        help="longest wait in seconds",
    )


def main(args: argparse.Namespace) -> int:
    """Call once, for each request in standard input, or repeatedly with --rate."""
    name = full_topic_name(args.service_name, "service")
    if args.rate is not None and not args.rate > 0:
        raise CommandError("rate must be greater than zero")
    cls = service_class(args.service_type, search_graph=True)
    period_s = 1 / args.rate if args.rate else 0.0
    with (
        graph.joined_participant() as participant,
        shown_node(participant, cli_node()) as node,
        service_client(participant, node, name, cls, qos.requested_qos(args, QoS())) as client,
    ):
        for request in _requests(cls, args):
            start = time.monotonic()
            client.wait_for_server(args.timeout, printer("waiting for service to become available..."))
            print(f"requester: making request: {request!r}\n")
            print(f"response:\n{client.call(request, args.timeout)!r}\n")
            time.sleep(max(0.0, start + period_s - time.monotonic()))
    return 0


def _requests(cls: type[Any], args: argparse.Namespace) -> Iterable[Any]:
    if args.stdin:
        return (_request(cls, text) for text in yaml_documents(standard_input()))
    request = _request(cls, args.values)
    return [request] if args.rate is None else repeat(request)


def _request(cls: type[Any], values: str) -> Any:
    request = cls.Request()
    fill_message(request, parse_yaml(values))
    return request
