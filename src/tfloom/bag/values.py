"""What a recording consists of: topics, their definitions, and messages as bytes."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from typing import TYPE_CHECKING, NamedTuple, Protocol

if TYPE_CHECKING:
    from tfloom._native import TfRecords

__all__ = [
    "EARLIEST",
    "LATEST",
    "Definition",
    "Progress",
    "RawMessage",
    "Storage",
    "Topic",
    "Topics",
    "bounded",
]

EARLIEST = 0
"""The least log time [ns since epoch]."""
LATEST = 2**63 - 1
"""The greatest log time [ns since epoch]."""


def bounded(start_ns: int | None, end_ns: int | None) -> tuple[int, int]:
    """Return the least and the greatest log time that are wanted, as storages take them [ns since epoch].

    They are within `EARLIEST` and `LATEST`; (1, 0) if no time is between them.

    Args:
        start_ns: The least one, any number; None: no bound.
        end_ns: The greatest one, any number; None: no bound.
    """
    start = EARLIEST if start_ns is None else max(EARLIEST, start_ns)
    end = LATEST if end_ns is None else min(LATEST, end_ns)
    return (start, end) if start <= end else (1, 0)


MAY_BE_EMPTY = "ros2msg"
"""The encoding whose empty text is the definition of a type without fields."""


class Definition(NamedTuple):
    """The definition of a type, as a recording has it."""

    encoding: str
    """`ros2msg`, `ros2idl`, or `ros1msg`; empty if the recording has none."""
    text: str
    """The definition, and those of all types in it, separated by lines of `=`."""

    def __repr__(self) -> str:
        from tfloom.common.terminal import shown_name

        return f"<Definition {shown_name(self.encoding) or 'of no encoding'}, {len(self.text)} characters>"


class Topic(NamedTuple):
    """A topic of a recording, with what the recording says about its type and its publishers."""

    name: str
    """Its name, with the slash that it begins with."""
    type: str
    """`package/msg/Name`."""
    serialization_format: str = "cdr"
    """`cdr`; `ros1` in recordings of ROS 1."""
    type_hash: str = ""
    """`RIHS01_…`; empty if the recording doesn't have it."""
    offered_qos: str = ""
    """The publishers' profiles as YAML, as storages have it; empty if the recording doesn't have them."""
    definition: Definition | None = None
    """The definition of its type; None if the recording doesn't have it."""
    message_count: int = 0
    """Number of its messages in the recording."""

    def __repr__(self) -> str:
        from tfloom.common.terminal import shown_name

        return f"<Topic {shown_name(self.name)}: {shown_name(self.type)}, {self.message_count} messages>"


class Topics(dict[str, Topic]):
    """The topics of a recording by name, which a notebook shows as a table."""

    def _repr_html_(self) -> str:
        """Return what a notebook shows: names, types and numbers of messages."""
        from tfloom.bag.html import topics_html

        return topics_html([(topic.name, topic.type, topic.message_count) for topic in self.values()])


class RawMessage(NamedTuple):
    """A recorded message, with its bytes as they are serialized."""

    topic: str
    """Its topic's name."""
    log_time_ns: int
    """When it was received [ns since epoch]."""
    publish_time_ns: int
    """When it was published [ns since epoch]; the log time where the recording doesn't have it."""
    data: bytes
    """Its serialized bytes; for CDR, with the encapsulation header."""


class TfTopic(NamedTuple):
    """A topic whose transforms are stored."""

    number: int
    """What `TfRecords.add_topic` returned."""
    is_static: bool
    """Whether its transforms are static, and therefore stored whatever their log times."""


Progress = Callable[[int], object]
"""Called with the number of bytes that were read since the call before."""


class Storage(Protocol):
    """What a reader of any file format offers."""

    @property
    def topics(self) -> list[Topic]:
        """The topics, one for each name."""

    start_ns: int
    """The least log time [ns since epoch]; 0 without messages."""
    end_ns: int
    """The greatest one [ns since epoch]."""
    message_count: int
    is_message_compressed: bool
    """Whether each message is compressed by itself; `messages` yields them decompressed."""

    def messages(self, topics: Collection[str] | None, start_ns: int, end_ns: int) -> Iterator[RawMessage]:
        """Yield the messages of topics (None: all) with log times in [start, end], in the order of log times."""

    def insert_transforms(
        self,
        into: TfRecords,
        topics: Mapping[str, TfTopic],
        start_ns: int,
        end_ns: int,
        progress: Progress,
    ) -> None:
        """Store the transforms of topics by name; moving ones if their log times are in [start, end]."""
