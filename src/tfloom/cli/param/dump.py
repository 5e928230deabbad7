"""Print all parameters of a node as the YAML that `param load` and `--params-file` read."""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from typing import Any

from tfloom.cli.param.parameter_services import add_arguments as add_common_arguments
from tfloom.cli.param.parameter_services import nodes_with_parameters
from tfloom.cli.shared.listing import print_json


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `param dump`."""
    add_common_arguments(parser)
    parser.add_argument("node_name", help="full name of the node")
    parser.add_argument("--json", action="store_true", help="print JSON instead of YAML, for programs")


def main(args: argparse.Namespace) -> int:
    """Print the parameters below the name of their node and `ros__parameters`."""
    from tfloom.node.parameters.parameter import parameter_value_to_python
    from tfloom.node.values.value_text import tree_text

    with nodes_with_parameters(args, args.node_name) as nodes:
        node, services = nodes[0]
        names = services.names()
        messages = services.values(names)
    values = {
        name: parameter_value_to_python(message)
        for name, message in zip(names, messages, strict=True)
        if message.type
    }
    tree = {node: {"ros__parameters": nested(values)}}
    if args.json:
        print_json(tree)
    else:
        print(tree_text(tree))
    return 0


def nested(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return a mapping for each part before a dot: `a.b: 1` becomes `a: {b: 1}`.

    A name that is another's beginning (`a` beside `a.b`) keeps its dots below it.
    """
    tree: dict[str, Any] = {}
    for name, value in values.items():
        branch = tree
        *parents, leaf = name.split(".")
        for position, part in enumerate(parents):
            inner = branch.setdefault(part, {})
            # A parameter has the name of this branch: a mapping can't be a value as well, so the rest of the name keeps
            # its dots and becomes a key beside it.
            if not isinstance(inner, dict):
                leaf = ".".join([*parents[position:], leaf])
                break
            branch = inner
        branch[leaf] = value
    return tree
