"""What a recording and its topics show in a notebook, as HTML."""

from __future__ import annotations

from collections.abc import Collection
from html import escape
from itertools import islice

from tfloom.common.notebook import code, faint, shortened, table
from tfloom.common.text import utc_text

__all__ = ["error_html", "span_html", "topics_html"]

MAX_TOPICS = 100
"""How many topics are shown."""


def span_html(path: str, message_count: int, span_ns: tuple[int, int]) -> str:
    """Return the recording's path, its number of messages and the times of the first and the last one."""
    about = f"{message_count} messages"
    if message_count:
        start_ns, end_ns = span_ns
        start, end = (utc_text(stamp_ns // 1_000_000_000) for stamp_ns in span_ns)
        about += f" in {(end_ns - start_ns) / 1e9:.3f} s, {start} to {end}"
    return f"<b>{escape(shortened(path))}</b> {faint(escape(about))}"


def topics_html(topics: Collection[tuple[str, str, int]]) -> str:
    """Return topics as a table of their names, types and numbers of messages."""
    if not topics:
        return "no topics"
    rows = [
        (code(shortened(name)), escape(shortened(type_name)), str(message_count))
        for name, type_name, message_count in islice(topics, MAX_TOPICS)
    ]
    more = f"\n{len(topics) - MAX_TOPICS} more topics" if len(topics) > MAX_TOPICS else ""
    return table(rows, ("topic", "type", "messages")) + more


def error_html(error: Exception) -> str:
    """Return why a recording can't be read."""
    return escape(shortened(str(error)))
