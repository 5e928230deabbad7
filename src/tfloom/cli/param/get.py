"""Print a parameter's value."""

from __future__ import annotations

import argparse

from tfloom.cli.param.parameter_services import add_arguments as add_common_arguments
from tfloom.cli.param.parameter_services import requested_node, unknown_parameter
from tfloom.cli.shared.listing import json_text

LABELS = (
    "",
    "Boolean value is:",
    "Integer value is:",
    "Double value is:",
    "String value is:",
    "Byte values are:",
    "Boolean values are:",
    "Integer values are:",
    "Double values are:",
    "String values are:",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `param get`."""
    add_common_arguments(parser)
    parser.add_argument("node_name", help="full name of the node")
    parser.add_argument("parameter_name", help="name of the parameter")
    parser.add_argument("--hide-type", action="store_true", help="print the value alone")
    parser.add_argument("--json", action="store_true", help="print the value as JSON for programs")


def main(args: argparse.Namespace) -> int:
    """Print the value after its type's label."""
    from tfloom.node.parameters.parameter import parameter_value_to_python

    with requested_node(args) as services:
        message = services.value(args.parameter_name)
        if not 0 < message.type < len(LABELS):
            raise unknown_parameter(services, args.parameter_name)
    value = parameter_value_to_python(message)
    if args.json:
        print(json_text(value))
    else:
        print(value if args.hide_type else f"{LABELS[message.type]} {value}")
    return 0
