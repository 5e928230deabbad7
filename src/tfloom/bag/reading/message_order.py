"""The messages of parts of a file, which may overlap in time, in the order of log times."""

from __future__ import annotations

import heapq
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
    heap: list[tuple[int, int, int, Iterator[Found], Found]] = []
    for index, part in enumerate(parts):
        messages = iter(sorted(read(part), key=_log_time))
        if (first := next(messages, None)) is not None:
            heapq.heappush(heap, (first[0], part.offset, index, messages, first))
        limit = parts[index + 1].start_ns if index + 1 < len(parts) else LATEST + 1
        while heap and heap[0][0] < limit:
            _, offset, number, messages, found = heap[0]
            yield found
            # The next ones of the same part, up to the first one of another.
            end = min(limit, min((each[0] for each in heap[1:3]), default=limit))
            for found in messages:
                if found[0] >= end:
                    heapq.heapreplace(heap, (found[0], offset, number, messages, found))
                    break
                yield found
            else:
                heapq.heappop(heap)
