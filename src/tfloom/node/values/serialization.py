"""Serialization of messages to bytes and back."""

from __future__ import annotations

from typing import TypeVar

from tfloom.node.values.type_support import check_is_valid_msg_type
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
    check_is_valid_msg_type(type(message))
    return cdr.encode(message)


def deserialize_message(serialized_message: bytes, message_type: type[M]) -> M:
    """Return the message in bytes: encapsulation header and CDR.

    Raises:
        AttributeError: `message_type` is not a ROS type.
        RuntimeError: `message_type` is a service or an action.
        DecodeError: the bytes are not a message of that type.
    """
    check_is_valid_msg_type(message_type)
    return cdr.decode(message_type, serialized_message)
