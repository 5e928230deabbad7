"""A recording: its topics, and its messages in the order of log times, across its files."""

from __future__ import annotations

import heapq
from collections.abc import Collection, Iterator
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tfloom.bag.errors import BagError
from tfloom.bag.metadata import Metadata
from tfloom.bag.reading.bag_file import BagFile
from tfloom.bag.values import RawMessage, Topic, Topics, bounded

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["Bag"]


class Bag:
    """A recording, which `open_bag` returns. It is a context manager; files are open while they are read only.

    Args:
        path: The folder or the file.
        files: Its files, in the order of recording.
        metadata: What metadata.yaml says; None if there is none.

    Attributes:
        path: The folder or the file.
        files: Its files.
        metadata: What metadata.yaml says; None for a single file, and for several recordings.
        parts: The files of each recording; there are several if this is read from several at a time.
    """

    def __init__(self, path: Path, files: list[BagFile], metadata: Metadata | None) -> None:
        self.path = path
        self.files = files
        self.metadata = metadata
        self.parts = [files]

    def __repr__(self) -> str:
        from tfloom.common.terminal import shown_name

        try:
            topics = [
                shown_name(f"{topic.name} ({topic.type}, {topic.message_count})")
                for topic in self.topics.values()
            ]
            span = f"{self.message_count} messages in {(self.end_ns - self.start_ns) / 1e9:.3f} s"
        except BagError as error:
            return f"<Bag {error}>"
        return f"<Bag {self.path}: {span}; {', '.join(topics) or 'no topics'}>"

    def _repr_html_(self) -> str:
        """Return what a notebook shows: its path and times, and a table of its topics."""
        from tfloom.bag.html import error_html, span_html

        try:
            span = span_html(str(self.path), self.message_count, (self.start_ns, self.end_ns))
            return f"{span}\n{self.topics._repr_html_()}"
        except BagError as error:
            return error_html(error)

    def __enter__(self) -> Bag:  # noqa: PYI034  # not to be derived from
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        """Remove the temporary files that were made to read compressed ones."""
        for file in self.files:
            file.close()

    @cached_property
    def topics(self) -> Topics:
        """The topics by name.

        Raises:
            BagError: a file can't be read.
        """
        listed = {topic.name: topic for topic in self.metadata.topics} if self.metadata else {}
        topics = listed.copy() if self._knows_all else {}
        for file in self.files[:1] if self._knows_all else self.files:
            for topic in file.topics:
                topics[topic.name] = _joined_topic(topics.get(topic.name), topic, self._knows_all)
        return Topics({**listed, **topics})

    @property
    def _knows_all(self) -> bool:
        """Whether files are compressed, so that metadata.yaml is read rather than all files."""
        return self.metadata is not None and any(file.is_compressed for file in self.files)

    @cached_property
    def start_ns(self) -> int:
        """The least log time [ns since epoch]; 0 without messages."""
        if self._knows_all and self.metadata:
            return self.metadata.start_ns
        return min((file.start_ns for file in self._filled), default=0)

    @cached_property
    def end_ns(self) -> int:
        """The greatest log time [ns since epoch]; 0 without messages."""
        if self._knows_all and self.metadata:
            return self.metadata.start_ns + self.metadata.duration_ns
        return max((file.end_ns for file in self._filled), default=0)

    @cached_property
    def message_count(self) -> int:
        """Number of messages."""
        if self._knows_all and self.metadata:
            return self.metadata.message_count
        return sum(file.message_count for file in self.files)

    @property
    def size(self) -> int:
        """The sizes of the files together [bytes]."""
        return sum(file.path.stat().st_size for file in self.files if file.path.exists())

    @property
    def _filled(self) -> list[BagFile]:
        return [file for file in self.files if file.message_count]

    def topic(self, name: str) -> Topic:
        """Return a topic.

        Raises:
            BagError: there is none of this name.
        """
        if name not in self.topics:
            raise self._no_topic(name)
        return self.topics[name]

    def _no_topic(self, name: str) -> BagError:
        topics = ", ".join(sorted(self.topics)) or "none"
        return BagError(self.path, f"there is no topic '{name}'; the topics are: {topics}")

    def messages(
        self,
        topics: str | Collection[str] | None = None,
        start_ns: int | None = None,
        end_ns: int | None = None,
    ) -> Iterator[RawMessage]:
        """Return the messages in the order of log times; those of one time in the order of recording.

        Args:
            topics: A name, or several; None: all.
            start_ns: The least log time [ns since epoch]; None: no bound.
            end_ns: The greatest one [ns since epoch]; None: no bound.

        Raises:
            BagError: there is no such topic; while they are read: a file can't be read.
            TypeError: a bound is not an int.
        """
        names = [topics] if isinstance(topics, str) else topics
        unknown_names = [] if names is None else [name for name in names if name not in self.topics]
        if unknown_names:
            raise self._no_topic(unknown_names[0])
        for name, bound in (("start_ns", start_ns), ("end_ns", end_ns)):
            if bound is not None and not hasattr(bound, "__index__"):
                given = f"{bound!r} of class {type(bound).__name__}"
                raise TypeError(f"{name} must be an int of nanoseconds, as int(seconds * 1e9), not {given}")
        full_names = None if names is None else {self.topics[name].name for name in names}
        return self._messages(full_names, *bounded(start_ns, end_ns))

    def _messages(self, topics: Collection[str] | None, start_ns: int, end_ns: int) -> Iterator[RawMessage]:
        # Files mostly follow each other in time, and are then read one after the other. Only those that overlap are
        # open at the same time, and merged.
        files = self.files
        for group in _overlapping(files):
            is_outside = group[0].start_ns > end_ns or max(file.end_ns for file in group) < start_ns
            if is_outside and len(files) > 1:  # a single one looks at the times of its messages
                continue
            parts = [file.messages(topics, start_ns, end_ns) for file in group]
            yield from parts[0] if len(parts) == 1 else heapq.merge(*parts, key=lambda message: message[1])

    def read(
        self, topic: str, start_ns: int | None = None, end_ns: int | None = None
    ) -> Iterator[tuple[RawMessage, Any]]:
        """Return the messages of a topic, each with the message that its bytes decode to.

        The class is tfloom's where the definition is the same, else it is made from the recording's definition.

        Args:
            topic: Its name.
            start_ns: The least log time [ns since epoch]; None: no bound.
            end_ns: The greatest one [ns since epoch]; None: no bound.

        Raises:
            BagError: there is no such topic, or its type has no definition, here or in the recording; while they are
                read: a file can't be read, or a message can't be decoded.
        """
        from tfloom.bag.message_classes import decoder

        decode = decoder(self.path, self.topic(topic))
        return ((raw, decode(raw)) for raw in self.messages(topic, start_ns, end_ns))

    def stamps(
        self,
        topic: str,
        of: str | None = None,
        start_ns: int | None = None,
        end_ns: int | None = None,
    ) -> NDArray[np.int64]:
        """Return the stamps of a topic's messages (N,), in the order of log times [ns since epoch].

        Args:
            topic: Its name.
            of: `header` for the stamps in the messages, `log` for the times of receipt, `publish` for those of
                publishing; None: `header` if the messages begin with one, else `log`.
            start_ns: The least log time [ns since epoch]; None: no bound.
            end_ns: The greatest one [ns since epoch]; None: no bound.

        Raises:
            BagError: there is no such topic, its messages have no header, or a file can't be read.
            ValueError: `of` is none of these.
        """
        from tfloom.bag.stamps import stamps_of

        return stamps_of(self.path, self.topic(topic), self.messages(topic, start_ns, end_ns), of)


def _joined_topic(before: Topic | None, topic: Topic, is_counted: bool) -> Topic:
    """Return what is known of a topic from files, or from metadata.yaml, and from one more file."""
    if before is None:
        return topic
    count = before.message_count if is_counted else before.message_count + topic.message_count
    return topic._replace(
        type=topic.type or before.type,
        type_hash=topic.type_hash or before.type_hash,
        offered_qos=before.offered_qos or topic.offered_qos,
        definition=topic.definition or before.definition,
        message_count=count,
    )


def _overlapping(files: list[BagFile]) -> Iterator[list[BagFile]]:
    """Yield groups of files, in the order of time; files of different groups don't overlap in time."""
    group: list[BagFile] = []
    end_ns = 0
    for file in sorted(files, key=lambda file: file.start_ns):
        if group and file.start_ns > end_ns:
            yield group
            group = []
        end_ns = max(end_ns, file.end_ns)
        group.append(file)
    if group:
        yield group
