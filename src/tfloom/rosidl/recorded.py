"""Classes from the definitions that recordings and other files carry: a type's, followed by those of all types in it.

A definition that exists here is never replaced. A type that the file defines otherwise gets its own class, whose
package has a suffix made from the definition.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from tfloom.rosidl import spec
from tfloom.rosidl.class_factory import LOCK, load
from tfloom.rosidl.class_search import UnknownTypeError, find_class, find_known_class, full_name
from tfloom.rosidl.class_table import forget
from tfloom.rosidl.described import DescriptionError, check_size, definition_text, hash_of
from tfloom.rosidl.parse import ParseError
from tfloom.rosidl.sources import Source, definition_name, find_message, find_source, parse_source, replace

__all__ = ["recorded_class"]

_Types = dict[str, dict[str, spec.Type]]
"""The types of the fields of each message, by the names of both."""

KINDS = {"MSG": "msg", "SRV": "srv", "ACTION": "action", "IDL": "msg"}
SUFFIXES = {"ros2msg": "msg", "ros2idl": "idl"}
LINE = re.compile(r"^={10,}\n(MSG|SRV|ACTION|IDL): (\S+)[^\n]*\n", re.MULTILINE)
MAX_TEXT_SIZE = 10_000_000
"""Of all definitions of a type [characters]."""


def recorded_class(name: str, encoding: str, text: str, type_hash: str = "") -> Any:
    """Return the class of a message that a file defines.

    Args:
        name: `package/msg/Name`, or `package/Name`; also a part of a service or an action.
        encoding: `ros2msg` or `ros2idl`; anything else: the file has no definition.
        text: The definition, and those of the types in it, each after a line of `=` and one with its name.
        type_hash: The hash that the file states; empty if it states none.

    Raises:
        DescriptionError: there is no definition, here or in the file, or that of the file is invalid or too large.
    """
    name = full_name(name, "msg")
    ours = _find_local_class(name)
    if ours is not None and type_hash == ours._TYPE_HASH:
        return ours
    if encoding not in SUFFIXES:
        return _without_definition(name, ours, type_hash)
    if not text.strip() and not _may_be_empty(name, encoding, ours, type_hash):
        return _without_definition(name, ours, type_hash)
    try:
        texts = _split_definitions(name, encoding, text)
        types = _field_types(name, texts)
        check_size(name, types)
    except (ValueError, LookupError, RecursionError) as error:
        raise DescriptionError(f"the definition of {name} is invalid: {error}") from None
    if ours is not None and hash_of(name, types) == ours._TYPE_HASH:
        return ours
    with LOCK:
        return _make_class(name, texts, types)


def _may_be_empty(name: str, encoding: str, ours: Any, type_hash: str) -> bool:
    """Return whether an empty text is the definition of a type without fields, not one that the recorder lacked."""
    if encoding != "ros2msg":
        return False
    return type_hash == hash_of(name, {name: {}}) if type_hash else ours is None


def _find_local_class(name: str) -> Any:
    """Return the class of a message that exists here, or None."""
    try:
        return find_known_class(name)
    except (UnknownTypeError, ParseError):
        return None


def _without_definition(name: str, ours: Any, type_hash: str) -> Any:
    if ours is None:
        raise DescriptionError(
            f"{name} has no definition, here or in the file: source the workspace that has its package"
        )
    if type_hash:
        raise DescriptionError(
            f"{name} has another definition here than the file says, {type_hash}, and the file does not have it"
        )
    return ours


def _split_definitions(name: str, encoding: str, text: str) -> dict[str, Source]:
    """Return the definitions by their names, that of the type itself first.

    Raises:
        ParseError: one is not a definition.
    """
    if len(text) > MAX_TEXT_SIZE:
        raise DescriptionError(f"it is longer than {MAX_TEXT_SIZE} characters")
    pieces = LINE.split(text.replace("\r\n", "\n"))
    definitions = {definition_name(name): pieces[0]} if pieces[0].strip() or len(pieces) == 1 else {}
    for kind, type_name, piece in zip(pieces[1::3], pieces[2::3], pieces[3::3], strict=True):
        definitions.setdefault(full_name(type_name, KINDS[kind]), piece)
    suffix = SUFFIXES[encoding]
    return {
        type_name: Source(piece, f"{type_name} (recorded).{suffix}")
        for type_name, piece in definitions.items()
    }


def _field_types(name: str, texts: Mapping[str, Source]) -> _Types:
    """Return the types of the fields of a message, and of all messages in it.

    Raises:
        ParseError: a definition is none.
        LookupError: one is missing.
    """
    types: _Types = {}
    waiting = [name]
    while waiting:
        type_name = waiting.pop()
        if type_name in types:
            continue
        source = texts.get(definition_name(type_name))
        message = find_message(type_name) if source is None else _message(source, type_name)
        types[type_name] = {field.name: field.type for field in message.wire_fields}
        waiting += message.references
    return types


def _message(source: Source, name: str) -> spec.Message:
    for message in spec.messages_of(parse_source(source, definition_name(name))):
        if message.name == name:
            return message
    raise LookupError(f"there is no definition of '{name}'")


def _make_class(name: str, texts: Mapping[str, Source], types: _Types) -> Any:
    """Return the class of a message that doesn't exist here as the file defines it.

    Raises:
        DescriptionError: it can't be made.
    """
    # Messages that are here with another definition keep their names here; those of the file get new ones, and so do
    # the messages that contain them. What isn't here is registered under its own name.
    renamed = _new_names(name, types)
    sources = {
        definition_name(type_name): texts[definition_name(type_name)]
        for type_name in types
        if type_name not in renamed and find_source(definition_name(type_name)) is None
    }
    table = {
        renamed.get(type_name, type_name): {
            field: _with_name(type_, renamed) for field, type_ in fields.items()
        }
        for type_name, fields in types.items()
    }
    for new in renamed.values():
        sources[new] = Source(definition_text(new, table), f"{new} (recorded).msg")
    # Register all sources before any is loaded, because they refer to one another. After a failure none must stay.
    before = {type_name: replace(type_name, source) for type_name, source in sources.items()}
    try:
        wanted = renamed.get(name, name)
        if (made := _find_local_class(wanted)) is None:
            load(definition_name(wanted))
            made = find_class(wanted)
    except (ValueError, LookupError) as error:
        for type_name, source in before.items():
            replace(type_name, source)
            forget(type_name)
        raise DescriptionError(f"{name} can't be made from its definition: {error}") from None
    return made


def _with_name(type_: spec.Type, renamed: Mapping[str, str]) -> spec.Type:
    return type_._replace(base=renamed.get(type_.base, type_.base))


def _new_names(name: str, types: _Types) -> dict[str, str]:
    """Return new names for the messages that are otherwise here, and for those that have such a message in them.

    Raises:
        DescriptionError: one is a part of a service or an action.
    """
    other_names = {type_name for type_name in types if _differs_from_local(type_name, types)}
    # A message that contains one with another name has another definition itself: go on until no such message is left.
    while more := {
        type_name
        for type_name in types.keys() - other_names
        if other_names & set(_nested_type_names(types[type_name]))
    }:
        other_names |= more
    suffix = hash_of(name, types).rpartition("_")[2][:8]
    for type_name in other_names:
        if type_name.split("/")[1] != "msg":
            raise DescriptionError(f"{type_name} has another definition here than in the file")
    return {type_name: type_name.replace("/", f"_recorded_{suffix}/", 1) for type_name in other_names}


def _differs_from_local(name: str, types: _Types) -> bool:
    ours = _find_local_class(name)
    return ours is not None and hash_of(name, types) != ours._TYPE_HASH


def _nested_type_names(fields: Mapping[str, spec.Type]) -> Iterable[str]:
    return [type_.base for type_ in fields.values() if not type_.is_primitive]
