"""Types of attributes."""

from __future__ import annotations

from typing import Any, List

from tfloom.launch.core.entity import Entity
from tfloom.launch.utilities.type_utils import is_typing_list

__all__ = ["check_is_list_entity", "get_data_type_from_identifier"]

_TYPES: dict[str, Any] = {
    "str": str,
    "bool": bool,
    "float": float,
    "int": int,
    "list_of_str": List[str],
    "list_of_bool": List[bool],
    "list_of_float": List[float],
    "list_of_int": List[int],
    "yaml": None,
}


def check_is_list_entity(data_type: Any) -> bool:
    """Return whether a type is a list of elements, as `List[Entity]`."""
    items: tuple[Any, ...] = getattr(data_type, "__args__", ())
    return (
        is_typing_list(data_type)
        and len(items) == 1
        and isinstance(items[0], type)
        and issubclass(items[0], Entity)
    )


def get_data_type_from_identifier(type_identifier: str) -> Any:
    """Return the type that a launch file names, as `list_of_int`; None for `yaml`.

    Raises:
        ValueError: it is none of the types.
    """
    if type_identifier not in _TYPES:
        raise ValueError(
            f"Got invalid type identifier '{type_identifier}'; the types are {', '.join(_TYPES)}"
        )
    return _TYPES[type_identifier]
