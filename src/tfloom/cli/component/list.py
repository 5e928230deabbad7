"""List the containers and the components in them."""

from __future__ import annotations

import argparse

from tfloom.cli.component.containers import containers
from tfloom.cli.shared import graph
from tfloom.cli.shared.calls import call_each
from tfloom.cli.shared.listing import print_json


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `component list`."""
    graph.add_arguments(parser)
    parser.add_argument("container_node_name", nargs="?", help="full name of one container")
    parser.add_argument("--containers-only", action="store_true", help="leave out the components")
    parser.add_argument(
        "--json", action="store_true", help="print JSON for programs: the components of each container"
    )


def main(args: argparse.Namespace) -> int:
    """Print each container, and under it the id and name of each component."""
    with containers(args, args.container_node_name) as found:
        if args.containers_only:
            components: dict[str, dict[int, str]] = {container.node: {} for container in found}
        else:
            components = call_each({container.node: container.components for container in found})
    if args.json:
        print_json(components)
        return 0
    is_one = args.container_node_name is not None
    for container, names in components.items():
        if not is_one:
            print(container)
        for unique_id, name in names.items():
            print(f"{'' if is_one else '  '}{unique_id}  {name}")
    return 0
