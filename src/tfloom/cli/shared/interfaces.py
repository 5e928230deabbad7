"""Message classes and values from command-line arguments."""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import chain
from typing import TYPE_CHECKING, Any, TypeVar

from tfloom.cli.shared.errors import CommandError
from tfloom.common.text import PlainValue
from tfloom.rosidl import cdr, registry
from tfloom.rosidl.fill import Filler, StampSetter
from tfloom.rosidl.message import Message
from tfloom.rosidl.parse import ParseError, parse_type
from tfloom.rosidl.spec import STRINGS, Type

if TYPE_CHECKING:
    from tfloom.rmw.base import Participant

T = TypeVar("T")


def message_class(
    name: str, participant: Participant | None = None, *, search_graph: bool = False
) -> type[Message]:
    """Return the class of a message type's name.

    Args:
        name: `package/msg/Name`, or `package/Name` for short.
        participant: Where a type without a definition here is searched for: among the nodes that it has discovered.
        search_graph: Whether to join the domain for this search, where there is no participant yet.

    Raises:
        CommandError: there is none, or its definition can't be parsed; the text has the nearest names, those on the
            searched graph first, and why a node's description of the type can't be used.
    """
    return _class(registry.get_message_class, name, "msg", participant, search_graph=search_graph)


def service_class(
    name: str, participant: Participant | None = None, *, search_graph: bool = False
) -> type[Any]:
    """Return the class of a service type's name; arguments and errors as of `message_class`."""
    return _class(registry.get_service_class, name, "srv", participant, search_graph=search_graph)


def action_class(
    name: str, participant: Participant | None = None, *, search_graph: bool = False
) -> type[Any]:
    """Return the class of an action type's name; arguments and errors as of `message_class`."""
    return _class(registry.get_action_class, name, "action", participant, search_graph=search_graph)


def _class(
    find: Callable[[str], type[T]],
    name: str,
    kind: str,
    participant: Participant | None,
    *,
    search_graph: bool,
) -> type[T]:
    what = {"msg": "message", "srv": "service"}.get(kind, kind)
    invalid = f"The passed {what} type is invalid"
    live: set[str] = set()
    reasons: list[str] = []
    try:
        return find(name)
    except registry.UnknownTypeError:
        if search_graph or participant:
            live, reasons = _search_graph(participant, name, kind)
    except (LookupError, ParseError) as error:
        raise CommandError(f"{invalid}\n{error}") from None
    try:
        return find(name)
    except registry.UnknownTypeError:
        from tfloom.cli.shared.type_names import did_you_mean_type

        unknown = f"there is no {what} type '{name}'{did_you_mean_type(name, kind, live - {name})}"
        raise CommandError("\n".join([invalid, unknown, *reasons])) from None


def _search_graph(participant: Participant | None, name: str, kind: str) -> tuple[set[str], list[str]]:
    """Make the classes of a type from a node's description.

    Returns:
        The types on the graph, and why the descriptions can't be used; both empty where there is no wire.
    """
    from tfloom.cli.shared import peer_types
    from tfloom.rmw.errors import WireError

    full = registry.full_name(name, kind)
    try:
        with peer_types.searched_participant(participant) as searched:
            return peer_types.types_on_graph(searched.graph, kind), peer_types.learn(searched, full, kind)
    except WireError:
        return set(), []


def yaml_documents(lines: Iterable[str]) -> Iterator[str]:
    """Yield the YAML documents of an input; a line `---` ends one."""
    document: list[str] = []
    for line in chain(lines, ["---"]):
        if line.rstrip() != "---":
            document.append(line)
        elif "".join(document).strip():
            yield "".join(document)
            document = []


def parse_yaml(text: str) -> dict[str, Any]:
    """Return the fields in a YAML text, for `fill_message`: each value that is not a text with how it is written.

    Raises:
        CommandError: it isn't YAML, or not a mapping of fields; the text has the position of the mistake.
    """
    from tfloom.common import yaml as user_yaml

    try:
        values = user_yaml.load_plain(text)
    except user_yaml.YamlLimitError as error:
        raise CommandError(f"The passed value can't be used: {error}:\n{error.snippet}") from None
    except user_yaml.YamlError as error:
        where = f"{error.place}:\n{error.snippet}" if error.place else ""
        raise CommandError(f"The passed value isn't YAML: {error.problem}{where}") from None
    if isinstance(values, PlainValue):
        values = values.value
    if values is None:
        return {}
    if not isinstance(values, dict):
        raise CommandError(
            f"The passed value needs to be a dictionary in YAML format, not {values!r}{_missing_space(values)}"
        )
    return values


def fill_message(message: Message, values: dict[str, Any]) -> list[StampSetter]:
    """Set a message's fields; a header may be the word `auto`, a time the word `now`.

    Args:
        message: The message.
        values: Its fields. Of a PlainValue, a text has what is written, as do names of fields: `off`.

    Returns:
        A function for each such word, to be called with the time of publishing.

    Raises:
        CommandError: a field doesn't exist, or a value doesn't fit; the text has the existing fields, or the field.
    """
    filler = Filler(auto=True, now=True)
    try:
        filler.fill(message, _values_of_fields(values, message._FIELDS))
        set_stamps(filler.setters, time.time_ns())
        cdr.encode(message)
    except (AttributeError, TypeError, ValueError, AssertionError, OverflowError) as error:
        where = _fields_there_are(error) or _in_field(filler)
        raise CommandError(f"Failed to populate field: {error}{where}{_tight_colon(error)}") from None
    return filler.setters


def _values_of_fields(values: dict[Any, Any], fields: Mapping[str, str]) -> dict[Any, Any]:
    names = {key: key.text if isinstance(key, PlainValue) else key for key in values}
    types = {key: parse_type(fields[name]) if name in fields else None for key, name in names.items()}
    return {names[key]: _value_of_field(value, types[key]) for key, value in values.items()}


def _value_of_field(value: Any, type_: Type | None) -> Any:
    """Return a value with what its PlainValues are in a field of this type; None: there is no such field."""
    if isinstance(value, PlainValue):
        is_text = type_ is not None and type_.base in STRINGS and not type_.shape
        return value.text if is_text else value.value
    if isinstance(value, list):
        element = type_.element if type_ is not None and type_.shape else None
        return [_value_of_field(item, element) for item in value]
    if isinstance(value, dict):
        is_message = type_ is not None and not type_.is_primitive and not type_.shape
        fields = registry.get_message_class(type_.base)._FIELDS if is_message and type_ is not None else {}
        return _values_of_fields(value, fields)
    return value


def set_stamps(setters: list[StampSetter], now_ns: int) -> None:
    """Call the setters that `fill_message` returned with a time [ns]."""
    if setters:
        from tfloom.interfaces.builtin_interfaces.msg import Time

        sec, nanosec = divmod(now_ns, 1_000_000_000)
        for set_stamp in setters:
            set_stamp(Time(sec=sec, nanosec=nanosec))


def _in_field(filler: Filler) -> str:
    path = "".join(filler.path).lstrip(".")
    return f"\nin the field {path}" if path else ""


def _tight_colon(error: Exception) -> str:
    """Return a line on the space that YAML wants after a colon, if a text with one is not a field, or not fields."""
    if isinstance(error, AttributeError):
        return _missing_space(error.name)
    in_place_of_fields = re.match(r"Value '(.*)' is expected to be a dictionary but is a str", str(error))
    return _missing_space(in_place_of_fields[1]) if in_place_of_fields else ""


def _missing_space(text: Any) -> str:
    match = re.match(r"\s*(\w+):(\S+)", text) if isinstance(text, str) else None
    return f"\na space is missing after the colon: {match[1]}: {match[2]}" if match else ""


def _fields_there_are(error: Exception) -> str:
    holder = getattr(error, "obj", None)
    if not isinstance(error, AttributeError) or not isinstance(holder, Message):
        return ""
    return f"\n{type(holder).__name__} has: {', '.join(type(holder).get_fields_and_field_types()) or 'no fields'}"
