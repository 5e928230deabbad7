"""Whether a compressed chunk that declares a large size has messages for it, found without holding its content."""

from __future__ import annotations

from tfloom import _native
from tfloom.bag.reading.compression import MIN_RATIO, MIN_SIZE, DamagedError, pieces
from tfloom.bag.reading.mcap_records import RECORD_HEADER, Opcode

__all__ = ["check_plausible"]

MAX_MESSAGES = 1 << 20
"""The most messages in such a chunk, if they are small, because each takes 250 bytes of memory."""
MAX_OTHERS = 1 << 17
"""The most schemas and channels in such a chunk: there are no more numbers for them."""
SMALL = 128
"""The mean size of small messages [bytes]: at such a ratio their stamps can't differ."""
_KINDS = {Opcode.SCHEMA, Opcode.CHANNEL, Opcode.MESSAGE}


def check_plausible(method: str, stored: bytes, size: int, is_whole: bool) -> None:
    """Raise DamagedError if a chunk isn't to be decompressed.

    A high ratio alone is not a sign, so the chunk is decompressed by parts, which are walked over and dropped.

    Args:
        method: The compression.
        stored: The compressed bytes.
        size: The declared size [bytes].
        is_whole: Whether the file has all of it.

    Raises:
        DamagedError: it holds no message, or other records than those of a chunk, or the bytes are damaged.
        CompressionError: the method is unknown, or its library isn't installed.
    """
    if not method or size < max(MIN_SIZE, MIN_RATIO * len(stored)):
        return
    walk = _Walk()
    for piece in pieces(method, stored):
        if reason := walk.add(piece):
            raise DamagedError(f"{len(stored)} bytes stand for {size}, and {reason}")
    if is_whole and (walk.left or not walk.messages):
        what = "their last record isn't whole" if walk.left else "hold no message"
        raise DamagedError(f"{len(stored)} bytes stand for {size}, and {what}")


class _Walk:
    """A walk over records that come in pieces."""

    def __init__(self) -> None:
        self.messages = 0
        self.left = 0
        """How much is still to come of a record whose header has come [bytes]."""
        self._others = 0
        self._at = 0
        self._rest = b""

    def add(self, piece: bytes) -> str:
        """Walk over the next bytes; return what is wrong with them, or an empty text."""
        # A piece ends anywhere. It begins with the end of a record whose header is known, of which no more than the
        # length matters, or else with the end of a header, whose beginning is in `_rest`.
        skipped = min(self.left, len(piece))
        self.left -= skipped
        data = self._rest + piece[skipped:]
        try:
            counts, _, _, others, end = _native.summarise_mcap(data, 0)
        except ValueError as error:
            return f"they are damaged: {error}"
        self.messages += sum(counts.values())
        self._others += len(others)
        self._at += skipped + end
        self._rest = data[end:]
        # The last record isn't whole. Once its header is, count it and drop what is there of it: only the number of
        # bytes to skip is kept, so that a record of any size takes no memory.
        if len(self._rest) >= RECORD_HEADER.size:
            opcode, length = RECORD_HEADER.unpack_from(self._rest)
            if opcode not in _KINDS:
                return f"have a record of kind {opcode} at byte {self._at}, after {self.messages} messages"
            self.messages += opcode == Opcode.MESSAGE
            self.left = RECORD_HEADER.size + length - len(self._rest)
            self._at += len(self._rest)
            self._rest = b""
        if self.messages > MAX_MESSAGES and self._at < SMALL * self.messages:
            return f"hold more than {MAX_MESSAGES} messages of one time"
        if self._others > MAX_OTHERS:
            return f"hold more than {MAX_OTHERS} schemas and channels"
        return ""
