"""The verbs of `param` about single parameters."""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator
from functools import partial
from typing import Any

from tfloom.cli.param.parameter_services import (
    TYPES,
    ParameterServices,
    nodes_with_parameters,
    requested_node,
    unknown_parameter,
)
from tfloom.cli.param.parameter_services import add_arguments as add_common_arguments
from tfloom.cli.shared.calls import call_each
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listing import print_json
from tfloom.common.terminal import report
from tfloom.interfaces.rcl_interfaces.msg import Parameter, ParameterDescriptor


def add_delete_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `param delete`."""
    add_common_arguments(parser)
    parser.add_argument("node_name", help="full name of the node")
    parser.add_argument("parameter_name", help="name of the parameter")


def delete_main(args: argparse.Namespace) -> int:
    """Delete the parameter by setting it to a value without type, and print the outcome."""
    with requested_node(args) as services:
        result = services.set([Parameter(name=args.parameter_name)])[0]
    reason = f": {result.reason}" if result.reason else ""
    if result.successful:
        print("Deleted parameter successfully")
    else:
        report(f"Deleting parameter failed{reason}")
    return 0 if result.successful else 1


def add_describe_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `param describe`."""
    add_common_arguments(parser)
    parser.add_argument("node_name", help="full name of the node")
    parser.add_argument("parameter_names", nargs="+", help="names of the parameters")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def describe_main(args: argparse.Namespace) -> int:
    """Print type, description and constraints of each."""
    with requested_node(args) as services:
        existing_names = services.names()
        for name in args.parameter_names:
            if name not in existing_names:
                raise unknown_parameter(services, name)
        descriptors = services.descriptors(args.parameter_names)
    if args.json:
        print_json(descriptors)
        return 0
    for descriptor in descriptors:
        print("\n".join(description_lines(descriptor)))
    return 0


def description_lines(descriptor: ParameterDescriptor) -> Iterator[str]:
    """Yield the lines on one parameter."""
    yield f"Parameter name: {descriptor.name}"
    yield f"  Type: {TYPES[descriptor.type] if descriptor.type < len(TYPES) else descriptor.type}"
    if descriptor.description:
        yield f"  Description: {descriptor.description}"
    yield "  Constraints:"
    yield from (f"    {name}: {value}" for name, value in _constraints(descriptor))


def _constraints(descriptor: ParameterDescriptor) -> Iterator[tuple[str, Any]]:
    if descriptor.read_only:
        yield "Read only", "true"
    ranges: list[Any] = [*descriptor.floating_point_range, *descriptor.integer_range]
    for limits in ranges:
        yield "Min value", limits.from_value
        yield "Max value", limits.to_value
        if limits.step > 0:
            yield "Step", limits.step
    if descriptor.additional_constraints:
        yield "Additional constraints", descriptor.additional_constraints


def add_list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `param list`."""
    add_common_arguments(parser, timeout=False)
    parser.add_argument("node_name", nargs="?", help="list the parameters of this node only")
    parser.add_argument("--filter", help="list only names that match this regular expression")
    parser.add_argument(
        "--param-prefixes", nargs="+", default=[], help="list only names below these prefixes"
    )
    parser.add_argument("--param-type", action="store_true", help="show each parameter's type")
    parser.add_argument("--json", action="store_true", help="print JSON for programs")


def list_main(args: argparse.Namespace) -> int:
    """Print the names in order, below their node's name if all nodes are listed."""
    try:
        pattern = re.compile(args.filter or "")
    except re.error as error:
        raise CommandError(f"--filter isn't a regular expression: {error}") from None
    _find_node_among_prefixes(args)
    with nodes_with_parameters(args, args.node_name) as nodes:
        names_by_node = call_each(
            {node: partial(_names, services, pattern, args) for node, services in nodes}
        )
    if args.json:
        print_json(names_by_node)
        return 0
    for node, names in names_by_node.items():
        if args.node_name is None:
            print(f"{node}:")
        for name, kind in names.items():
            print(f"  {name} (type: {kind})" if args.param_type else f"  {name}")
    return 0


def _find_node_among_prefixes(args: argparse.Namespace) -> None:
    """Take the last prefix for the node if it begins with a slash: no parameter does, and argparse can't tell."""
    if args.node_name is None and args.param_prefixes and args.param_prefixes[-1].startswith("/"):
        args.node_name = args.param_prefixes.pop()


def _names(
    services: ParameterServices, pattern: re.Pattern[str], args: argparse.Namespace
) -> dict[str, str | None]:
    """Return the types of the selected parameters by name; None if they weren't requested."""
    names = [name for name in services.names(args.param_prefixes) if pattern.search(name)]
    if not args.param_type:
        return dict.fromkeys(names)
    return {name: TYPES[kind] for name, kind in zip(names, services.types(names), strict=True)}
