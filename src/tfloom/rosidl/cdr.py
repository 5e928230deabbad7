"""Encoding and decoding of messages: plain CDR version 1 after a 4-byte encapsulation header."""

from __future__ import annotations

from tfloom import _native
from tfloom.rosidl.message import DecodeError, EncodeError, Message

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeVar

    from typing_extensions import Buffer

    M = TypeVar("M", bound=Message)

__all__ = ["DecodeError", "EncodeError", "decode", "encode"]


def encode(message: Message) -> bytes:
    """Return encapsulation header and CDR of a message, little-endian, without padding at the end.

    Raises:
        EncodeError: a field's value does not fit its type; the text has the field's path.
        TypeError: `message` is not a message.
    """
    return _native.encode(message)


def decode(message_class: type[M], data: Buffer) -> M:
    """Build a message from encapsulation header and CDR of either byte order. Padding at the end is ignored.

    Args:
        message_class: The class of the message.
        data: bytes, or any object with the buffer protocol.

    Raises:
        DecodeError: the bytes are not such a message; the text has the field's path and the byte's offset.
        TypeError: `message_class` is not a message class.
    """
    message: M = _native.decode(message_class, data)
    return message
