"""Messages that pages publish, once or at a rate."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING

from tfloom.rmw.errors import WireError
from tfloom.viewer.forms.task import Task

if TYPE_CHECKING:
    from tfloom.rmw.base import Writer

__all__ = ["Publication", "Repetition"]

MATCH_S = 1.0
"""The longest wait until a new writer has the subscriptions that the graph has [s]."""
LOOK_S = 0.05
"""Period at which a first message is tried again [s]."""
TOLD_S = 0.5
"""Least time between two counts of messages that a page gets [s]."""


class Publication(Task):
    """A message that is written when its writer has the subscriptions that the graph has, or at a timeout."""

    def __init__(
        self,
        writer: Writer,
        name: str,
        data: bytes,
        reader_counts: tuple[int, int],
        tell: Callable[[str, str], None],
    ) -> None:
        self._writer = writer
        self.name = name
        self._data = data
        self._reader_count, self._own_count = reader_counts
        self._tell = tell
        self._end_s = time.monotonic() + MATCH_S

    def uses(self, writer: Writer) -> bool:
        """Return whether it is this writer that writes."""
        return writer is self._writer

    def step(self) -> bool:
        """Write the message if that can be done now; return whether it was written."""
        matched = self._writer.matched_count()
        if matched < self._reader_count and time.monotonic() < self._end_s:
            return False
        self._writer.write(self._data)
        others = max(0, matched - self._own_count)
        missed = self._reader_count - matched
        said = f"published on {self.name}: {others} subscription{'s' * (others != 1)}"
        if missed > 0:
            said += f"; {missed} more with another quality of service, which get nothing"
        self._tell("done", said)
        return True

    def write(self, data: bytes) -> None:
        """Write a further message, when the first one is written."""
        self._writer.write(data)

    def close(self) -> None:
        """Leave the writer open for the next message."""


class Repetition(Task):
    """A message that is written again and again, with the time of each writing where it has the word `now`.

    Args:
        first: Its first publication.
        new_data: Returns the bytes of the next message.
        period_s: Time between two messages [s].
        tell: Tells the page.
        last_data: Returns the bytes of what is written at the end, as a velocity of zeros; None: nothing.
    """

    def __init__(
        self,
        first: Publication,
        new_data: Callable[[], bytes],
        period_s: float,
        tell: Callable[[str, str], None],
        last_data: Callable[[], bytes] | None = None,
    ) -> None:
        self._first = first
        self._new_data = new_data
        self._period_s = period_s
        self._tell = tell
        self._last_data = last_data
        self._count = 0
        self._due_s = time.monotonic()
        self._next_told_s = 0.0

    @property
    def due_s(self) -> float:
        """When the next message is written [s, monotonic]."""
        return self._due_s

    @property
    def last_word(self) -> tuple[str, str]:
        """Return how many messages were published, as what is done."""
        return "done", f"published {self._count} message{'s' * (self._count != 1)} on {self._first.name}"

    def uses(self, writer: Writer) -> bool:
        """Return whether it is this writer that writes."""
        return self._first.uses(writer)

    def step(self) -> bool:
        """Write a message if it is time for it; return False, because it goes on."""
        now_s = time.monotonic()
        if self._count == 0:
            self._count = int(self._first.step())
            self._due_s = now_s + (self._period_s if self._count else LOOK_S)
            return False
        if now_s < self._due_s:
            return False
        # What was missed is not made up for: a thread that was late doesn't send a burst.
        self._due_s = max(self._due_s + self._period_s, now_s)
        self._first.write(self._new_data())
        self._count += 1
        if now_s >= self._next_told_s:
            self._next_told_s = now_s + TOLD_S
            self._tell("feedback", self.last_word[1])
        return False

    def close(self) -> None:
        """Write what is last, and leave the writer open for the next message."""
        if self._count and self._last_data is not None:
            with suppress(WireError):
                self._first.write(self._last_data())
        self._first.close()
