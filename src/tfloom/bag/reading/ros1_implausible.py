"""Whether a compressed chunk of a ROS 1 bag that declares a large size has records for it, without holding them."""

from __future__ import annotations

from tfloom.bag.reading.compression import MIN_RATIO, MIN_SIZE, DamagedError, pieces
from tfloom.bag.reading.ros1_records import CONNECTION, MESSAGE, DamagedRecordError, Record, next_record

__all__ = ["check_plausible"]

MAX_MESSAGES = 1 << 20
"""The most messages in such a chunk, if they are small, because each takes 250 bytes of memory."""
MAX_CONNECTIONS = 1 << 16
"""The most connections in such a chunk."""
SMALL = 128
"""The mean size of small messages [bytes]: at such a ratio their stamps can't differ."""


def check_plausible(method: str, stored: bytes, size: int) -> None:
    """Raise DamagedError if a chunk isn't to be decompressed.

    A high ratio alone is not a sign, so the chunk is decompressed by parts, which are walked over and dropped.

    Args:
        method: The compression.
        stored: The compressed bytes.
        size: The declared size [bytes].

    Raises:
        DamagedError: it holds no message, or other records than those of a chunk, or the bytes are damaged.
        CompressionError: the method's library isn't installed.
    """
    if size < max(MIN_SIZE, MIN_RATIO * len(stored)):
        return
    walk = _Walk()
    for piece in pieces(method, stored):
        if reason := walk.add(piece):
            raise DamagedError(f"{len(stored)} bytes stand for {size}, and {reason}")
        if walk.at > size:
            raise DamagedError(f"{size} bytes are declared, and more are there")
    if walk.left or walk.rest or not walk.messages:
        what = "their last record isn't whole" if walk.left or walk.rest else "hold no message"
        raise DamagedError(f"{len(stored)} bytes stand for {size}, and {what}")


class _Walk:
    """A walk over records that come in pieces."""

    def __init__(self) -> None:
        self.messages = 0
        self.left = 0
        """How much is still to come of a record's data [bytes]."""
        self.at = 0
        """How many bytes have been walked over."""
        self.rest = b""
        """The beginning of a header."""
        self._connections = 0

    def add(self, piece: bytes) -> str:
        """Walk over the next bytes; return what is wrong with them, or an empty text."""
        # A piece ends anywhere. It begins with the end of the data of a record, of which no more than the length
        # matters, or else with the end of a header, whose beginning is in `rest`.
        skipped = min(self.left, len(piece))
        self.left -= skipped
        self.at += skipped
        data = self.rest + piece[skipped:]
        begin = 0
        try:
            while (record := next_record(data, begin)) is not None:
                if reason := self._count(record):
                    return reason
                # The header is whole. Of the data, only the number of bytes to skip is kept.
                end = min(record.end, len(data))
                self.left = record.end - end
                self.at += end - begin
                begin = end
        except DamagedRecordError as error:
            return f"are damaged at byte {self.at}: {error}"
        self.rest = data[begin:]
        return ""

    def _count(self, record: Record) -> str:
        if record.kind not in {MESSAGE, CONNECTION}:
            return f"have a record of kind {record.kind} at byte {self.at}, after {self.messages} messages"
        self.messages += record.kind == MESSAGE
        self._connections += record.kind == CONNECTION
        if self.messages > MAX_MESSAGES and self.at < SMALL * self.messages:
            return f"hold more than {MAX_MESSAGES} messages of one time"
        if self._connections > MAX_CONNECTIONS:
            return f"hold more than {MAX_CONNECTIONS} connections"
        return ""
