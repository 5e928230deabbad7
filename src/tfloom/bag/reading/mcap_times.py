"""The log times of the messages of MCAP chunks, which may be others than the chunks declare."""

from __future__ import annotations

import io
from pathlib import Path

from tfloom import _native
from tfloom.bag.reading.file_bytes import read_at
from tfloom.bag.reading.mcap_layout import Span, decompressed

__all__ = ["with_true_times"]


def with_true_times(file: io.FileIO, path: Path, span: Span) -> Span:
    """Return a span with the times of its messages.

    A part of a bag is read by leaving out chunks of other times, and a chunk that declares wrong ones would be left
    out with its messages in silence. Its message indexes are small and tell them; without indexes it is read itself.

    Args:
        file: The open file.
        path: Its path, for warnings.
        span: A span, as the file declares it.

    Raises:
        BagError: it has no index and can't be decompressed, because the compression is unknown, or its library isn't
            installed.
    """
    if not span.are_times_declared:
        return span
    first, last = _times_of_indexes(file, span) or _times_of_messages(file, path, span)
    return span._replace(
        start_ns=min(first, span.start_ns), end_ns=max(last, span.end_ns), are_times_declared=False
    )


def _times_of_indexes(file: io.FileIO, span: Span) -> tuple[int, int] | None:
    if not span.index_length:
        return None
    try:
        count, first, last = _native.summarise_mcap_indexes(
            read_at(file, span.offset + span.stored_size, span.index_length)
        )
    except ValueError:
        return None
    return (first, last) if count else None


def _times_of_messages(file: io.FileIO, path: Path, span: Span) -> tuple[int, int]:
    data = decompressed(file, path, span) or b""
    try:
        counts, first, last, _, _ = _native.summarise_mcap(data, 0)
    except ValueError:
        counts = {}
    return (first, last) if counts else (span.start_ns, span.end_ns)
