"""The classes of a recording's messages: tfloom's, or made from the recording's own definitions."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from tfloom.bag.errors import BagError
from tfloom.bag.values import RawMessage, Topic

__all__ = ["decoder"]


def decoder(path: Path, topic: Topic) -> Callable[[RawMessage], Any]:
    """Return the function that decodes the messages of a topic.

    Raises:
        BagError: the topic's bytes aren't CDR, or its type has no definition, here or in the recording.
    """
    from tfloom.rosidl.cdr import decode
    from tfloom.rosidl.message import DecodeError

    if topic.serialization_format != "cdr":
        raise BagError(
            path, f"{topic.name} is serialized as '{topic.serialization_format}', and only cdr is decoded"
        )
    message_class = _class(path, topic)

    def decode_one(raw: RawMessage) -> Any:
        try:
            return decode(message_class, raw.data)
        except DecodeError as error:
            raise BagError(
                path, f"a message on {topic.name} of {raw.log_time_ns} ns isn't a {topic.type}: {error}"
            ) from None

    return decode_one


def _class(path: Path, topic: Topic) -> Any:
    from tfloom.rosidl.registry import get_message_class

    try:
        return get_message_class(topic.type)
    except LookupError as error:
        raise BagError(path, f"the type of {topic.name} has no definition: {error}") from None
