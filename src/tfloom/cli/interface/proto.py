"""Print a YAML template: a message's fields, a service's request or an action's goal."""

from __future__ import annotations

import argparse

from tfloom.cli.shared.interfaces import action_class, message_class, service_class
from tfloom.rosidl.message import Message
from tfloom.rosidl.yaml_text import message_to_yaml


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `interface proto`."""
    parser.add_argument("--no-quotes", action="store_true", help="print without quotes")
    parser.add_argument("type", help="name of the interface, for example geometry_msgs/msg/Twist")


def main(args: argparse.Namespace) -> int:
    """Print the default values of the interface's fields, as YAML."""
    quote = "" if args.no_quotes else '"'
    print(f"{quote}{message_to_yaml(class_to_send(args.type)())}{quote}")
    return 0


def class_to_send(name: str) -> type[Message]:
    """Return the class that a user sends: the message, the request or the goal."""
    kind = name.split("/")[1:-1]
    if kind == ["srv"]:
        request: type[Message] = service_class(name).Request
        return request
    if kind == ["action"]:
        goal: type[Message] = action_class(name).Goal
        return goal
    return message_class(name)
