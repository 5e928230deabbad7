"""RIHS01, the hash of a type: SHA-256 of its type description as JSON (REP-2011)."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterable
from typing import Any

from tfloom.rosidl import spec

# type_description_interfaces/msg/FieldType
NESTED = 1
TYPE_IDS = {
    "int8": 2,
    "uint8": 3,
    "int16": 4,
    "uint16": 5,
    "int32": 6,
    "uint32": 7,
    "int64": 8,
    "uint64": 9,
    "float32": 10,
    "float64": 11,
    "char": 3,
    "bool": 15,
    "byte": 16,
    "string": 17,
    "wstring": 18,
}
BOUNDED_STRINGS = {"string": 21, "wstring": 22}
SHAPE_OFFSETS = {"": 0, "array": 48, "bounded": 96, "unbounded": 144}

FindSpec = Callable[[str], spec.Message]
"""Returns the spec of a message by its name; raises LookupError for an unknown one."""


def type_hash(interface: spec.Interface, find: FindSpec) -> str:
    """Return `RIHS01_` and 64 hex digits.

    Args:
        interface: The message, service or action.
        find: Returns the message of a name, for references.

    Raises:
        LookupError: a message that it refers to is unknown.
    """
    return description_hash(type_description(interface, find))


def description_hash(description: dict[str, Any]) -> str:
    """Return the hash of what `type_description` returns."""
    text = json.dumps(description, separators=(", ", ": "))
    return f"RIHS01_{hashlib.sha256(text.encode()).hexdigest()}"


def type_description(interface: spec.Interface, find: FindSpec) -> dict[str, Any]:
    """Return the type's description and those of all messages in it, sorted by name, as the hash requires."""
    descriptions = dict(_descriptions(interface))
    waiting = list(descriptions.values())
    while waiting:
        for field in waiting.pop()["fields"]:
            name = field["type"]["nested_type_name"]
            if name and name not in descriptions:
                descriptions[name] = describe(name, find(name).wire_fields)
                waiting.append(descriptions[name])
    own = descriptions.pop(interface.name)
    return {
        "type_description": own,
        "referenced_type_descriptions": [descriptions[name] for name in sorted(descriptions)],
    }


def _descriptions(interface: spec.Interface) -> Iterable[tuple[str, dict[str, Any]]]:
    """Yield the interface's own description and those of its parts, with their names."""
    if isinstance(interface, spec.Message):
        yield interface.name, describe(interface.name, interface.wire_fields)
        return
    yield interface.name, describe(interface.name, _part_fields(interface))
    for message in interface.messages:
        yield from _descriptions(message)
    if isinstance(interface, spec.Action):
        yield from _descriptions(interface.send_goal)
        yield from _descriptions(interface.get_result)


def _part_fields(interface: spec.Service | spec.Action) -> list[spec.Field]:
    if isinstance(interface, spec.Service):
        parts: dict[str, spec.Interface] = {
            "request_message": interface.request,
            "response_message": interface.response,
            "event_message": interface.event,
        }
    else:
        parts = {
            "goal": interface.goal,
            "result": interface.result,
            "feedback": interface.feedback,
            "send_goal_service": interface.send_goal,
            "get_result_service": interface.get_result,
            "feedback_message": interface.feedback_message,
        }
    return [spec.Field(name, spec.Type(part.name)) for name, part in parts.items()]


def describe(name: str, fields: Iterable[spec.Field]) -> dict[str, Any]:
    """Return the description of one type by its name and its fields on the wire."""
    return {
        "type_name": name,
        "fields": [{"name": field.name, "type": _describe_type(field.type)} for field in fields],
    }


def _describe_type(type_: spec.Type) -> dict[str, Any]:
    ids = BOUNDED_STRINGS if type_.string_bound else TYPE_IDS
    return {
        "type_id": ids.get(type_.base, NESTED) + SHAPE_OFFSETS[type_.shape],
        "capacity": type_.length,
        "string_capacity": type_.string_bound,
        "nested_type_name": "" if type_.is_primitive else type_.base,
    }
