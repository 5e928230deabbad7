"""The text of a message's definition and of all that it refers to, as a bag holds it."""

from __future__ import annotations

from tfloom.bag.values import Definition
from tfloom.rosidl import spec
from tfloom.rosidl.other_forms import forms_beside, source_of
from tfloom.rosidl.parse import ParseError
from tfloom.rosidl.sources import definition_name, find_message, find_source, message_of, parse_source
from tfloom.rosidl.type_hash import type_hash

__all__ = ["find_definition", "find_service_definition", "hash_of", "short_name"]

_SEPARATOR = "=" * 80


def short_name(type_name: str) -> str:
    """Return how definitions refer to a type: `package/Name` to `package/msg/Name`, and by its name to any other.

    The parts of services and actions are such others: readers take `package/Name` for a message.
    """
    return type_name.replace("/msg/", "/", 1)


def find_definition(type_name: str, type_hash: str = "") -> Definition | None:
    """Return the definition of a type that is known here, with those of all messages that it refers to, else None.

    Args:
        type_name: `package/msg/Name`, or a part of a service or an action: `package/srv/Name_Event`.
        type_hash: Its hash, where the form of another distribution may be meant; empty: that of here.
    """
    try:
        own, root = _other_form(type_name, type_hash) or (None, find_message(type_name))
        text = "".join([own or _text(root), *_dependencies(root, {type_name})])
    except (LookupError, ParseError, OSError, ValueError):
        return None
    return Definition("ros2msg", text)


def _other_form(type_name: str, type_hash: str) -> tuple[str, spec.Message] | None:
    """Return the text and the definition of the form that other distributions have, if the hash is its; else None."""
    if forms_beside(type_name, type_hash) is None or type_hash == hash_of(type_name):
        return None
    source = source_of(type_name, type_hash)
    return source.text, message_of(parse_source(source, type_name), type_name)


def find_service_definition(type_name: str) -> Definition | None:
    """Return the definition of a service, with those of all messages that its parts refer to; None if it is unknown."""
    try:
        source = find_source(type_name)
        if source is None or not source.path.endswith(".srv"):
            return None
        sections, listed_names = [source.text], {type_name}
        for part in ("Request", "Response"):
            sections += _dependencies(find_message(f"{type_name}_{part}"), listed_names)
    except (LookupError, ParseError, OSError, ValueError):
        return None
    return Definition("ros2msg", "".join(sections))


def hash_of(type_name: str) -> str:
    """Return the hash of a type that is known here, else an empty string."""
    try:
        return type_hash(find_message(type_name), find_message)
    except (LookupError, ParseError, OSError, ValueError):
        return ""


def _dependencies(message: spec.Message, listed_names: set[str]) -> list[str]:
    """Return the sections of all messages that one refers to: in order of names, each before what it refers to."""
    sections = []
    for name in sorted(message.references):
        if name in listed_names:
            continue
        listed_names.add(name)
        dependency = find_message(name)
        sections.append(f"\n{_SEPARATOR}\nMSG: {short_name(name)}\n{_text(dependency)}")
        sections += _dependencies(dependency, listed_names)
    return sections


def _text(message: spec.Message) -> str:
    """Return the definition's own text if it has one in the .msg format, else one made from its fields."""
    if "/msg/" in message.name:
        source = find_source(definition_name(message.name))
        if source is not None and source.path.endswith(".msg"):
            return source.text
    return "".join(f"{line}\n" for line in (*_constants(message), *_fields(message)))


def _constants(message: spec.Message) -> list[str]:
    return [
        f"{_type(constant.type)} {constant.name}={_value(constant.value)}" for constant in message.constants
    ]


def _fields(message: spec.Message) -> list[str]:
    lines = []
    for field in message.fields:
        default = "" if field.default is None else f" {_value(field.default)}"
        lines.append(f"{_type(field.type)} {field.name}{default}")
    return lines


def _type(kind: spec.Type) -> str:
    return str(kind if kind.is_primitive else kind._replace(base=short_name(kind.base)))


def _value(value: spec.Value) -> str:
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(_value(element) for element in value)}]"
    if isinstance(value, bool):
        return str(value).lower()
    return repr(value) if isinstance(value, str) else str(value)
