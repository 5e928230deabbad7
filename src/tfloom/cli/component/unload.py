"""Unload components from a container."""

from __future__ import annotations

import argparse

from tfloom.cli.component.containers import containers
from tfloom.cli.shared import graph
from tfloom.cli.shared.numbers import unsigned


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `component unload`."""
    graph.add_arguments(parser)
    parser.add_argument("container_node_name", help="full name of the container")
    parser.add_argument(
        "component_uid", nargs="+", type=unsigned, help="id of a component, as `component list` prints it"
    )
    parser.add_argument("-q", "--quiet", action="store_true", help="print only the ids")


def main(args: argparse.Namespace) -> int:
    """Unload the components one by one, up to the first that the container doesn't unload."""
    with containers(args, args.container_node_name) as (container,):
        for unique_id in args.component_uid:
            container.unload(unique_id)
            print(
                unique_id
                if args.quiet
                else f"Unloaded component {unique_id} from '{container.node}' container node"
            )
    return 0
