"""Values of launch files and parameters: int, float, bool, str, lists of one of them, and substitutions for them."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import Any, List, Union

from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions
from tfloom.launch.utilities.texts import plain_value

__all__ = [
    "AllowedTypesTuple",
    "AllowedTypesType",
    "AllowedValueType",
    "FilePath",
    "ListTypesTuple",
    "ListTypesType",
    "ListValueType",
    "NormalizedScalarType",
    "NormalizedSequenceType",
    "NormalizedValueType",
    "ScalarTypesTuple",
    "ScalarTypesType",
    "ScalarValueType",
    "SequenceValueType",
    "SomeScalarType",
    "SomeSequenceType",
    "SomeValueType",
    "StrSomeScalarType",
    "StrSomeSequenceType",
    "StrSomeValueType",
    "coerce_list",
    "coerce_to_type",
    "extract_type",
    "get_typed_value",
    "is_instance_of",
    "is_instance_of_valid_type",
    "is_normalized_substitution",
    "is_substitution",
    "is_typing_list",
    "is_valid_scalar_type",
    "normalize_typed_substitution",
    "perform_typed_substitution",
]

ScalarTypesTuple = (int, float, bool, str)
ListTypesTuple = (List[int], List[float], List[bool], List[str])
AllowedTypesTuple = (*ScalarTypesTuple, *ListTypesTuple)

FilePath = Union[str, bytes, "os.PathLike[str]"]
"""The type of paths."""
AllowedTypesType = Any
ScalarTypesType = Any
ListTypesType = Any
ScalarValueType = Union[int, float, bool, str]
ListValueType = Union[list[int], list[float], list[bool], list[str]]
SequenceValueType = Sequence[ScalarValueType]
AllowedValueType = Union[ScalarValueType, SequenceValueType]
SomeScalarType = Union[SomeSubstitutionsType, int, float, bool]
StrSomeScalarType = SomeScalarType
SomeSequenceType = Sequence[SomeScalarType]
StrSomeSequenceType = SomeSequenceType
SomeValueType = Union[SomeScalarType, SomeSequenceType]
StrSomeValueType = SomeValueType
NormalizedScalarType = Union[list[Substitution], int, float, bool, str]
NormalizedSequenceType = list[NormalizedScalarType]
NormalizedValueType = Any


class NotConvertibleError(TypeError, ValueError):
    """A value of a class that can't be converted; also a ValueError, because callers catch that for bad texts."""


MAX_SHOWN = 500
"""Characters of a value that the text of an error has."""


def is_typing_list(data_type: Any) -> bool:
    """Return whether a type is `typing.List`, or one of it or of `list` with an item type; `list` alone is none."""
    return getattr(data_type, "__origin__", None) is list


def is_valid_scalar_type(data_type: Any) -> bool:
    """Return whether a type is int, float, bool or str."""
    return data_type in ScalarTypesTuple


def extract_type(data_type: Any) -> tuple[Any, bool]:
    """Return the type of a value or of a list's items, and whether it is a list.

    Raises:
        ValueError: the type is none of AllowedTypesTuple.
    """
    if (error := data_type_error(data_type)) is not None:
        raise error
    return _scalar_of(data_type), is_typing_list(data_type)


def data_type_error(data_type: Any) -> ValueError | None:
    """Return what `extract_type` raises, or None, for callers whose tracebacks shall be short."""
    if is_valid_scalar_type(_scalar_of(data_type)):
        return None
    known = ", ".join(kind.__name__ for kind in ScalarTypesTuple)
    return ValueError(
        f"Unrecognized data type: {data_type}: it is one of {known}, or a list of one, as list[int]"
    )


def _scalar_of(data_type: Any) -> Any:
    if not is_typing_list(data_type):
        return data_type
    items: tuple[Any, ...] = getattr(data_type, "__args__", ())
    return items[0] if len(items) == 1 else None


def _is_scalar(value: Any, scalar: type) -> bool:
    if scalar in (int, float) and isinstance(value, bool):  # for Python, a bool is an int
        return False
    return isinstance(value, scalar)


def is_instance_of_valid_type(value: Any, *, can_be_str: bool = False) -> bool:
    """Return whether a value is an int, float, bool, str, or a list of items of one of these types.

    Args:
        value: The value.
        can_be_str: Whether items of a list may also be texts.
    """
    return is_instance_of(value, None, can_be_str=can_be_str)


def is_instance_of(value: Any, data_type: Any = None, *, can_be_str: bool = False) -> bool:
    """Return whether a value has a type; None: any of AllowedTypesTuple.

    Args:
        value: The value.
        data_type: The type.
        can_be_str: Whether the value, or items of a list, may also be texts.

    Raises:
        ValueError: the type is none of AllowedTypesTuple.
    """
    if data_type is None:
        return any(is_instance_of(value, allowed, can_be_str=can_be_str) for allowed in AllowedTypesTuple)
    scalar, is_list = extract_type(data_type)
    if not is_list:
        return _is_scalar(value, scalar) or (can_be_str and isinstance(value, str))
    return isinstance(value, (list, tuple)) and all(
        _is_scalar(item, scalar) or (can_be_str and isinstance(item, str)) for item in value
    )


def coerce_to_type(value: str, data_type: Any = None, *, can_be_str: bool = False) -> Any:
    """Return the value that a text stands for.

    A float or an int is read as by Python (`1e-3`, `nan`), a bool as one of YAML's words in any case, or 1 or 0, and a
    list, or a value without a type, by the rules of YAML.

    Args:
        value: The text.
        data_type: The type; None: any of AllowedTypesTuple.
        can_be_str: Whether the text is returned if it is not a value of the type, and whether items of a list may be
            texts.

    Raises:
        ValueError: the text is not a value of the type.
        TypeError: `value` is not a text; it is a ValueError, too.
    """
    if not isinstance(value, str):
        raise NotConvertibleError(f"a text is expected, not '{type(value)}' ({value!r})")
    if data_type is str:
        return value
    try:
        if data_type is None:
            return _from_yaml(value, f"Failed to convert '{_short(value)}' using yaml rules", can_be_str)
        scalar, is_list = extract_type(data_type)
        return _as_list(value, scalar, can_be_str) if is_list else _as_scalar(value, scalar)
    except ValueError:
        if can_be_str:
            return value
        raise


_BOOLEANS = {
    "true": True,
    "yes": True,
    "on": True,
    "1": True,
    "false": False,
    "no": False,
    "off": False,
    "0": False,
}


def _as_scalar(text: str, scalar: type) -> Any:
    if scalar is not bool:
        return scalar(text)
    value = _BOOLEANS.get(text.strip().lower())
    if value is None:
        raise ValueError(f"Cannot convert value '{_short(text)}' to '{scalar}'")
    return value


def _as_list(text: str, scalar: type, can_be_str: bool) -> list[Any]:
    fault = f"Cannot convert value '{_short(text)}' to a list of '{scalar}'"
    value = _from_yaml(text, fault, can_be_str)
    if scalar is float and is_instance_of(value, list[int]):
        return [float(item) for item in value]
    if not is_instance_of(value, list[scalar], can_be_str=can_be_str):  # type: ignore[valid-type]
        raise ValueError(fault)
    return list(value)


def _from_yaml(text: str, fault: str, can_be_str: bool) -> Any:
    """Return what YAML reads.

    Raises:
        ValueError: the text is not YAML, or its value has none of the types that are allowed; it begins with `fault`.
    """
    if not text:
        return text
    # Most values are plain numbers and words, for which yaml needs not be loaded.
    value = plain_value(text)
    if value is not None:
        return value
    from tfloom.common.yaml import YamlError, load  # loads yaml

    try:
        value = load(text)
    except YamlError as error:
        raise ValueError(f"{fault}: {error}") from error
    if not is_instance_of_valid_type(value, can_be_str=can_be_str):
        raise ValueError(f"{fault}: output type is not allowed, got {type(value)}")
    return value


def _short(text: str) -> str:
    """Return the begin of a text for an error, because a robot's description may have a million characters."""
    return text if len(text) <= MAX_SHOWN else f"{text[:MAX_SHOWN]}…"


def coerce_list(value: list[str], data_type: Any = None, *, can_be_str: bool = False) -> list[Any]:
    """Return the values that texts stand for, all of one type.

    Args:
        value: The texts.
        data_type: The items' type; None: one that all have.
        can_be_str: Whether an item that is not a value of the type stays a text.

    Raises:
        ValueError: a text is not a value of the type, or they stand for values of several types.
        TypeError: `value` is not a list, or has items that are not texts; it is a ValueError, too.
    """
    if not isinstance(value, (list, tuple)):
        raise NotConvertibleError(f"a list of texts is expected, not '{type(value)}' ({value!r})")
    items = [coerce_to_type(text, data_type, can_be_str=can_be_str) for text in value]
    # Each text alone may stand for another type, as in "1", "a".
    if not is_instance_of(items, None if data_type is None else list[data_type], can_be_str=can_be_str):
        raise ValueError(f"cannot convert value to {data_type}. Got value=`{value}`")
    return items


def get_typed_value(value: str | list[str], data_type: Any, *, can_be_str: bool = False) -> Any:
    """Return the value that a text, or a list of texts, stands for.

    Args:
        value: The text or texts.
        data_type: The type; None: any of AllowedTypesTuple.
        can_be_str: Whether a text that is not a value of the type stays one.

    Raises:
        ValueError: it is not a value of the type.
        TypeError: it is a list, and the type is none.
    """
    if not isinstance(value, list):
        return coerce_to_type(value, data_type, can_be_str=can_be_str)
    if data_type is None:
        return coerce_list(value, can_be_str=can_be_str)
    scalar, is_list = extract_type(data_type)
    if not is_list:
        raise TypeError(f"Cannot convert input '{value}' of type '{type(value)}' to '{data_type}'")
    return coerce_list(value, scalar, can_be_str=can_be_str)


def is_substitution(x: Any) -> bool:
    """Return whether a value is a substitution, or a list of texts and at least one substitution."""
    if isinstance(x, Substitution):
        return True
    return (
        isinstance(x, Iterable)
        and not isinstance(x, str)
        and all(isinstance(item, (str, Substitution)) for item in x)
        and any(isinstance(item, Substitution) for item in x)
    )


def is_normalized_substitution(x: Any) -> bool:
    """Return whether a value is a list of substitutions, with at least one."""
    return isinstance(x, list) and bool(x) and all(isinstance(item, Substitution) for item in x)


def normalize_typed_substitution(value: Any, data_type: Any) -> Any:
    """Return a value with each of its substitutions as a list of them.

    Args:
        value: A value of a type of AllowedTypesTuple, a substitution, or a list with substitutions as items.
        data_type: The type that it has, or will have when it is performed; None: any.

    Raises:
        TypeError: it has another type.
    """
    if isinstance(value, tuple):
        value = list(value)
    # A list of texts and substitutions alone is one text, which may be that of a list: `["[", LaunchConfiguration("a"),
    # ", 2]"]`. The items of a list are lists themselves: `[[LaunchConfiguration("a")], 2]`.
    if is_substitution(value):
        if data_type is not None:
            extract_type(data_type)  # raises an error of a wrong type now, and not when the launch runs
        return normalize_to_list_of_substitutions(value)
    if is_instance_of(value, data_type):
        return value
    if not isinstance(value, list):
        raise TypeError(f"value='{value}' is not an instance of {data_type}")
    # A list in which some items are substitutions: their type is checked when they are performed.
    scalar = extract_type(data_type)[0] if data_type is not None else None
    items = []
    for item in value:
        if is_substitution(item):
            items.append(normalize_to_list_of_substitutions(item))
        elif is_instance_of(item, scalar) and not isinstance(item, list):
            items.append(item)
        else:
            raise TypeError(f"'{item}' in value='{value}' is not of type {scalar}, and no substitution")
    if not any(isinstance(item, list) for item in items):
        raise TypeError(f"the items of value='{value}' are of several types")
    return items


def perform_typed_substitution(context: LaunchContext, value: Any, data_type: Any) -> Any:
    """Return a normalized value with its substitutions performed.

    Args:
        context: The context.
        value: What `normalize_typed_substitution` returned.
        data_type: The type of the result; None: any of AllowedTypesTuple.

    Raises:
        ValueError: a substitution's text is not a value of the type.
        TypeError: a value that is not a substitution has another type; it is a ValueError, too.
    """
    if is_normalized_substitution(value):
        return coerce_to_type(perform_substitutions(context, value), data_type)
    if isinstance(value, list) and any(is_normalized_substitution(item) for item in value):
        scalar = extract_type(data_type)[0] if data_type is not None else None
        items = [
            coerce_to_type(perform_substitutions(context, item), scalar)
            if is_normalized_substitution(item)
            else item
            for item in value
        ]
        # Without a type each item got its own, so they may differ now.
        if not is_instance_of(items, data_type):
            raise ValueError(f"the items of {items} are not all of one type: {data_type or 'any'}")
        return items
    if not is_instance_of(value, data_type):
        raise NotConvertibleError(
            f"Expected an output of type '{data_type}', got '{type(value)}' ({value!r})"
        )
    return value
