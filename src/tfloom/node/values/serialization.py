"""Messages to bytes and back."""

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
        NoTypeSupportImportedException: it is no message.
        EncodeError: a field holds what its type has no place for.
    """
    check_is_valid_msg_type(type(message))
    return cdr.encode(message)


def deserialize_message(serialized_message: bytes, message_type: type[M]) -> M:
    """Return the message that bytes hold: encapsulation header and CDR.

    Raises:
        NoTypeSupportImportedException: `message_type` is no message class.
        DecodeError: the bytes are no such message.
    """
    check_is_valid_msg_type(message_type)
    return cdr.decode(message_type, serialized_message)
