"""The messages of parts of a file, which may overlap in time, in the order of log times."""

from __future__ import annotations

import heapq
from bisect import bisect_left
from collections.abc import Callable, Iterator, Sequence
from operator import itemgetter
from typing import Protocol, TypeVar

from tfloom.bag.values import LATEST

__all__ = ["Found", "in_order"]

Found = tuple[int, int, int, bytes]
"""A message: log time, channel or connection, publish time, bytes."""
_log_time = itemgetter(0)


class Part(Protocol):
    """A part of a file that has messages."""

    @property
    def start_ns(self) -> int:
        """The least log time [ns since epoch]."""

    @property
    def offset(self) -> int:
        """Of the part in the file."""


AnyPart = TypeVar("AnyPart", bound=Part)


def in_order(parts: Sequence[AnyPart], read: Callable[[AnyPart], list[Found]]) -> Iterator[Found]:
    """Yield the messages of parts in the order of log times; those of one time in the order of the file.

    A part is in memory from its first log time to its last message.

    Args:
        parts: The parts, by their first log time.
        read: Returns the messages of one in the order of the file.
    """
    held: dict[int, list[Found]] = {}
    heap: list[tuple[int, int, int, int]] = []
    """Of each part that is held: the next message's log time, the part's offset and number, the message's index."""
    # Parts come by their first log time, so once a part is read, all messages before the first time of the next part
    # are at hand. They are yielded by a merge of the parts that are held, and only then is the next part read: parts
    # that don't overlap are in memory one at a time.
    for index, part in enumerate(parts):
        messages = read(part)
        messages.sort(key=_log_time)  # stable: those of one time stay in the order of the file
        if messages:
            held[index] = messages
            heapq.heappush(heap, (messages[0][0], part.offset, index, 0))
        del messages
        limit = parts[index + 1].start_ns if index + 1 < len(parts) else LATEST + 1
        while heap and heap[0][0] < limit:
            _, offset, number, at = heap[0]
            messages = held[number]
            # Whole runs are taken at once, which saves a heap operation for each message: the next message, and those
            # of the same part up to the first one of another. That one is the lesser of the two children of the heap's
            # top. The run has at least one message, so that equal times don't stop the loop; among them, the heap
            # prefers the part that is first in the file.
            end = min(limit, min((entry[0] for entry in heap[1:3]), default=limit))
            stop = max(at + 1, bisect_left(messages, end, at, key=_log_time))
            yield from messages[at:stop]
            if stop < len(messages):
                heapq.heapreplace(heap, (messages[stop][0], offset, number, stop))
            else:
                heapq.heappop(heap)
                del held[number]
            del messages  # before the next part is read
