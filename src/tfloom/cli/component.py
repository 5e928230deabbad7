"""`component`: the nodes that containers hold; one function for the arguments of each verb, and one that runs it."""

from __future__ import annotations

import argparse
from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from tfloom.cli.parser import help_since
from tfloom.cli.shared import graph
from tfloom.cli.shared.calls import NodeServices, call_each
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listen import cli_node, shown_node
from tfloom.cli.shared.listing import print_json
from tfloom.cli.shared.names import find_full_name
from tfloom.cli.shared.numbers import seconds, unsigned
from tfloom.interfaces.composition_interfaces import srv
from tfloom.rmw.base import Graph

if TYPE_CHECKING:
    from tfloom.interfaces.rcl_interfaces.msg import Parameter

TIMEOUT_S = 5.0
"""Longest wait for a container's service, and for the response of those that only list or unload [s]."""
LOAD, UNLOAD, LIST = "_container/load_node", "_container/unload_node", "_container/list_nodes"
SERVICES: dict[str, type[Any]] = {LOAD: srv.LoadNode, UNLOAD: srv.UnloadNode, LIST: srv.ListNodes}
"""The services of a container, by their names below its own."""


class Container(NodeServices):
    """The services of one node that loads others into its process."""

    def components(self) -> dict[int, str]:
        """Return the full names of the loaded nodes by their ids."""
        response = self.call(LIST, srv.ListNodes, srv.ListNodes.Request())
        return dict(zip(response.unique_ids, response.full_node_names, strict=False))

    def load(self, request: srv.LoadNode_Request, timeout_s: float | None) -> tuple[int, str]:
        """Load a node; return its id and full name.

        Args:
            request: What is loaded.
            timeout_s: Longest wait for the response [s]; None: as long as the node's constructor takes.

        Raises:
            CommandError: the container has rejected it, or has not responded; the text has the reason.
        """
        response = self.call(LOAD, srv.LoadNode, request, float("inf") if timeout_s is None else timeout_s)
        if not response.success:
            raise CommandError(f"Failed to load component: {response.error_message.capitalize()}")
        return response.unique_id, response.full_node_name

    def unload(self, unique_id: int) -> None:
        """Unload a node.

        Raises:
            CommandError: the container has rejected it; the text has its reason.
        """
        response = self.call(UNLOAD, srv.UnloadNode, srv.UnloadNode.Request(unique_id=unique_id))
        if not response.success:
            reason = response.error_message.capitalize()
            raise CommandError(
                f"Failed to unload component {unique_id} from '{self.node}' container node\n    {reason}"
            )


def container_names(found: Graph) -> list[str]:
    """Return the full names of the nodes that have the services of a container, in order."""
    served = {(end.name, end.type_name) for end in found.service_ends() if end.is_server}
    return sorted(node.full for node in found.nodes() if is_container(node.full, served))


def is_container(node: str, served: Collection[tuple[str, str]]) -> bool:
    """Return whether a node, by its full name, has all services of a container among those served, with their types."""
    return all((f"{node}/{name}", kind._TYPE_NAME) in served for name, kind in SERVICES.items())


@contextmanager
def containers(args: argparse.Namespace, asked: str | None) -> Iterator[list[Container]]:
    """Yield the named container, or, with None, all containers.

    Raises:
        CommandError: there is no such container; the text has the nearest names.
    """
    with (
        graph.settled_participant(args.spin_time) as participant,
        shown_node(participant, cli_node()) as own,
    ):
        names = container_names(participant.graph)
        if asked is not None:
            names = [find_full_name(asked, names, f"Unable to find container node '{asked}'")]
        timeout_s = TIMEOUT_S if args.timeout is None else args.timeout
        yield [Container(participant, own, name, timeout_s) for name in names]


def _add_timeout(parser: argparse.ArgumentParser, default: str = f"{TIMEOUT_S:g}") -> None:
    """Add the flag for the waits; its default is None, which the help explains by `default`."""
    parser.add_argument(
        "--timeout",
        metavar="N",
        type=seconds,
        help=help_since(
            "lyrical", f"longest wait for a container, and for its response, in seconds (default {default})"
        ),
    )


def add_list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `component list`."""
    graph.add_arguments(parser)
    parser.add_argument("container_node_name", nargs="?", help="full name of one container")
    _add_timeout(parser)
    parser.add_argument("--containers-only", action="store_true", help="leave out the components")
    parser.add_argument(
        "--json", action="store_true", help="print JSON for programs: the components of each container"
    )


def list_main(args: argparse.Namespace) -> int:
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


LOG_LEVELS = {"unset": 0, "debug": 10, "info": 20, "warn": 30, "error": 40, "fatal": 50}
MAX_LOG_LEVEL = 255


def add_load_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `component load`."""
    graph.add_arguments(parser)
    parser.add_argument("container_node_name", help="full name of the container")
    add_component_arguments(parser)
    _add_timeout(parser, f"{TIMEOUT_S:g}, and no limit for the response")
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


def load_main(args: argparse.Namespace) -> int:
    """Load the component, and print the id that the container has given it."""
    request = srv.LoadNode.Request(
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
        unique_id, name = container.load(request, args.timeout)
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
    from tfloom.interfaces.rcl_interfaces.msg import Parameter
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


def add_standalone_arguments(parser: argparse.ArgumentParser) -> None:
    """Accept all arguments of ros2's verb."""
    parser.add_argument("argv", nargs=argparse.REMAINDER, help="accepted and not used")


def standalone_main(_: argparse.Namespace) -> int:
    """Raise the error that says why there are no components here; so does `component types`."""
    raise CommandError(
        "Components are C++ libraries that a C++ container loads; tfloom runs Python nodes, each by `run`. "
        "`component list`, `load` and `unload` work with the containers that others run on the domain"
    )


add_types_arguments, types_main = add_standalone_arguments, standalone_main


def add_unload_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `component unload`."""
    graph.add_arguments(parser)
    parser.add_argument("container_node_name", help="full name of the container")
    parser.add_argument(
        "component_uid", nargs="+", type=unsigned, help="id of a component, as `component list` prints it"
    )
    _add_timeout(parser)
    parser.add_argument("-q", "--quiet", action="store_true", help="print only the ids")


def unload_main(args: argparse.Namespace) -> int:
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
