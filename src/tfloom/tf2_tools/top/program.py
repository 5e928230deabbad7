"""The loop: observe, draw, take keys."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import AbstractContextManager, ExitStack
from typing import TYPE_CHECKING

from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.top.lines import Summary, follow_lines, screen
from tfloom.tf2_tools.top.rows import Rates, Row, rows_of
from tfloom.tf2_tools.top.view import View
from tfloom.tf2_tools.watch.model import Observation
from tfloom.tf2_tools.watch.sources import Source

if TYPE_CHECKING:
    from tfloom.common.keyboard import Keyboard
    from tfloom.tf2_tools.top.terminal import Screen

OpenSource = Callable[[Buffer], AbstractContextManager[Source]]
"""Opens a second reading of the same transforms, which fills a buffer."""


class Top:
    """The table of a source, and the pair of frames that is followed.

    Args:
        source: The source.
        place: Where the transforms come from, for the title.
        open_source: Opens another source, for the followed pair: without one, no buffer has to be filled.
    """

    def __init__(self, source: Source, place: str, open_source: OpenSource) -> None:
        self._source = source
        self._place = place
        self._open_source = open_source
        self._rates = Rates()
        self._buffer: Buffer | None = None
        self._stack = ExitStack()

    def look(self) -> tuple[list[Row], Summary]:
        """Observe, and return the rows and the title's figures."""
        observation = self._source.observation()
        self._rates.add(observation)
        rows = rows_of(observation, self._source.now_ns(), self._rates)
        return rows, self._summary(observation)

    def _summary(self, observation: Observation) -> Summary:
        publishers = len(
            {publisher.label for publisher in observation.publishers if publisher.traffic is not None}
        )
        return Summary(len(observation.frames()), publishers, self._rates.total(), self._place)

    def followed(self, pair: tuple[str, str] | None) -> list[str]:
        """Return the lines of the followed pair; none without one."""
        if pair is None:
            self.close()
            return []
        if self._buffer is None:
            self._buffer = Buffer()
            self._buffer.set_log_callback(_ignore_log)
            self._stack.enter_context(self._open_source(self._buffer))
        return follow_lines(self._buffer, pair, self._source.now_ns())

    def close(self) -> None:
        """Stop following: close the second source and drop its buffer."""
        self._buffer = None
        self._stack.close()


def run(top: Top, view: View, terminal: Screen, keyboard: Keyboard, period_s: float) -> None:
    """Show the table, every `period_s` [s] and at each key, until the user quits."""
    rows, summary = top.look()
    next_s = time.monotonic() + period_s
    while not view.is_over:
        terminal.draw(screen(rows, summary, view, top.followed(view.pair), terminal.size()))
        try:
            keys = keyboard.read(max(0.0, next_s - time.monotonic()))
        except EOFError:  # the terminal is closed
            return
        for key in keys:
            view.press(key)
        if time.monotonic() >= next_s:
            # Keep the rhythm; but after an observation that took longer than a period, don't make up for lost ones.
            next_s = max(next_s + period_s, time.monotonic())
            # Only the period observes anew. A key draws what was observed last, so it responds at once.
            if not view.is_paused:
                rows, summary = top.look()


def _ignore_log(_: int, __: str) -> None:
    """Log nothing of rejected transforms, because the screen is the table's; its notes say what is wrong."""
