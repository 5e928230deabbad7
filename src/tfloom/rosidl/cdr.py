"""Messages to bytes and back: plain CDR version 1 behind a 4-octet encapsulation header."""

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
    """Return encapsulation header and CDR, little-endian, as long as the message is: not padded.

    Raises:
        EncodeError: a field holds what its type has no place for, with the field's path.
        TypeError: `message` is no message.
    """
    return _native.encode(message)


def decode(message_class: type[M], data: Buffer) -> M:
    """Build a message from encapsulation header and CDR of either byte order. Padding at the end is passed over.

    Args:
        message_class: What to build.
        data: bytes, or anything that gives its memory.

    Raises:
        DecodeError: the bytes are no such message, with the field's path and the byte's offset.
        TypeError: `message_class` is no message class.
    """
    message: M = _native.decode(message_class, data)
    return message
