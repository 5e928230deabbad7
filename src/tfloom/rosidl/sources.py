"""Sources of definitions: the program's own, sourced workspaces, and tfloom."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from tfloom.rosidl import definition_files, spec
from tfloom.rosidl.parse import parse_interface, read_text


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
    """Return the definition of `package/kind/Name`, or None.

    Raises:
        ParseError: its file is not UTF-8 text.
    """
    if name in _defined:
        return _defined[name]
    path = definition_files.find_path(name)
    return None if path is None else read_source(path)


def read_source(path: Path) -> Source:
    """Return the definition in a file.

    Raises:
        ParseError: it is not UTF-8 text.
        OSError: it can't be read.
    """
    return Source(read_text(path), str(path))


def is_package(package: str) -> bool:
    """Return whether there is a definition of any kind in a package."""
    return any(name.startswith(f"{package}/") for name in _defined) or any(
        definition_files.names_in(share / package) for share in definition_files.share_folders()
    )


def find_interface(name: str) -> spec.Interface:
    """Return the spec of `package/kind/Name`.

    Raises:
        LookupError: there is no such definition.
        ParseError: it can't be parsed.
    """
    source = find_source(name)
    if source is None:
        raise LookupError(f"there is no definition of '{name}'")
    return parse_source(source, name)


@lru_cache(maxsize=256)
def parse_source(source: Source, name: str) -> spec.Interface:
    """Return the spec of `package/kind/Name` that a text defines: IDL if its path ends in `.idl`.

    The latest are kept, because each part of a definition has a hash, of all messages that it refers to.

    Raises:
        ParseError: it can't be parsed.
        ValueError: `name` is not an interface name.
    """
    if source.path.endswith(definition_files.IDL_SUFFIX):
        from tfloom.rosidl.idl_spec import parse_idl

        return parse_idl(source.text, name, source.path)
    return parse_interface(source.text, name, source.path)


def find_message(name: str) -> spec.Message:
    """Return the spec of a message, or of a message that is part of a service or an action.

    Raises:
        LookupError: there is no such message.
        ParseError: its definition can't be parsed.
    """
    return message_of(find_interface(definition_name(name)), name)


def message_of(interface: spec.Interface, name: str) -> spec.Message:
    """Return the message of a name among those that an interface consists of.

    Raises:
        LookupError: it has no such message.
    """
    for message in spec.messages_of(interface):
        if message.name == name:
            return message
    raise LookupError(f"there is no definition of '{name}'")
