"""The functions of `ros2param.api`: parameters of other nodes."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from typing import Any

from tfloom.cli.api.node import get_absolute_node_name
from tfloom.cli.api.nodes import DirectNode, GraphNode, node_of
from tfloom.cli.param.parameter_services import TYPES
from tfloom.common.terminal import report
from tfloom.interfaces.rcl_interfaces.msg import Parameter, ParameterValue
from tfloom.interfaces.rcl_interfaces.srv import (
    DescribeParameters_Response,
    GetParameters_Response,
    SetParameters_Response,
)
from tfloom.node.builtin.parameter_client import AsyncParameterClient
from tfloom.node.client_library import spin_until_future_complete
from tfloom.node.executing.task import Future
from tfloom.node.parameters.parameter import parameter_dict_from_yaml_file, parameter_value_to_python
from tfloom.node.parameters.parameter_file import give_declared_types

__all__ = [
    "ParameterNameCompleter",
    "call_describe_parameters",
    "call_get_parameters",
    "call_list_parameters",
    "call_set_parameters",
    "get_parameter_type_string",
    "get_value",
    "load_parameter_file",
]

TIMEOUT_S = 5.0
"""Wait for a node's parameter services [s]."""


def get_value(*, parameter_value: ParameterValue) -> Any:
    """Return the value in a message; None if it is not set, or of an unknown type."""
    try:
        return parameter_value_to_python(parameter_value)
    except RuntimeError:
        return None


def get_parameter_type_string(parameter_type: int) -> str:
    """Return the name of a type of `rcl_interfaces/msg/ParameterType`, as `boolean`.

    Raises:
        KeyError: there is no such type.
    """
    return dict(enumerate(TYPES))[parameter_type]


def load_parameter_file(*, node: GraphNode, node_name: str, parameter_file: str, use_wildcard: bool) -> None:
    """Set the parameters of a node to those of a file, and print what became of each.

    Raises:
        RuntimeError: the node's services aren't there or don't respond, or the file has nothing for the node.
    """
    client = _client(node, node_name)
    full = get_absolute_node_name(node_name) or ""
    parameters = parameter_dict_from_yaml_file(parameter_file, use_wildcard, target_nodes=[full])
    messages = list(parameters.values())
    _give_types(node, client, node_name, messages)
    future = client.set_parameters(messages)
    for name, result in zip(parameters, _response(node, future, node_name).results, strict=True):
        reason = f": {result.reason}" if result.reason else ""
        if result.successful:
            print(f"Set parameter {name} successful{reason}")
        else:
            report(f"Set parameter {name} failed{reason}")


def call_describe_parameters(
    *, node: GraphNode, node_name: str, parameter_names: Sequence[str] | None = None
) -> DescribeParameters_Response:
    """Return a node's response with the descriptors of parameters.

    Raises:
        RuntimeError: the node's services aren't there, or don't respond.
    """
    future = _client(node, node_name).describe_parameters(list(parameter_names or ()))
    response: DescribeParameters_Response = _response(node, future, node_name)
    return response


def call_get_parameters(
    *, node: GraphNode, node_name: str, parameter_names: Sequence[str]
) -> GetParameters_Response:
    """Return a node's response with the values of parameters.

    Raises:
        RuntimeError: the node's services aren't there, or don't respond.
    """
    future = _client(node, node_name).get_parameters(list(parameter_names))
    response: GetParameters_Response = _response(node, future, node_name)
    return response


def call_set_parameters(
    *, node: GraphNode, node_name: str, parameters: Sequence[Any]
) -> SetParameters_Response:
    """Set parameters, and return a node's response with a result for each.

    Raises:
        RuntimeError: the node's services aren't there, or don't respond.
    """
    client = _client(node, node_name)
    messages = [
        one.to_parameter_msg() if hasattr(one, "to_parameter_msg") else copy.deepcopy(one)
        for one in parameters
    ]
    _give_types(node, client, node_name, messages)
    future = client.set_parameters(messages)
    response: SetParameters_Response = _response(node, future, node_name)
    return response


def call_list_parameters(
    *, node: GraphNode, node_name: str, prefixes: Sequence[str] | None = None
) -> Future[Any] | None:
    """Return the future of a node's response with the names of its parameters, which is done.

    Returns:
        None if the node's services aren't there.
    """
    client = AsyncParameterClient(node_of(node), node_name)
    if not client.wait_for_services(timeout_sec=TIMEOUT_S):
        return None
    future = client.list_parameters(list(prefixes or ()))
    spin_until_future_complete(node_of(node), future)
    return future


def _give_types(
    node: GraphNode, client: AsyncParameterClient, node_name: str, parameters: Sequence[Parameter]
) -> None:
    """Give empty lists, which were read from YAML, the types that the node has for them."""
    give_declared_types(
        parameters, lambda name: _response(node, client.describe_parameters([name]), node_name).descriptors
    )


def _client(node: GraphNode, node_name: str) -> AsyncParameterClient:
    client = AsyncParameterClient(node_of(node), node_name)
    if not client.wait_for_services(timeout_sec=TIMEOUT_S):
        raise RuntimeError("Wait for service timed out")
    return client


def _response(node: GraphNode, future: Future[Any], node_name: str) -> Any:
    spin_until_future_complete(node_of(node), future)
    response = future.result()
    if response is None:
        raise RuntimeError(f"Exception while calling service of node '{node_name}': {future.exception()}")
    return response


class ParameterNameCompleter:
    """Lists the parameters of the node that a command line names."""

    def __call__(self, prefix: str, parsed_args: Any, **_: Any) -> list[str]:
        """Return the words that may follow on the command line."""
        with DirectNode(parsed_args) as node:
            future = call_list_parameters(node=node, node_name=parsed_args.node_name)
            response = future and future.result()
            return list(response.result.names) if response else []
