"""The records of /rosout, as lines of the page's log."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tfloom.interfaces.rcl_interfaces.msg import Log
from tfloom.rmw.qos import QoS, ReliabilityPolicy
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr
from tfloom.viewer.displays.display import shown_text

if TYPE_CHECKING:
    from tfloom.rmw.base import NodeName, Participant, Reader

__all__ = ["MAX_LINES", "LogLines"]

MAX_LINES = 2000
"""Number of the last lines that are kept for pages."""
MAX_TAKEN = 500
"""Number of records that are taken at once."""
MAX_TEXT = 2000


class LogLines:
    """Reads /rosout while a page is open. One thread may use it.

    Args:
        participant: The participant that reads.
        node: The node whose reader it is, which was added to the participant.
    """

    def __init__(self, participant: Participant, node: NodeName) -> None:
        self._participant = participant
        self._node = node
        self._reader: Reader | None = None

    def open(self) -> None:
        """Begin to read."""
        if self._reader is None:
            qos = QoS(ReliabilityPolicy.BEST_EFFORT, depth=MAX_TAKEN)
            self._reader = self._participant.create_reader(self._node, topic_of(Log, "/rosout"), qos)

    def close(self) -> None:
        """End reading."""
        if self._reader is not None:
            self._reader.close()
            self._reader = None

    def take(self) -> list[dict[str, Any]]:
        """Return the records that have come, as values for JSON."""
        lines: list[dict[str, Any]] = []
        if self._reader is None:
            return lines
        for _ in range(MAX_TAKEN):
            sample = self._reader.take()
            if sample is None:
                break
            try:
                record = cdr.decode(Log, sample.data)
            except cdr.DecodeError:
                continue
            lines.append(
                {
                    "stamp_ns": str(record.stamp.sec * 1_000_000_000 + record.stamp.nanosec),
                    "level": int(record.level),
                    "name": shown_text(record.name),
                    "text": shown_text(record.msg, MAX_TEXT),
                }
            )
        return lines
