"""What a recording and its topics show in a notebook, as HTML."""

from __future__ import annotations

import datetime as dt
from collections.abc import Collection
from html import escape
from itertools import islice
from typing import TYPE_CHECKING

from tfloom.bag.errors import BagError
from tfloom.notebook_html import code, faint, shortened, table

if TYPE_CHECKING:
    from tfloom.bag.bag import Bag
    from tfloom.bag.values import Topic

__all__ = ["bag_html", "topics_html"]

MAX_TOPICS = 100
"""How many topics are shown."""


def bag_html(bag: Bag) -> str:
    """Return the recording's path, its times and its topics; the error where a file can't be read."""
    try:
        topics = bag.topics.values()
        about = _about(bag)
    except BagError as error:
        return escape(str(error))
    return f"<b>{escape(shortened(str(bag.path)))}</b> {faint(escape(about))}\n{topics_html(topics)}"


def _about(bag: Bag) -> str:
    about = f"{bag.message_count} messages"
    if bag.message_count:
        about += (
            f" in {(bag.end_ns - bag.start_ns) / 1e9:.3f} s, {_date(bag.start_ns)} to {_date(bag.end_ns)}"
        )
    return about


def topics_html(topics: Collection[Topic]) -> str:
    """Return topics as a table of their names, types and numbers of messages."""
    if not topics:
        return "no topics"
    rows = [
        (code(shortened(topic.name)), escape(shortened(topic.type)), str(topic.message_count))
        for topic in islice(topics, MAX_TOPICS)
    ]
    more = f"\n{len(topics) - MAX_TOPICS} more topics" if len(topics) > MAX_TOPICS else ""
    return table(rows, ("topic", "type", "messages")) + more


def _date(stamp_ns: int) -> str:
    """Return a stamp as a time in UTC, and as a number where no date is so late."""
    try:
        return (
            f"{dt.datetime.fromtimestamp(stamp_ns // 1_000_000_000, dt.timezone.utc):%Y-%m-%d %H:%M:%S} UTC"
        )
    except (OverflowError, ValueError, OSError):
        return f"{stamp_ns / 1e9:.3f}"
