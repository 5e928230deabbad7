"""List the parameters of a node, or of all nodes."""

from __future__ import annotations

import argparse
import re
from functools import partial

from tfloom.cli.param.parameter_services import TYPES, ParameterServices, nodes_with_parameters
from tfloom.cli.param.parameter_services import add_arguments as add_common_arguments
from tfloom.cli.shared.calls import call_each
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listing import print_json


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `param list`."""
    add_common_arguments(parser, timeout=False)
    parser.add_argument("node_name", nargs="?", help="list the parameters of this node only")
    parser.add_argument("--filter", help="list only names that match this regular expression")
    parser.add_argument(
        "--param-prefixes", nargs="+", default=[], help="list only names below these prefixes"
    )
    parser.add_argument("--param-type", action="store_true", help="show each parameter's type")
    parser.add_argument("--json", action="store_true", help="print JSON for programs")


def main(args: argparse.Namespace) -> int:
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
