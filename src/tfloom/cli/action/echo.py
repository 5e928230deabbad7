"""Print what the servers and clients of an action send one another."""

from __future__ import annotations

import argparse
import time
from contextlib import closing
from typing import Any

from tfloom.cli.service.echo import with_event_names
from tfloom.cli.shared import graph, message_text, qos
from tfloom.cli.shared.action_ends import action_ends
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.interfaces import action_class
from tfloom.cli.shared.listen import TopicReaders, cli_node, decoded, publishers_of, shown_node
from tfloom.cli.shared.names import did_you_mean, full_topic_name
from tfloom.common.terminal import report
from tfloom.rmw.base import Graph
from tfloom.rmw.qos import QoS
from tfloom.rmw.shared.waiting import wait_for_token
from tfloom.rmw.typed_names import CANCEL_GOAL, FEEDBACK, GET_RESULT, SEND_GOAL, SERVICE_EVENTS, STATUS
from tfloom.rosidl.message import Message

LOOK_S = 0.2
"""Period at which publishers are searched for, because a server may enable its introspection later [s]."""
PATIENCE_S = 2.0
"""Wait for publishers before the user gets a message about it [s]."""

INTERFACES = {
    "GOAL_SERVICE": SEND_GOAL + SERVICE_EVENTS,
    "CANCEL_SERVICE": CANCEL_GOAL + SERVICE_EVENTS,
    "RESULT_SERVICE": GET_RESULT + SERVICE_EVENTS,
    "FEEDBACK_TOPIC": FEEDBACK,
    "STATUS_TOPIC": STATUS,
}
"""What follows the action's name in that of the topic of each interface."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `action echo`."""
    parser.set_defaults(spin_time=graph.MAX_WAIT_S, raw=False)
    parser.add_argument("action_name", help="name of the action")
    parser.add_argument("action_type", nargs="?", help="its type; not needed for an action on the graph")
    qos.add_arguments(parser, default="compatible with all publishers of each topic")
    parser.add_argument("--csv", action="store_true", help="print the values alone, with commas between")
    parser.add_argument(
        "--json", action="store_true", help="print a line of JSON for each message, for programs"
    )
    parser.add_argument(
        "--interfaces",
        metavar="NAMES",
        type=_interfaces,
        default=list(INTERFACES),
        help=f"print these alone, with | between: {'|'.join(INTERFACES)}",
    )
    message_text.add_arguments(parser)


def _interfaces(text: str) -> list[str]:
    names = [name.strip() for name in text.split("|")]
    for name in names:
        if name not in INTERFACES:
            raise argparse.ArgumentTypeError(f"{name!r} is not one of {', '.join(INTERFACES)}")
    return names


def main(args: argparse.Namespace) -> int:
    """Print messages until Ctrl-C."""
    action = full_topic_name(args.action_name, "action")
    text = message_text.message_text(args)
    with (
        graph.settled_participant(args.spin_time) as participant,
        shown_node(participant, cli_node()) as node,
        closing(TopicReaders(participant, node)) as readers,
    ):
        classes = _classes(action_class(args.action_type or _type_of(participant.graph, action), participant))
        topics = {action + INTERFACES[interface]: interface for interface in args.interfaces}
        asked_qos = qos.requested_qos(args, QoS())
        report_s = time.monotonic() + PATIENCE_S
        while True:
            for name, interface in topics.items():
                publishers = publishers_of(participant.graph, name)
                if publishers and name not in readers:
                    readers.open(name, classes[interface], asked_qos or qos.suiting_qos(publishers))
            if time.monotonic() > report_s:
                report_s = float("inf")
                _report_missing([interface for name, interface in topics.items() if name not in readers])
            for name, cls, sample in readers.take():
                if (message := decoded(cls, sample)) is not None:
                    _print(topics[name], message, text, args)
            readers.warn_of_mismatches()
            wait_for_token(readers.queue, time.monotonic() + LOOK_S)


def _classes(action: type[Any]) -> dict[str, type[Message]]:
    """Return the class of the messages of each interface."""
    from tfloom.interfaces.action_msgs.msg import GoalStatusArray

    return {
        "GOAL_SERVICE": action.Impl.SendGoalService.Event,
        "CANCEL_SERVICE": action.Impl.CancelGoalService.Event,
        "RESULT_SERVICE": action.Impl.GetResultService.Event,
        "FEEDBACK_TOPIC": action.Impl.FeedbackMessage,
        "STATUS_TOPIC": GoalStatusArray,
    }


def _print(interface: str, message: Any, text: Any, args: argparse.Namespace) -> None:
    if args.json:
        print(text({"interface": interface, "message": message}))
    elif args.csv:
        print(f"{interface},{text(message)}")
    else:
        shown = text(message)
        print(f"interface: {interface}\n{with_event_names(shown) if 'SERVICE' in interface else shown}")


def _report_missing(interfaces: list[str]) -> None:
    """Print which interfaces nobody publishes; services need introspection, which is off by default."""
    if interfaces:
        report(
            f"no publisher yet of {', '.join(interfaces)}"
            + (
                " (services are published where a client or server calls configure_introspection)"
                if any("SERVICE" in interface for interface in interfaces)
                else ""
            )
        )


def _type_of(found: Graph, name: str) -> str:
    ends = action_ends(found)
    types = sorted({end.type_name for end in ends if end.name == name})
    if not types:
        raise CommandError(
            f"Could not determine the type of action '{name}': it isn't on the graph; pass its type"
            f"{did_you_mean(name, {end.name for end in ends})}"
        )
    if len(types) > 1:
        raise CommandError(f"The action '{name}' has several types, pass one: {', '.join(types)}")
    return types[0]
