"""The stamps of a topic's messages, without decoding them."""

from __future__ import annotations

import struct
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from tfloom.bag.errors import BagError
from tfloom.bag.message_classes import class_of
from tfloom.bag.values import RawMessage, Topic

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["has_header", "header_stamp", "stamps_of"]

FIRST = {"std_msgs/msg/Header", "builtin_interfaces/msg/Time"}
"""Types of a first field that begin with a stamp."""
_LAYOUTS = {0: struct.Struct(">iI"), 1: struct.Struct("<iI")}
"""Of seconds and nanoseconds, by the second byte of the encapsulation header."""


def has_header(path: Path, topic: Topic) -> bool:
    """Return whether the messages of a topic begin with a stamp.

    Raises:
        BagError: the type has no definition, here or in the recording.
    """
    fields = class_of(path, topic)._FIELDS
    return next(iter(fields.values()), "") in FIRST


def header_stamp(path: Path, raw: RawMessage) -> int:
    """Return the stamp with which a message begins [ns since epoch].

    Raises:
        BagError: the message is too short.
    """
    layout = _LAYOUTS.get(raw.data[1]) if len(raw.data) >= 12 else None
    if layout is None:
        raise BagError(
            path, f"a message on {raw.topic} of {raw.log_time_ns} ns does not begin with a stamp in CDR"
        )
    sec, nanosec = layout.unpack_from(raw.data, 4)
    return int(sec) * 1_000_000_000 + int(nanosec)


def stamps_of(path: Path, topic: Topic, messages: Iterable[RawMessage], of: str | None) -> NDArray[np.int64]:
    """Return the stamps of messages (N,), in the order of log times; `Bag.stamps` describes the arguments.

    Raises:
        BagError, ValueError: as `Bag.stamps`.
    """
    import numpy as np

    if of not in {None, "header", "log", "publish"}:
        raise ValueError(f"of must be header, log or publish, not {of!r}")
    is_cdr = topic.serialization_format == "cdr"
    if of == "header" and not (is_cdr and has_header(path, topic)):
        raise BagError(path, f"messages of {topic.name}, of type {topic.type}, have no header")
    if of == "header" or (of is None and is_cdr and has_header(path, topic)):
        stamps = [header_stamp(path, raw) for raw in messages]
    else:
        stamps = [raw.publish_time_ns if of == "publish" else raw.log_time_ns for raw in messages]
    return np.array(stamps, np.int64)
