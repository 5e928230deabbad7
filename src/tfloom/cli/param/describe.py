"""Print the descriptions and constraints of parameters."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from typing import Any

from tfloom.cli.param.parameter_services import TYPES, requested_node, unknown_parameter
from tfloom.cli.param.parameter_services import add_arguments as add_common_arguments
from tfloom.cli.shared.listing import print_json
from tfloom.interfaces.rcl_interfaces.msg import ParameterDescriptor


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `param describe`."""
    add_common_arguments(parser)
    parser.add_argument("node_name", help="full name of the node")
    parser.add_argument("parameter_names", nargs="+", help="names of the parameters")
    parser.add_argument("--json", action="store_true", help="print a JSON list for programs")


def main(args: argparse.Namespace) -> int:
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
