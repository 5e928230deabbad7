"""Parameters in every form, normalized: files, and mappings of names to values without mappings in them."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, cast

from tfloom.common.seconds import plain_value
from tfloom.launch.core.base_classes import Substitution, TextSubstitution
from tfloom.launch.ros.parameter_descriptions import Parameter, ParameterFile
from tfloom.launch.ros.parameter_descriptions import ParameterValue as ParameterValueDescription
from tfloom.launch.ros.parameters_type import (
    ParameterName,
    Parameters,
    ParametersDict,
    ParameterValue,
    SomeParameters,
    SomeParametersDict,
)
from tfloom.launch.utilities.argument_types import ensure_argument_type
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions
from tfloom.node.values.scalars import parse_scalar

__all__ = ["normalize_parameter_dict", "normalize_parameters", "parameters_error"]

_PLAIN = re.compile(r"[A-Za-z_/][A-Za-z0-9_/]*")
"""Texts for which the module yaml need not be imported, unless they are words such as `on` and `inf`."""


def normalize_parameters(parameters: SomeParameters) -> Parameters:
    """Return what `Node(parameters=…)` was given as files, mappings and single parameters.

    Raises:
        TypeError: it is not a list, or an item, a name or a value is of no type that parameters have.
    """
    if isinstance(parameters, str) or not isinstance(parameters, Sequence):
        raise TypeError(f"Expecting list of parameters, got {parameters}")
    return [_normalize_item(item) for item in parameters]


def parameters_error(parameters: Any) -> TypeError | None:
    """Return the error of what Node(parameters=…) can't take, or None, for callers whose tracebacks shall be short."""
    if parameters is None:
        return None
    if not isinstance(parameters, (list, tuple)):
        return TypeError(
            f"'Node' expected 'parameters' to be one of [<class 'list'>], but got '{parameters}' of type "
            f"'{type(parameters)}': write parameters=[{parameters!r}]"
        )
    errors = (_values_error(item) if isinstance(item, Mapping) else _item_error(item) for item in parameters)
    return next((error for error in errors if error is not None), None)


def _item_error(item: Any) -> TypeError | None:
    if isinstance(item, (ParameterFile, Parameter, str, Path, Substitution)):
        return None
    is_list = isinstance(item, Sequence) and not isinstance(item, bytes)
    if is_list and all(isinstance(part, (str, Substitution)) for part in item):
        return None
    return TypeError(
        f"Expecting a file, a dictionary or a Parameter in the list of parameters, got {item!r} of type "
        f"'{type(item).__name__}'"
    )


def _values_error(parameters: Mapping[Any, Any]) -> TypeError | None:
    for name, given in parameters.items():
        value = plain_value(given)
        if isinstance(value, Mapping):
            if (error := _values_error(value)) is not None:
                return error
        elif not isinstance(
            value, (str, Substitution, bool, int, float, bytes, ParameterValueDescription, Sequence)
        ):
            return _value_error(name, value)
    return None


def _value_error(name: Any, value: Any) -> TypeError:
    given = f"of class {type(value).__name__}, given to the parameter {name!r}"
    return TypeError(f"Unexpected type for parameter value {value!r}, {given}")


def _normalize_item(item: Any) -> ParameterFile | ParametersDict | Parameter:
    if isinstance(item, (ParameterFile, Parameter)):
        return item
    if isinstance(item, Mapping):
        return normalize_parameter_dict(item)
    if (error := _item_error(item)) is not None:
        raise error
    return ParameterFile(item)


def normalize_parameter_dict(
    parameters: SomeParametersDict, *, _prefix: Sequence[Substitution] | None = None
) -> ParametersDict:
    """Return values by name; a mapping as a value becomes several names, with dots.

    Raises:
        TypeError: it is not a mapping, or a name or a value is of no type that parameters have.
    """
    if not isinstance(parameters, Mapping):
        raise TypeError("expected dict")
    normalized: ParametersDict = {}
    for given_name, value in parameters.items():
        name = _normalize_name(given_name, _prefix)
        if isinstance(value, Mapping):
            normalized |= normalize_parameter_dict(value, _prefix=name)
        else:
            normalized[name] = _normalize_value(given_name, value)
    return normalized


def _normalize_name(name: Any, prefix: Sequence[Substitution] | None) -> ParameterName:
    is_list = isinstance(name, Sequence) and not isinstance(name, bytes)
    if not is_list and not isinstance(name, Substitution):
        raise TypeError(f"Expecting a text or substitutions as the name of a parameter, got {name!r}")
    parts = normalize_to_list_of_substitutions(name)
    return (*prefix, TextSubstitution(text="."), *parts) if prefix else tuple(parts)


def _normalize_value(name: Any, given: Any) -> ParameterValue:
    value = plain_value(given)
    if isinstance(value, str):
        # In quotes, if rcl's rules would read it as something else than this text.
        return (TextSubstitution(text=_as_yaml(value)),)
    if isinstance(value, Substitution):
        return (value,)
    if isinstance(value, (bool, int, float, bytes, ParameterValueDescription)):
        return value
    if isinstance(value, Sequence):
        return _normalize_array(name, value)
    raise _value_error(name, value)


def _as_yaml(text: str) -> str:
    if _PLAIN.fullmatch(text) and parse_scalar(text) == text:
        return text
    from tfloom.node.values.value_text import value_text

    return value_text(text)


def _normalize_array(name: Any, array: Sequence[Any]) -> ParameterValue:
    """Return an array of one type, or the substitutions that are concatenated, or those of each item."""
    for item in array:
        if isinstance(item, Mapping):
            raise RuntimeError(f"Failed to handle type {item}: it is an item of the parameter {name!r}")
        ensure_argument_type(
            item, (float, int, str, bool, Substitution, Sequence), "subvalue", "normalize_parameters"
        )
    kinds = {_item_type(item) for item in array}
    if not kinds <= {str, Substitution, Sequence}:
        return _plain_array(name, array, kinds)
    if kinds == {str}:
        return tuple((TextSubstitution(text=_as_yaml(item)),) for item in array)
    if Sequence not in kinds:
        # Texts and substitutions are concatenated, as everywhere where a launch file has a list of them.
        return tuple(normalize_to_list_of_substitutions(array))
    return tuple(tuple(normalize_to_list_of_substitutions(item)) for item in array)


def _shown(name: Any) -> str:
    parts = normalize_to_list_of_substitutions(name)
    return "".join(part.text if isinstance(part, TextSubstitution) else part.describe() for part in parts)


def _item_type(item: Any) -> type:
    for kind in (bool, int, float, str, Substitution):
        if isinstance(item, kind):
            return kind
    return cast("type", Sequence)


def _plain_array(name: Any, array: Sequence[Any], kinds: set[type]) -> ParameterValue:
    if kinds == {int, float}:
        return tuple(float(item) for item in array)
    if len(kinds) > 1:
        raise TypeError(
            "Expected a non-empty sequence, with items of uniform type. Allowed sequence item types are bool, int, "
            f'float, str. Got inconsistent input for "{_shown(name)}": {list(array)!r}'
        )
    return tuple(array)
