"""Delete a parameter."""

from __future__ import annotations

import argparse

from tfloom.cli.param.parameter_services import add_arguments as add_common_arguments
from tfloom.cli.param.parameter_services import requested_node
from tfloom.common.terminal import report
from tfloom.interfaces.rcl_interfaces.msg import Parameter


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `param delete`."""
    add_common_arguments(parser)
    parser.add_argument("node_name", help="full name of the node")
    parser.add_argument("parameter_name", help="name of the parameter")


def main(args: argparse.Namespace) -> int:
    """Delete the parameter by setting it to a value without type, and print the outcome."""
    with requested_node(args) as services:
        result = services.set([Parameter(name=args.parameter_name)])[0]
    reason = f": {result.reason}" if result.reason else ""
    if result.successful:
        print("Deleted parameter successfully")
    else:
        report(f"Deleting parameter failed{reason}")
    return 0 if result.successful else 1
