"""Print the values of parameters."""

from __future__ import annotations

import argparse
from functools import partial
from typing import Any

from tfloom.cli.param.parameter_services import add_arguments as add_common_arguments
from tfloom.cli.param.parameter_services import nodes_with_parameters, requested_node, unknown_parameter
from tfloom.cli.shared.calls import call_each
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listing import json_text, print_json
from tfloom.interfaces.rcl_interfaces.msg import ParameterValue

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
    parser.add_argument(
        "node_name", metavar="node_name", nargs="?", help="full name of the node; without it, all nodes"
    )
    parser.add_argument("parameter_name", nargs="*", help="name of the parameter, or of several")
    parser.add_argument("--hide-type", action="store_true", help="print the value alone")
    parser.add_argument("--json", action="store_true", help="print the value as JSON for programs")


def main(args: argparse.Namespace) -> int:
    """Print the value after its type's label; of several, each below its node's name or after its own."""
    if args.node_name is None:
        raise CommandError("name a parameter, or a node and its parameters")
    if not args.parameter_name:
        return _of_all_nodes(args, args.node_name)
    with requested_node(args) as services:
        values = services.values(args.parameter_name)
        for name, value in zip(args.parameter_name, values, strict=True):
            if not 0 < value.type < len(LABELS):
                raise unknown_parameter(services, name)
    if args.json:
        plain = {name: _python(value) for name, value in zip(args.parameter_name, values, strict=True)}
        print(json_text(plain if len(plain) > 1 else _python(values[0])))
    elif len(values) == 1:
        print(_text(values[0], args))
    else:
        for name, value in zip(args.parameter_name, values, strict=True):
            print(f"{name}: {_text(value, args)}")
    return 0


def _of_all_nodes(args: argparse.Namespace, name: str) -> int:
    """Print the value of a parameter of each node that has it.

    Raises:
        CommandError: the name is that of a node, or no node has such a parameter.
    """
    if name.startswith("/"):
        raise CommandError(f"name the parameters of {name} to print, or use `param dump {name}`")
    with nodes_with_parameters(args, None) as nodes:
        found = call_each({node: partial(services.value, name) for node, services in nodes})
    values = {node: value for node, value in found.items() if 0 < value.type < len(LABELS)}
    if not values:
        raise CommandError(f"Parameter not set\nno node has a parameter {name} with a value")
    if args.json:
        print_json({node: _python(value) for node, value in values.items()})
        return 0
    for node, value in values.items():
        print(f"{node}:\n  {_text(value, args)}")
    return 0


def _python(value: ParameterValue) -> Any:
    from tfloom.node.parameters.parameter import parameter_value_to_python

    return parameter_value_to_python(value)


def _text(value: ParameterValue, args: argparse.Namespace) -> str:
    return f"{_python(value)}" if args.hide_type else f"{LABELS[value.type]} {_python(value)}"
