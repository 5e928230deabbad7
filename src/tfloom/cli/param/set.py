"""Set a parameter."""

from __future__ import annotations

import argparse

from tfloom.cli.param.parameter_services import add_arguments as add_common_arguments
from tfloom.cli.param.parameter_services import requested_node
from tfloom.cli.shared.errors import CommandError
from tfloom.common.terminal import report
from tfloom.interfaces.rcl_interfaces.msg import Parameter


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `param set`."""
    add_common_arguments(parser)
    parser.add_argument("node_name", help="full name of the node")
    parser.add_argument("parameter_name", help="name of the parameter")
    parser.add_argument("value", help="its value in YAML, for example 150, true, abc or '[1, 2]'")


def main(args: argparse.Namespace) -> int:
    """Set the parameter and print the outcome."""
    from tfloom.node.parameters.parameter import get_parameter_value

    try:
        value = get_parameter_value(args.value)
    except ValueError as error:
        raise CommandError(f"The value of {args.parameter_name} can't be used: {error}") from None
    parameter = Parameter(name=args.parameter_name, value=value)
    with requested_node(args) as services:
        result = services.set([parameter])[0]
    reason = f": {result.reason}" if result.reason else ""
    if result.successful:
        print(f"Set parameter successful{reason}")
    else:
        report(f"Setting parameter failed{reason}")
    return 0 if result.successful else 1
