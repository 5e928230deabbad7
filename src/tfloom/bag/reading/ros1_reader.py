"""Messages and transforms of a bag of ROS 1."""

from __future__ import annotations

import io
from collections.abc import Collection, Iterator
from functools import cached_property
from pathlib import Path

from tfloom.bag.errors import BagError
from tfloom.bag.reading.ros1_index import has_index, read_index
from tfloom.bag.reading.ros1_layout import Ros1Layout
from tfloom.bag.reading.ros1_records import MAGIC, DamagedRecordError
from tfloom.bag.reading.ros1_scan import Ros1Scan
from tfloom.bag.reading.stored_messages import StoredMessages
from tfloom.bag.values import RawMessage, Topic

__all__ = ["Ros1File"]


class Ros1File(StoredMessages):
    """A bag of ROS 1, whose messages are serialized in its own way. It is open while it is read only.

    Args:
        path: The file.

    Raises:
        BagError: it is not a bag of ROS 1, or its beginning is damaged, or a chunk can't be decompressed.
        OSError: it can't be read.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        with io.FileIO(path) as file:
            start = file.read(len(MAGIC)) or b""
            if not start:
                raise BagError(path, "the file is empty: its recorder ended before it wrote anything")
            if start != MAGIC:
                raise BagError(path, f"this is not a bag of ROS 1, version 2.0: it begins with {start!r}", 0)
            self._layout = _read_layout(file, path)
        self.message_count = self._layout.message_count
        self.start_ns, self.end_ns = self._layout.start_ns, self._layout.end_ns

    @cached_property
    def topics(self) -> list[Topic]:
        """The topics, one for each name."""
        return list(self._layout.topics.values())

    def messages(self, topics: Collection[str] | None, start_ns: int, end_ns: int) -> Iterator[RawMessage]:
        """Yield the messages of topics (None: all) with log times in [start, end], in the order of log times.

        Raises:
            BagError: a chunk can't be decompressed.
        """
        yield from self._layout.messages(topics, start_ns, end_ns)


def _read_layout(file: io.FileIO, path: Path) -> Ros1Layout:
    """Return the layout by the index, or by a walk over the records where there is none or it is damaged."""
    layout = Ros1Layout(path)
    why = "the file has no index, because it is still being recorded or its recorder was killed"
    if has_index(file, layout):
        try:
            read_index(file, layout)
        except DamagedRecordError as error:
            why = f"the index is damaged, and isn't used: {error}"
            layout = Ros1Layout(path)
        else:
            return layout
    Ros1Scan(file, layout, why).run()
    return layout
