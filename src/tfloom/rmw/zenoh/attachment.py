"""What goes along with each sample, request and response on the Zenoh wire: number, time and gid, in 33 bytes."""

from __future__ import annotations

import struct
import time
from typing import Any, NamedTuple

__all__ = ["Attachment", "pack", "unpack"]

GID_SIZE = 16
_FORM = struct.Struct(f"<qqB{GID_SIZE}s")


class Attachment(NamedTuple):
    """The number and time of a sample and its writer; of a response, the number and client of its request."""

    sequence_number: int
    """From 1."""
    source_stamp_ns: int
    """By the writer's clock [ns since epoch]."""
    gid: bytes
    """16 bytes."""


def pack(sequence_number: int, gid: bytes) -> bytes:
    """Return the bytes of an attachment, with the time of now."""
    return _FORM.pack(sequence_number, time.time_ns(), GID_SIZE, gid)


def unpack(attachment: Any) -> Attachment | None:
    """Return what a `zenoh.ZBytes` from the wire holds, or None. Bytes that follow are ignored."""
    if attachment is None:
        return None
    data = attachment.to_bytes()
    if len(data) < _FORM.size:
        return None
    sequence_number, stamp_ns, size, gid = _FORM.unpack_from(data)
    return Attachment(sequence_number, stamp_ns, gid) if size == GID_SIZE else None
