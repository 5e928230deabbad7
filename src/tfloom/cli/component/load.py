"""Load a component into a container."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from tfloom.cli.component.containers import containers
from tfloom.cli.shared import graph
from tfloom.cli.shared.errors import CommandError
from tfloom.interfaces.composition_interfaces.srv import LoadNode
from tfloom.interfaces.rcl_interfaces.msg import Parameter

LOG_LEVELS = {"unset": 0, "debug": 10, "info": 20, "warn": 30, "error": 40, "fatal": 50}
MAX_LOG_LEVEL = 255


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `component load`."""
    graph.add_arguments(parser)
    parser.add_argument("container_node_name", help="full name of the container")
    add_component_arguments(parser)
    parser.add_argument("-q", "--quiet", action="store_true", help="print only id and name")


def add_component_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments that say which component is loaded, and how."""
    parser.add_argument("package_name", help="package of the component")
    parser.add_argument("plugin_name", help="type of the component, for example composition::Talker")
    parser.add_argument("-n", "--node-name", default="", help="name of the node")
    parser.add_argument("--node-namespace", default="", help="its namespace")
    parser.add_argument(
        "--log-level", type=log_level, default=0, help=f"its log level: {', '.join(LOG_LEVELS)}"
    )
    parser.add_argument(
        "-r", "--remap-rule", action="append", default=[], dest="remap_rules", help="a remapping, as from:=to"
    )
    parser.add_argument(
        "-p",
        "--parameter",
        action="append",
        default=[],
        dest="parameters",
        help="a parameter, as name:=value",
    )
    parser.add_argument(
        "-e",
        "--extra-argument",
        action="append",
        default=[],
        dest="extra_arguments",
        help="an argument of the container for this component, as use_intra_process_comms:=true",
    )


def log_level(text: str) -> int:
    """Return a log level, given by its name or number.

    Raises:
        argparse.ArgumentTypeError: there is no such level.
    """
    try:
        return log_level_number(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def log_level_number(text: str) -> int:
    """Return a log level, given by its name or number; ValueError if there is no such level."""
    level = LOG_LEVELS.get(text.lower())
    if level is None and text.isdecimal():
        level = int(text)
    if level is None or level > MAX_LOG_LEVEL:
        raise ValueError(f"must be one of {', '.join(LOG_LEVELS)}, not {text!r}")
    return level


def main(args: argparse.Namespace) -> int:
    """Load the component, and print the id that the container has given it."""
    request = LoadNode.Request(
        package_name=args.package_name,
        plugin_name=args.plugin_name,
        node_name=args.node_name,
        node_namespace=args.node_namespace,
        log_level=args.log_level,
        remap_rules=args.remap_rules,
        parameters=parameters_of(args.parameters),
        extra_arguments=parameters_of(args.extra_arguments),
    )
    with containers(args, args.container_node_name) as (container,):
        unique_id, name = container.load(request)
    if args.quiet:
        print(f"{unique_id}  {name}")
    else:
        print(f"Loaded component {unique_id} into '{container.node}' container node as '{name}'")
    return 0


def parameters_of(rules: Sequence[str]) -> list[Parameter]:
    """Return the parameters of rules as `name:=value`.

    Raises:
        CommandError: a rule is none, or its value can't be used.
    """
    from tfloom.node.parameters.parameter import get_parameter_value

    parameters: list[Parameter] = []
    for rule in rules:
        name, separator, value = rule.partition(":=")
        if not name or not separator:
            raise CommandError(f"{rule!r} is not a parameter: write name:=value")
        try:
            parameters.append(Parameter(name=name, value=get_parameter_value(value)))
        except ValueError as error:
            raise CommandError(f"The value of {name} can't be used: {error}") from None
    return parameters
