"""Serialization of messages to bytes and back."""

from __future__ import annotations

from typing import TypeVar

from tfloom.common.text import given_text
from tfloom.node.values.type_support import msg_type_error
from tfloom.rosidl import cdr
from tfloom.rosidl.message import Message

__all__ = ["deserialize_message", "serialize_message"]

M = TypeVar("M", bound=Message)


def serialize_message(message: Message) -> bytes:
    """Return encapsulation header and CDR of a message.

    Raises:
        AttributeError: `message` is not a message.
        EncodeError: a field's value doesn't fit its type; the text names the field.
    """
    if not isinstance(message, Message):
        given = given_text(message)
        meant = f": write {message.__name__}(…)" if isinstance(message, type) else ""
        needs = "a message, as String(data='hello')"
        raise AttributeError(f"serialize_message() needs {needs}, got {given}{meant}")  # ROS's kind
    return cdr.encode(message)


def deserialize_message(serialized_message: bytes, message_type: type[M]) -> M:
    """Return the message in bytes: encapsulation header and CDR.

    Raises:
        AttributeError: `message_type` is not a ROS type.
        RuntimeError: `message_type` is a service or an action.
        TypeError: `serialized_message` is not an object with bytes.
        DecodeError: the bytes are not a message of that type.
    """
    if (error := msg_type_error(message_type)) is not None:
        raise error
    try:
        memoryview(serialized_message)
    except TypeError:
        given = given_text(serialized_message)
        raise TypeError(
            f"deserialize_message() needs bytes, as serialize_message() returns them, got {given}"
        ) from None
    return cdr.decode(message_type, serialized_message)
