"""Print the requests and responses of a service that publishes its events."""

from __future__ import annotations

import argparse
import re

from tfloom.cli.service.queries import service_types
from tfloom.cli.shared import graph, message_text
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.interfaces import service_class
from tfloom.cli.shared.listen import decoded, publishers_of, samples, wait_for_publishers
from tfloom.cli.shared.names import full_topic_name
from tfloom.cli.shared.qos import suiting_qos
from tfloom.common.terminal import report
from tfloom.rmw.base import Graph
from tfloom.rmw.typed_names import SERVICE_EVENTS

KINDS = ("REQUEST_SENT", "REQUEST_RECEIVED", "RESPONSE_SENT", "RESPONSE_RECEIVED")
"""The constants of service_msgs/msg/ServiceEventInfo."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `service echo`."""
    parser.set_defaults(spin_time=graph.MAX_WAIT_S)
    parser.add_argument("service_name", help="name of the service")
    parser.add_argument("service_type", nargs="?", help="its type; not needed for a service on the graph")
    parser.add_argument("--csv", action="store_true", help="print the values alone, with commas between")
    parser.add_argument(
        "--json", action="store_true", help="print a line of JSON for each event, for programs"
    )
    parser.set_defaults(raw=False)
    message_text.add_arguments(parser)


def main(args: argparse.Namespace) -> int:
    """Print events until Ctrl-C."""
    name = full_topic_name(args.service_name, "service")
    events = name + SERVICE_EVENTS
    text = message_text.message_text(args)
    with graph.settled_participant(args.spin_time) as participant:
        cls = service_class(args.service_type or _type_of(participant.graph, name), participant).Event
        if not publishers_of(participant.graph, events):
            report(f"no publisher of the events of {name} yet (see service introspection)")
        publishers = wait_for_publishers(participant.graph, events, float("inf"))
        for sample in samples(participant, events, cls, suiting_qos(publishers)):
            if (event := decoded(cls, sample)) is not None:
                print(with_event_names(text(event)))
    return 0


def with_event_names(text: str) -> str:
    """Return the text of a service's event with the kind, a number in its first field, replaced by the name."""
    from tfloom.interfaces.service_msgs.msg import ServiceEventInfo

    names = {getattr(ServiceEventInfo, name): name for name in KINDS}
    return re.sub(
        r"^  event_type: (\d+)$",
        lambda match: f"  event_type: {names.get(int(match[1]), match[1])}",
        text,
        count=1,
        flags=re.MULTILINE,
    )


def _type_of(found: Graph, name: str) -> str:
    types = service_types(found.service_ends()).get(name)
    if not types:
        raise CommandError(
            f"Could not determine the type of service '{name}': it isn't on the graph; pass its type"
        )
    return types[0]
