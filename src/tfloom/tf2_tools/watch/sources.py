"""Where the TF tools take frames from: a live graph, a recording, or a file of static transforms."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Protocol

from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.static_file import StaticFileError, encoded, read_statics
from tfloom.tf2_tools.watch.model import STATIC_TOPIC, Observation
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


def open_path(path: Path, *, buffer: Buffer | None = None) -> Still:
    """Read a bag or a file of static transforms.

    Args:
        path: A file that ends in .yaml or .yml, or a bag.
        buffer: A buffer to fill as well.

    Raises:
        StaticFileError: it is no file of static transforms.
        OSError: it can't be read.
    """
    if not is_static_file(path):
        raise StaticFileError(f"{path}: not a file of static transforms (.yaml); bags can't be read yet")
    now_ns = time.time_ns()
    message: RecordedMessage = STATIC_TOPIC, now_ns, encoded(read_statics(path), now_ns)
    return Still(observe_recorded([message], str(path), buffer=buffer), buffer)
