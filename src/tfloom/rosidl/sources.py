"""Sources of definitions: the program's own, sourced workspaces, and tfloom."""

from __future__ import annotations

from typing import NamedTuple

from tfloom.rosidl import spec
from tfloom.rosidl.definition_files import find_path
from tfloom.rosidl.parse import parse_interface


class Source(NamedTuple):
    """The text of a definition, and its path."""

    text: str
    path: str


_defined: dict[str, Source] = {}


def replace(name: str, source: Source | None) -> Source | None:
    """Set or remove the program's definition of `package/kind/Name`, which has precedence; return the previous one."""
    before = _defined.pop(name, None)
    if source is not None:
        _defined[name] = source
    return before


def definition_name(name: str) -> str:
    """Return the definition that a type is part of: `turtlesim/srv/Spawn` for `turtlesim/srv/Spawn_Request`."""
    head, slash, base = name.rpartition("/")
    return f"{head}{slash}{base.partition('_')[0]}"


def find_source(name: str) -> Source | None:
    """Return the definition of `package/kind/Name`, or None."""
    if name in _defined:
        return _defined[name]
    path = find_path(name)
    return None if path is None else Source(path.read_text(encoding="utf-8"), str(path))


def find_interface(name: str) -> spec.Interface:
    """Return the spec of `package/kind/Name`.

    Raises:
        LookupError: there is no such definition.
        ParseError: it can't be parsed.
    """
    source = find_source(name)
    if source is None:
        raise LookupError(f"there is no definition of '{name}'")
    return parse_interface(source.text, name, source.path)


def find_message(name: str) -> spec.Message:
    """Return the spec of a message, or of a message that is part of a service or an action.

    Raises:
        LookupError: there is no such message.
        ParseError: its definition can't be parsed.
    """
    interface = find_interface(definition_name(name))
    for message in spec.messages_of(interface):
        if message.name == name:
            return message
    raise LookupError(f"there is no definition of '{name}'")
