"""Messages of a bag, read ahead of their use on a thread, in bounded memory."""

from __future__ import annotations

import heapq
import os
import queue
import threading
from collections.abc import Iterator

from tfloom.bag.errors import BagError
from tfloom.bag.values import RawMessage

__all__ = ["ReadAhead", "by_sent_time"]

_BATCH = 64
_BATCH_SIZE = 1 << 20
"""A batch ends when its messages have this size [bytes]."""
_MAX_BATCHES = 32
_PATIENCE_S = 0.1


class ReadAhead:
    """An iterator over the messages of another one, which a thread reads.

    Args:
        path: The bag, for errors.
        messages: What is read.
        count: Number of messages that are read ahead, at most; fewer if they are large.

    Raises:
        BagError: no thread can be started.
    """

    def __init__(self, path: str | os.PathLike[str], messages: Iterator[RawMessage], count: int) -> None:
        batches = min(max(count // _BATCH, 2), _MAX_BATCHES)
        self._batches: queue.Queue[list[RawMessage] | BaseException | None] = queue.Queue(batches)
        self._ended = threading.Event()
        self._batch: Iterator[RawMessage] = iter(())
        self._thread = threading.Thread(target=self._read, args=(messages,), daemon=True)
        try:
            self._thread.start()
        except RuntimeError as error:
            raise BagError(path, f"it can't be read ahead: {error}") from error

    def __iter__(self) -> ReadAhead:
        return self

    def __next__(self) -> RawMessage:
        for message in self._batch:
            return message
        # The thread ends with None, or with the error that it met. None is put back, because an iterator that has ended
        # must end again, and nobody else would fill the queue.
        batch = self._batches.get()
        if batch is None:
            self._batches.put(None)
            raise StopIteration
        if isinstance(batch, BaseException):
            raise batch
        self._batch = iter(batch)
        return next(self)

    def close(self) -> None:
        """End the thread."""
        self._ended.set()
        self._thread.join()

    def _read(self, messages: Iterator[RawMessage]) -> None:
        batch: list[RawMessage] = []
        size = 0
        try:
            for message in messages:
                batch.append(message)
                size += len(message.data)
                if len(batch) >= _BATCH or size >= _BATCH_SIZE:
                    if not self._put_batch(batch):
                        return
                    batch, size = [], 0
            if batch:
                self._put_batch(batch)
            self._put_batch(None)
        except Exception as error:  # it is raised where the messages are used
            self._put_batch(batch)
            self._put_batch(error)

    def _put_batch(self, batch: list[RawMessage] | BaseException | None) -> bool:
        """Add a batch; return False if nobody takes it any more."""
        # A full queue wakes nobody on `close`, so this thread looks now and then whether it is still needed.
        while not self._ended.is_set():
            try:
                self._batches.put(batch, timeout=_PATIENCE_S)
            except queue.Full:
                continue
            return True
        return False


def by_sent_time(messages: Iterator[RawMessage], window: int) -> Iterator[RawMessage]:
    """Yield messages in the order in which they were published, with that time as their log time.

    A message is late that more than `window` others were received before it, though they were published after it.

    Args:
        messages: In the order of log times.
        window: How many are held at a time, at least one.
    """
    held: list[tuple[int, int, RawMessage]] = []
    for number, message in enumerate(messages):
        sent_ns = message.publish_time_ns
        heapq.heappush(held, (sent_ns, number, message._replace(log_time_ns=sent_ns)))
        if len(held) > max(window, 1):
            yield heapq.heappop(held)[2]
    while held:
        yield heapq.heappop(held)[2]
