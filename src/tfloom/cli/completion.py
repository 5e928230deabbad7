"""Completion of arguments: live topics and nodes, types, packages and programs."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterable

from tfloom.cli.parser import VerbParser
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.names import full_name
from tfloom.workspace import index
from tfloom.workspace.interfaces import interface_packages, known_interfaces

MAX_WAIT_S = 1.0
"""The longest wait of a completion for discovery [s]."""


def fill_typed_verb(parser: VerbParser, line: str) -> None:
    """Add the arguments of the command line's verb at once, because argcomplete reads them before it parses."""
    for word in line.split()[1:]:
        parser = parser.words.get(word, parser)
    parser.fill()


def complete_argument(
    prefix: str, action: argparse.Action, parser: argparse.ArgumentParser, parsed_args: argparse.Namespace
) -> list[str]:
    """Return the values that begin with the typed part of an argument; empty for free text."""
    if action.choices is not None:
        values: Iterable[str] = [str(choice) for choice in action.choices]
    else:
        verb = parser.prog.split()[1:]
        offer = find_offer(verb, action.dest)
        values = offer(parsed_args) if offer else ()
    return [value for value in values if value.startswith(prefix)]


def find_offer(verb: list[str], argument: str) -> Callable[[argparse.Namespace], Iterable[str]] | None:
    """Return the function that lists values for an argument of a verb, or None for free text."""
    keys = [(*verb[-1:], argument), (*verb[:1], argument), (argument,)]
    return next((_OFFERS[key] for key in keys if key in _OFFERS), None)


def _topics(_: argparse.Namespace) -> list[str]:
    from tfloom.cli.shared import graph

    with graph.settled_graph(MAX_WAIT_S) as found:
        names = graph.known_topics(found.endpoints())
    # Names are valid without their first slash, so they are also completed without it.
    return [*names, *(name[1:] for name in names)]


def _types_of_topic(args: argparse.Namespace) -> list[str]:
    """Return the type of the topic; all messages if there is no such topic."""
    from tfloom.cli.shared import graph

    with graph.settled_graph(MAX_WAIT_S) as found:
        types = graph.known_topics(found.endpoints())
    return types.get(full_name(args.topic_name or ""), []) or known_interfaces("msg")


def _nodes(_: argparse.Namespace) -> list[str]:
    from tfloom.cli.shared import graph

    with graph.settled_graph(MAX_WAIT_S) as found:
        return [node.full for node in found.nodes() if not graph.is_hidden(node.full)]


def _services(_: argparse.Namespace) -> list[str]:
    from tfloom.cli.shared import graph

    with graph.settled_graph(MAX_WAIT_S) as found:
        names = sorted({end.name for end in found.service_ends() if end.is_server})
    return [name for name in names if not graph.is_hidden(name)]


def _type_of_service(args: argparse.Namespace) -> list[str]:
    """Return the type of the service; all services if there is no such service."""
    from tfloom.cli.shared import graph

    with graph.settled_graph(MAX_WAIT_S) as found:
        ends = found.service_ends()
    return sorted({end.type_name for end in ends if end.name == args.service_name}) or known_interfaces("srv")


def _actions(_: argparse.Namespace) -> list[str]:
    from tfloom.cli.shared.action_ends import settled_ends

    return sorted({end.name for end in settled_ends()})


def _type_of_action(args: argparse.Namespace) -> list[str]:
    """Return the type of the action; all actions if there is no such action."""
    from tfloom.cli.shared.action_ends import settled_ends

    types = {end.type_name for end in settled_ends() if end.name == args.action_name}
    return sorted(types) or known_interfaces("action")


def _prototype(args: argparse.Namespace) -> list[str]:
    """Return a message, a request or a goal of the typed type with its defaults; nothing for an unknown type."""
    from tfloom.cli.shared.interfaces import action_class, message_class, service_class
    from tfloom.cli.shared.message_text import prototype

    try:
        if "message_type" in args:
            return [prototype(message_class(args.message_type)())]
        if "service_type" in args:
            return [prototype(service_class(args.service_type).Request())]
        return [prototype(action_class(args.action_type).Goal())]
    except CommandError:  # there is no such type
        return []


def _parameters(args: argparse.Namespace) -> list[str]:
    from tfloom.cli.param.parameter_services import nodes_with_parameters

    asked = argparse.Namespace(spin_time=MAX_WAIT_S, timeout=MAX_WAIT_S, include_hidden_nodes=True)
    with nodes_with_parameters(asked, args.node_name) as nodes:
        return nodes[0][1].names()


def _lifecycle_nodes(_: argparse.Namespace) -> list[str]:
    from tfloom.cli.lifecycle import lifecycle_nodes
    from tfloom.cli.shared import graph

    with graph.settled_graph(MAX_WAIT_S) as found:
        return lifecycle_nodes(found, hidden=False)


def _containers(_: argparse.Namespace) -> list[str]:
    from tfloom.cli.component import container_names
    from tfloom.cli.shared import graph

    with graph.settled_graph(MAX_WAIT_S) as found:
        return container_names(found)


def _components(args: argparse.Namespace) -> list[str]:
    """Return the ids of the components in the container."""
    from tfloom.cli.component import containers

    asked = argparse.Namespace(spin_time=MAX_WAIT_S, timeout=None)
    with containers(asked, args.container_node_name) as (container,):
        return [str(unique_id) for unique_id in container.components()]


def _transitions(args: argparse.Namespace) -> list[str]:
    """Return the transitions that are available on the node."""
    from tfloom.cli.lifecycle import TIMEOUT_S, lifecycles

    asked = argparse.Namespace(spin_time=MAX_WAIT_S, include_hidden_nodes=True, timeout=TIMEOUT_S)
    with lifecycles(asked, args.node_name) as nodes:
        return [description.transition.label for description in nodes[0].transitions()]


def _frames(args: argparse.Namespace) -> list[str]:
    """Return the frames of the live graph, or of the bag or file of --bag."""
    from tfloom.cli.tf import source
    from tfloom.tf2_tools.watch.model import stored_name

    with source.open_source(args) as opened:
        frames = source.settled(opened, MAX_WAIT_S).frames()
    return sorted({stored_name(frame) for frame in frames})


def _packages(_: argparse.Namespace) -> list[str]:
    return sorted({*index.workspace_packages(), *index.own_packages()})


def _packages_with_programs(_: argparse.Namespace) -> list[str]:
    built = [
        name for name, prefix in index.workspace_packages().items() if index.package_programs(name, prefix)
    ]
    return sorted({*built, *index.PROGRAMS})


def _programs(args: argparse.Namespace) -> list[str]:
    prefix = index.find_package(args.package_name)
    if prefix is None:
        return list(index.PROGRAMS.get(args.package_name, {}))
    return [index.program_name(path) for path in index.package_programs(args.package_name, prefix)]


_OFFERS: dict[tuple[str, ...], Callable[[argparse.Namespace], Iterable[str]]] = {
    ("topic_name",): _topics,
    ("delay", "topic"): _topics,
    ("record", "topics_positional"): _topics,
    ("record", "topics"): _topics,
    ("message_type",): _types_of_topic,
    ("service_name",): _services,
    ("service_type",): _type_of_service,
    ("action_name",): _actions,
    ("action_type",): _type_of_action,
    ("find", "action_type"): lambda _: known_interfaces("action"),
    ("pub", "values"): _prototype,
    ("call", "values"): _prototype,
    ("send_goal", "goal"): _prototype,
    ("parameter_name",): _parameters,
    ("parameter_names",): _parameters,
    ("topic_type",): lambda _: known_interfaces("msg"),
    ("find", "service_type"): lambda _: known_interfaces("srv"),
    ("target_frame",): _frames,
    ("source_frame",): _frames,
    ("transition",): _transitions,
    ("lifecycle", "node_name"): _lifecycle_nodes,
    ("component_uid",): _components,
    ("container_node_name",): _containers,
    ("node_name",): _nodes,
    ("package_name",): _packages,
    ("run", "package_name"): _packages_with_programs,
    ("executable_name",): _programs,
    ("interface", "package_name"): lambda _: list(interface_packages()),
    ("interface", "type"): lambda _: known_interfaces(),
}
"""The values to list, by the last or first word of the verb and the argument's name, or by the name alone."""
