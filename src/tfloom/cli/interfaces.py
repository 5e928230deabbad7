"""Message classes and values from what a user typed."""

from __future__ import annotations

from typing import Any

from tfloom.cli.errors import CommandError
from tfloom.rosidl.fill import StampSetter, set_message_fields
from tfloom.rosidl.message import Message
from tfloom.rosidl.registry import get_message_class


def message_class(name: str) -> type[Message]:
    """Return the class of a message type's name.

    Raises:
        CommandError: there is none; it names the nearest.
    """
    try:
        return get_message_class(name)
    except LookupError as error:
        raise CommandError(f"The passed message type is invalid\n{error}") from None


def parse_yaml(text: str) -> dict[str, Any]:
    """Return the fields that a YAML text gives.

    Raises:
        CommandError: it isn't YAML, or not a mapping of fields; a mistake is shown at its place.
    """
    import yaml

    try:
        values = yaml.safe_load(text)
    except yaml.MarkedYAMLError as error:
        raise CommandError(_yaml_mistake(error)) from None
    except yaml.YAMLError as error:
        raise CommandError(f"The passed value isn't YAML: {error}") from None
    if values is None:
        return {}
    if not isinstance(values, dict):
        raise CommandError(f"The passed value needs to be a dictionary in YAML format, not {values!r}")
    return values


def _yaml_mistake(error: Any) -> str:
    mark = error.problem_mark or error.context_mark
    if mark is None:
        return f"The passed value isn't YAML: {error.problem}"
    place = f"line {mark.line + 1}, column {mark.column + 1}"
    return f"The passed value isn't YAML: {error.problem} at {place}:\n{mark.get_snippet(indent=2, max_length=100)}"


def fill_message(message: Message, values: dict[str, Any]) -> list[StampSetter]:
    """Set a message's fields; a header may be the word `auto`, a time the word `now`.

    Returns:
        A function for each such word, to be called with the time of publishing.

    Raises:
        CommandError: a field doesn't exist, and which do, or a value doesn't fit.
    """
    try:
        return set_message_fields(message, values, expand_header_auto=True, expand_time_now=True)
    except (AttributeError, TypeError, ValueError, AssertionError, OverflowError) as error:
        raise CommandError(f"Failed to populate field: {error}{_fields_there_are(error)}") from None


def _fields_there_are(error: Exception) -> str:
    holder = getattr(error, "obj", None)
    if not isinstance(error, AttributeError) or not isinstance(holder, Message):
        return ""
    return f"\n{type(holder).__name__} has: {', '.join(type(holder).get_fields_and_field_types()) or 'no fields'}"
