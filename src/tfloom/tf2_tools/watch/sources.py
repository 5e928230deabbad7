"""Where the TF tools take frames from: a live graph, a recording, or a file of static transforms."""

from __future__ import annotations

import time
from collections.abc import Iterable
from pathlib import Path
from typing import Protocol

from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.static_file import encoded, read_statics
from tfloom.tf2_tools.watch.model import STATIC_TOPIC, TOPICS, Observation
from tfloom.tf2_tools.watch.recorded import RecordedMessage, observe_recorded

__all__ = ["LIVE", "Source", "Still", "is_static_file", "open_path"]

LIVE = "live"
"""The word for the live graph in place of a path."""
STATIC_FILES = (".yaml", ".yml")


class Source(Protocol):
    """A source of transforms; `LiveWatch` is one."""

    buffer: Buffer | None
    """What a transform listener would hold."""

    def observation(self) -> Observation:
        """Return all that is known now."""

    def wait(self, end_s: float) -> None:
        """Wait until more may be known, or until `end_s` on the monotonic clock [s]."""

    def now_ns(self) -> int:
        """Return the time [ns since epoch]: this machine's, a simulation's, or that at the end of a recording."""


class Still:
    """A source that is read once: a recording, or a file of static transforms.

    Args:
        observation: What it holds.
        buffer: The buffer that it filled.
    """

    def __init__(self, observation: Observation, buffer: Buffer | None) -> None:
        self._observation = observation
        self.buffer = buffer

    def observation(self) -> Observation:
        """Return all that it holds."""
        return self._observation

    def wait(self, end_s: float) -> None:
        """Return at once, because nothing more will be known."""

    def now_ns(self) -> int:
        """Return the time of the last message [ns since epoch]."""
        return self._observation.taken_ns


def is_static_file(path: Path) -> bool:
    """Return whether a path is that of a file of static transforms, by its name; else it is that of a bag."""
    return path.suffix.lower() in STATIC_FILES and path.name != "metadata.yaml"


def open_path(path: Path, *, buffer: Buffer | None = None, topics: tuple[str, str] = TOPICS) -> Still:
    """Read a bag or a file of static transforms.

    Args:
        path: A file that ends in .yaml or .yml, or a bag.
        buffer: A buffer to fill as well.
        topics: The topics of moving and of static transforms, of a bag.

    Raises:
        StaticFileError: it is not a file of static transforms.
        BagError: it is not a bag, or has no transforms.
        OSError: it can't be read.
    """
    if not is_static_file(path):
        return Still(_observe_bag(path, topics, buffer), buffer)
    now_ns = time.time_ns()
    message: RecordedMessage = STATIC_TOPIC, now_ns, encoded(read_statics(path), now_ns)
    return Still(observe_recorded([message], str(path), buffer=buffer), buffer)


def _observe_bag(path: Path, topics: tuple[str, str], buffer: Buffer | None) -> Observation:
    from tfloom.bag.errors import BagError
    from tfloom.bag.opening import open_bag
    from tfloom.bag.tf_frames import TF_TYPES

    with open_bag(path) as bag:
        there = {topic.name: topic for topic in bag.topics.values() if topic.type in TF_TYPES}
        # Names as they are in the bag, by those that are asked for: a bag of ROS 1 may have `tf` for `/tf`.
        names = {recorded: name for name in topics for recorded in _spellings(name, there)}
        if not names:
            others = ", ".join(sorted(there)) or "none"
            raise BagError(
                path, f"it has neither {topics[0]} nor {topics[1]}; its topics of transforms are: {others}"
            )
        ros1 = any(there[recorded].serialization_format == "ros1" for recorded in names)
        return observe_recorded(
            (
                (names[message.topic], message.log_time_ns, message.data)
                for message in bag.messages(list(names))
            ),
            str(path),
            buffer=buffer,
            topics=topics,
            ros1=ros1,
        )


def _spellings(name: str, there: Iterable[str]) -> list[str]:
    """Return the topic of this name, which recordings of ROS 1 may have without its first slash."""
    return [topic for topic in there if topic.lstrip("/") == name.lstrip("/")]
