"""Evaluated parameters as the messages of a node's parameters."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.ros.parameter_descriptions import Parameter as ParameterDescription
from tfloom.launch.ros.parameters_type import EvaluatedParameters
from tfloom.launch.ros.utilities.names import prefix_namespace

if TYPE_CHECKING:
    from tfloom.node.parameters.parameter import Parameter

__all__ = ["to_parameters_list"]


def to_parameters_list(
    context: LaunchContext, node_name: str, namespace: str, evaluated_parameters: EvaluatedParameters
) -> list[Parameter]:
    """Return evaluated parameters as parameters of a node; those in files for other nodes are left out.

    Args:
        context: The launch.
        node_name: Name of the node, without its namespace.
        namespace: Namespace of the node.
        evaluated_parameters: What `evaluate_parameters` returned.
    """
    from tfloom.node.parameters.parameter import Parameter

    values: dict[str, Any] = {}
    for parameters in evaluated_parameters:
        if isinstance(parameters, Path):
            values |= _values_in_file(parameters, node_name, namespace)
        elif isinstance(parameters, ParameterDescription):
            name, value = parameters.evaluate(context)
            values[name] = value
        else:
            values |= parameters
    return [
        Parameter(name=name, value=list(value) if isinstance(value, tuple) else value)
        for name, value in values.items()
    ]


def _values_in_file(path: Path, node_name: str, namespace: str) -> dict[str, Any]:
    from tfloom.node.parameters.parameter_file import read_parameter_file

    rules = read_parameter_file(path, can_be_flat=True)
    full_name = prefix_namespace(namespace or "/", node_name) or ""
    values = {rule.name: rule.value for rule in rules if rule.is_for(full_name)}
    if rules and not values:
        warnings.warn(f"No parameters for {full_name} in {path}", stacklevel=3)
    return values
