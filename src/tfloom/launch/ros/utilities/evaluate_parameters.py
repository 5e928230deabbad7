"""Normalized parameters with their substitutions performed, also as the messages of a node's parameters."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from tfloom.common.text import shortened
from tfloom.launch.core.base_classes import Substitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue
from tfloom.launch.ros.parameters_type import (
    EvaluatedParameters,
    EvaluatedParameterValue,
    Parameters,
    ParametersDict,
)
from tfloom.launch.ros.utilities.names import prefix_namespace
from tfloom.launch.ros.utilities.parameter_text import untyped_items, untyped_value
from tfloom.launch.utilities.argument_types import ensure_argument_type
from tfloom.launch.utilities.substitutions import perform_substitutions

if TYPE_CHECKING:
    from tfloom.node.parameters.parameter import Parameter as NodeParameter

__all__ = ["evaluate_parameter_dict", "evaluate_parameters", "to_parameters_list"]

_WRAP = (
    "If the parameter is meant to be a string, try wrapping it in "
    "launch_ros.parameter_descriptions.ParameterValue(value, value_type=str)"
)
_SCALARS = (bool, int, float, str)


def evaluate_parameters(context: LaunchContext, parameters: Parameters) -> EvaluatedParameters:
    """Return normalized parameters, evaluated: paths of files, mappings, and single parameters.

    Raises:
        TypeError: the text of substitutions stands for a value of a type that parameters don't have.
        SubstitutionFailure: a substitution can't be performed.
    """
    evaluated: list[Any] = []
    for parameter in parameters:
        if isinstance(parameter, ParameterFile):
            evaluated.append(parameter.evaluate(context))
        elif isinstance(parameter, Parameter):
            parameter.evaluate(context)
            evaluated.append(parameter)
        else:
            evaluated.append(evaluate_parameter_dict(context, parameter))
    return tuple(evaluated)


def evaluate_parameter_dict(
    context: LaunchContext, parameters: ParametersDict
) -> dict[str, EvaluatedParameterValue]:
    """Return a normalized mapping of names to values, evaluated.

    Raises:
        TypeError: it is not a mapping, or the text of substitutions stands for a value of a type that parameters don't
            have.
    """
    if not isinstance(parameters, dict):
        raise TypeError("expected dict")
    evaluated: dict[str, EvaluatedParameterValue] = {}
    for substitutions, value in parameters.items():
        ensure_argument_type(substitutions, tuple, "name", "evaluate_parameters")
        name = perform_substitutions(context, substitutions)
        evaluated[name] = _evaluate_value(context, name, value)
    return evaluated


def _evaluate_value(context: LaunchContext, name: str, value: Any) -> EvaluatedParameterValue:
    if isinstance(value, ParameterValue):
        try:
            return value.evaluate(context)
        except ValueError as error:
            raise ValueError(f"parameter {name}: {error}") from error
    if isinstance(value, tuple) and value:
        if isinstance(value[0], Substitution):
            read: EvaluatedParameterValue = _read(name, perform_substitutions(context, value))
            return read
        if isinstance(value[0], Sequence) and not isinstance(value[0], (str, bytes)):
            texts = [perform_substitutions(context, item) for item in value]
            try:
                items = untyped_items(texts)
            except ValueError as error:
                raise _unreadable(name, error) from error
            return cast("EvaluatedParameterValue", tuple(_checked_array(name, items)))
    if value == ():
        ensure_argument_type(value, (float, int, str, bool, bytes), "value")
    return cast("EvaluatedParameterValue", value)


def _read(name: str, text: str) -> Any:
    """Return the value that a text stands for."""
    try:
        value = untyped_value(text)
    except ValueError as error:
        raise _unreadable(name, error) from error
    if isinstance(value, list):
        return tuple(_checked_array(name, value))
    if isinstance(value, dict):
        raise TypeError(
            "Allowed value types are bytes, bool, int, float, str, Sequence[bool], Sequence[int], "
            f"Sequence[float], Sequence[str]. Got {type(value)} for parameter {name}, from "
            f"{shortened(repr(text))}. {_WRAP}"
        )
    return value


def _unreadable(name: str, error: ValueError) -> TypeError:
    return TypeError(f"Unable to parse the value of parameter {name} as yaml: {error}. {_WRAP}")


def _checked_array(name: str, items: list[Any]) -> list[Any]:
    kinds = {type(item) for item in items}
    if kinds == {int, float}:
        return [float(item) for item in items]
    if len(kinds) != 1 or not kinds <= {*_SCALARS, bytes}:
        raise TypeError(
            "Expected a non-empty sequence, with items of uniform type. Allowed sequence item types are bool, int, "
            f'float, str. Got inconsistent input for "{name}": {shortened(repr(items))}. {_WRAP}'
        )
    return items


def to_parameters_list(
    context: LaunchContext, node_name: str, namespace: str, evaluated_parameters: EvaluatedParameters
) -> list[NodeParameter]:
    """Return evaluated parameters as parameters of a node; those in files for other nodes are left out.

    Args:
        context: The launch.
        node_name: Name of the node, without its namespace.
        namespace: Namespace of the node.
        evaluated_parameters: What `evaluate_parameters` returned.
    """
    from tfloom.node.parameters.parameter import Parameter as NodeParameter

    values: dict[str, Any] = {}
    for parameters in evaluated_parameters:
        if isinstance(parameters, Path):
            values |= _values_in_file(parameters, node_name, namespace)
        elif isinstance(parameters, Parameter):
            name, value = parameters.evaluate(context)
            values[name] = value
        else:
            values |= parameters
    return [
        NodeParameter(name=name, value=list(value) if isinstance(value, tuple) else value)
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
