"""The parameter services of the nodes on the graph, and the flags of the verbs about parameters."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from tfloom.cli.shared import graph
from tfloom.cli.shared.calls import NodeServices
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.listen import cli_node, shown_node
from tfloom.cli.shared.names import did_you_mean, find_full_name
from tfloom.cli.shared.numbers import seconds
from tfloom.interfaces.rcl_interfaces import srv
from tfloom.interfaces.rcl_interfaces.msg import Parameter, ParameterDescriptor, ParameterValue
from tfloom.node.parameters.parameter_file import give_declared_types
from tfloom.rmw.base import Graph

TIMEOUT_S = 5.0
"""Wait for a node's response without --timeout [s]."""

TYPES = (
    "not set",
    "boolean",
    "integer",
    "double",
    "string",
    "byte array",
    "boolean array",
    "integer array",
    "double array",
    "string array",
)
"""The names of the constants of `rcl_interfaces/msg/ParameterType`."""


def add_arguments(parser: argparse.ArgumentParser, *, timeout: bool = True) -> None:
    """Add the flags of all verbs."""
    graph.add_arguments(parser)
    parser.add_argument(
        "--include-hidden-nodes",
        action="store_true",
        help="include nodes whose name begins with an underscore",
    )
    parser.add_argument(
        *(["--timeout"] if timeout else []),
        "--service-timeout",
        dest="timeout",
        metavar="N",
        type=seconds,
        default=TIMEOUT_S,
        help=f"longest wait for a node in seconds (default: {TIMEOUT_S:g})",
    )


class ParameterServices(NodeServices):
    """The parameter services of one node."""

    def names(self, prefixes: Sequence[str] = ()) -> list[str]:
        """Return the names of the parameters, all or those below prefixes, in order."""
        request = srv.ListParameters.Request(prefixes=list(prefixes))
        return sorted(self.call("list_parameters", srv.ListParameters, request).result.names)

    def value(self, name: str) -> ParameterValue:
        """Return the value of a parameter; its type is 0 if there is none."""
        request = srv.GetParameters.Request(names=[name])
        # Nodes respond to an unknown name with a value of no type, or with no value.
        values = self.call("get_parameters", srv.GetParameters, request).values
        return values[0] if values else ParameterValue()

    def values(self, names: Sequence[str]) -> list[ParameterValue]:
        """Return the values of parameters, in the order of the names; the type of one that has none is 0."""
        request = srv.GetParameters.Request(names=list(names))
        values = list(self.call("get_parameters", srv.GetParameters, request).values)
        # If one was declared with a type and no value, nodes respond without any values.
        return values if len(values) == len(names) else [self.value(name) for name in names]

    def types(self, names: Sequence[str]) -> list[int]:
        """Return the types of parameters, in the order of the names."""
        request = srv.GetParameterTypes.Request(names=list(names))
        return self._one_each(names, self.call("get_parameter_types", srv.GetParameterTypes, request).types)

    def descriptors(self, names: Sequence[str]) -> list[ParameterDescriptor]:
        """Return the descriptors of parameters, in the order of the names."""
        return self._one_each(names, self._described(names))

    def _described(self, names: Sequence[str]) -> Sequence[ParameterDescriptor]:
        request = srv.DescribeParameters.Request(names=list(names))
        response: srv.DescribeParameters_Response = self.call(
            "describe_parameters", srv.DescribeParameters, request
        )
        return response.descriptors

    def set(self, parameters: Sequence[Parameter]) -> list[Any]:
        """Set parameters and return the result of each. An empty list gets the type that the node has for it."""
        give_declared_types(parameters, lambda name: self._described([name]))
        request = srv.SetParameters.Request(parameters=list(parameters))
        return self._one_each(parameters, self.call("set_parameters", srv.SetParameters, request).results)

    def set_atomically(self, parameters: Sequence[Parameter]) -> Any:
        """Set all of these parameters or none, and return the one result."""
        give_declared_types(parameters, lambda name: self._described([name]))
        request = srv.SetParametersAtomically.Request(parameters=list(parameters))
        return self.call("set_parameters_atomically", srv.SetParametersAtomically, request).result

    def _one_each(self, asked: Sequence[Any], answers: Sequence[Any]) -> list[Any]:
        if len(answers) != len(asked):
            raise CommandError(f"the response of {self.node} doesn't have all of these parameters")
        return list(answers)


@contextmanager
def nodes_with_parameters(
    args: argparse.Namespace, node_name: str | None
) -> Iterator[list[tuple[str, ParameterServices]]]:
    """Yield the full name and the parameter services of the named node, or, with None, of each node that has some.

    Raises:
        CommandError: there is no such node; the text has the nearest names.
    """
    with (
        graph.settled_participant(args.spin_time) as participant,
        shown_node(participant, cli_node()) as own,
    ):
        yield [
            (name, ParameterServices(participant, own, name, args.timeout))
            for name in _node_names(participant.graph, args, node_name)
        ]


def _node_names(found: Graph, args: argparse.Namespace, asked: str | None) -> list[str]:
    names = [
        node.full for node in found.nodes() if args.include_hidden_nodes or not graph.is_hidden(node.full)
    ]
    if asked is None:
        served = {end.name for end in found.service_ends() if end.is_server}
        return [name for name in dict.fromkeys(names) if f"{name}/list_parameters" in served]
    return [find_full_name(asked, names, "Node not found")]


@contextmanager
def requested_node(args: argparse.Namespace) -> Iterator[ParameterServices]:
    """Yield the parameter services of the named node; see `nodes_with_parameters`."""
    with nodes_with_parameters(args, args.node_name) as nodes:
        yield nodes[0][1]


def unknown_parameter(services: ParameterServices, name: str) -> CommandError:
    """Return the error about a parameter that a node doesn't have, with the nearest names."""
    names = services.names()
    if name in names:
        return CommandError("Parameter not set\nit is declared, and has no value")
    return CommandError(f"Parameter not set{did_you_mean(name, names)}")
