"""Shared by storages that read one message at a time: their decompression, and the transforms in them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path

from tfloom._native import TfRecords
from tfloom.bag.errors import BagError
from tfloom.bag.reading.compression import CompressionError, decompress_message
from tfloom.bag.values import EARLIEST, LATEST, Progress, RawMessage, TfTopic

__all__ = ["StoredMessages"]


class StoredMessages(ABC):
    """A storage whose messages are read one by one."""

    path: Path
    is_message_compressed = False

    @abstractmethod
    def messages(self, topics: Collection[str] | None, start_ns: int, end_ns: int) -> Iterator[RawMessage]:
        """Yield the messages of topics (None: all) with log times in [start, end], in the order of log times.

        Raises:
            BagError: the file is damaged.
        """

    def insert_transforms(
        self,
        into: TfRecords,
        topics: Mapping[str, TfTopic],
        start_ns: int,
        end_ns: int,
        progress: Progress,
    ) -> None:
        """Store the transforms of topics by name; moving ones if their log times are in [start, end].

        Args:
            into: Where they are stored.
            topics: The topics.
            start_ns: The least log time of moving transforms [ns since epoch].
            end_ns: The greatest one.
            progress: Called with the size of each message.

        Raises:
            BagError: the file is damaged.
        """
        for is_static, times in ((False, (start_ns, end_ns)), (True, (EARLIEST, LATEST))):
            names = [name for name, topic in topics.items() if topic.is_static == is_static]
            for message in self.messages(names, *times) if names else ():
                into.insert(topics[message.topic].number, message.data)
                progress(len(message.data))

    def _message(self, data: bytes) -> bytes:
        """Return a message's bytes, decompressed if each message is compressed by itself."""
        if not self.is_message_compressed:
            return data
        try:
            return decompress_message(data)
        except CompressionError as error:
            raise BagError(self.path, str(error)) from None
