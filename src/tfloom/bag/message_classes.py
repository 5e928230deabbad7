"""The classes of a recording's messages: tfloom's, or made from the recording's own definitions."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from tfloom.bag.errors import BagError
from tfloom.bag.values import Definition, RawMessage, Topic

__all__ = ["class_of", "decoder"]


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
