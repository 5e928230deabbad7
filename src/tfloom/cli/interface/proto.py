"""Print a YAML value to start from, with an interface's fields and defaults."""

from __future__ import annotations

import argparse

from tfloom.cli.interfaces import message_class
from tfloom.rosidl.yaml_text import message_to_yaml


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add what `interface proto` takes."""
    parser.add_argument("--no-quotes", action="store_true", help="print no quotes around it")
    parser.add_argument("type", help="name of the message, as geometry_msgs/msg/Twist")


def main(args: argparse.Namespace) -> int:
    """Print the value."""
    quote = "" if args.no_quotes else '"'
    print(f"{quote}{message_to_yaml(message_class(args.type)())}{quote}")
    return 0
