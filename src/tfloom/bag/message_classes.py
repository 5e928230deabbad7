"""The classes of a recording's messages: tfloom's, or made from the recording's own definitions."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from tfloom.bag.errors import BagError
from tfloom.bag.values import Definition, RawMessage, Topic
from tfloom.rosidl.other_forms import FORMS, Form

__all__ = ["class_of", "decoder", "other_form"]


def class_of(path: Path, topic: Topic) -> Any:
    """Return the message class of a topic: tfloom's, or one made from the recording's own definition.

    Args:
        path: The recording, for errors.
        topic: The topic.

    Raises:
        BagError: its type has no definition, here or in the recording, or that is invalid.
    """
    from tfloom.rosidl.described import DescriptionError
    from tfloom.rosidl.recorded import recorded_class

    definition = topic.definition or Definition("", "")
    try:
        return recorded_class(topic.type, definition.encoding, definition.text, topic.type_hash)
    except DescriptionError as error:
        raise BagError(path, f"messages of {topic.name} can't be decoded: {error}") from None


def other_form(path: Path, topic: Topic) -> Form | None:
    """Return the form of a topic's definition where the class of its type has another one here, else None.

    None also of a topic that can't be decoded: `class_of` raises an error of it.

    Args:
        path: The recording.
        topic: The topic.
    """
    forms = FORMS.get(topic.type)
    if forms is None or topic.serialization_format != "cdr":
        return None
    from tfloom.rosidl.registry import get_message_class

    try:
        recorded, here = class_of(path, topic)._FIELDS, get_message_class(topic.type)._FIELDS
    except BagError:
        return None
    return next((form for form in forms if form.field in recorded and form.field not in here), None)


def decoder(path: Path, topic: Topic) -> Callable[[RawMessage], Any]:
    """Return the function that decodes the messages of a topic.

    Args:
        path: The recording, for errors.
        topic: The topic.

    Raises:
        BagError: the topic's bytes aren't CDR, or as `class_of`.
    """
    from tfloom.rosidl.cdr import decode
    from tfloom.rosidl.message import DecodeError

    if topic.serialization_format != "cdr":
        raise BagError(
            path, f"{topic.name} is serialized as '{topic.serialization_format}', and only cdr is decoded"
        )
    message_class = class_of(path, topic)

    def decode_one(raw: RawMessage) -> Any:
        try:
            return decode(message_class, raw.data)
        except DecodeError as error:
            raise BagError(
                path, f"a message on {topic.name} of {raw.log_time_ns} ns isn't a {topic.type}: {error}"
            ) from None

    return decode_one
