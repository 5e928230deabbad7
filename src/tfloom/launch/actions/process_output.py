"""What a process writes: as lines on the screen and in logs, as events, and as text."""

from __future__ import annotations

import codecs
import logging
from typing import Any

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.events.process import ProcessStderr, ProcessStdout
from tfloom.launch.logs.log_handlers import around_field, is_behind, log_lines
from tfloom.launch.logs.logging import OutputConfig, get_output_loggers

__all__ = ["ProcessOutput"]

MAX_LINE_LENGTH = 1_000_000
"""Characters after which an incomplete line is printed."""

MAX_EVENTS = 64
"""Events that wait to be handled, from which on a process whose output is an event is not read."""


class _Stream:
    """One of the two outputs."""

    def __init__(self, logger: logging.Logger) -> None:
        self.logger = logger
        self.decoder = codecs.getincrementaldecoder("utf-8")(errors="replace")
        self.rest: list[str] = []
        """Parts of the last line, which is incomplete."""
        self.rest_length = 0
        self.cached: list[str] = []
        self.has_events = False
        """Whether handlers take what is written."""


class ProcessOutput:
    """The output of a process, complete lines as soon as they are there.

    Args:
        action: The action that runs it, for `line_format` and its `process_details` for events.
        name: Its name.
        output: Where it goes: see `logging.get_output_loggers`.
        line_format: Format of a line, of `line` and `this`, the action.
        is_cached: Whether all of it is kept for `text`.
    """

    def __init__(
        self, action: Any, name: str, output: OutputConfig, line_format: str, *, is_cached: bool
    ) -> None:
        self._action = action
        self._line_format = line_format
        self._is_cached = is_cached
        self._streams = dict(zip((1, 2), map(_Stream, get_output_loggers(name, output)), strict=True))

    def text(self, fd: int) -> str:
        """Return all of the output of stdout (1) or stderr (2) if it is cached, else the last, incomplete line."""
        stream = self._streams[fd]
        return "".join(stream.cached if self._is_cached else stream.rest)

    def is_behind(self, context: LaunchContext) -> bool:
        """Return whether the process should not be read for now, because what it has written is not handled yet."""
        streams = self._streams.values()
        if any(is_behind(stream.logger) for stream in streams):
            return True
        return any(stream.has_events for stream in streams) and context.run_state.events.qsize() > MAX_EVENTS

    def receive(self, context: LaunchContext, fd: int, data: bytes) -> None:
        """Take what the process has written."""
        event_type = ProcessStdout if fd == 1 else ProcessStderr
        details = self._action.process_details
        stream = self._streams[fd]
        if details is not None:
            event = event_type(text=data, **details)
            # Without a handler of it, no event is queued: loud processes would fill the queue for nothing.
            stream.has_events = context.would_handle_event(event)
            if stream.has_events:
                context.emit_event_sync(event)
        self._print(stream, stream.decoder.decode(data))

    def flush(self) -> None:
        """Print the last lines, though they are incomplete."""
        for stream in self._streams.values():
            self._print(stream, stream.decoder.decode(b"", final=True))
            if stream.rest:
                self._print(stream, "\n")

    def _print(self, stream: _Stream, text: str) -> None:
        if self._is_cached:
            stream.cached.append(text)
        # The last part has no line end yet. It waits in `rest` until its line is complete, or too long to wait for.
        *lines, rest = text.split("\n")
        if lines:
            lines[0] = "".join([*stream.rest, lines[0]])
            stream.rest, stream.rest_length = [], 0
        if rest:
            # Parts, because a line may come in single characters, and be long.
            stream.rest.append(rest)
            stream.rest_length += len(rest)
        if stream.rest_length > MAX_LINE_LENGTH:
            lines.append("".join(stream.rest))
            stream.rest, stream.rest_length = [], 0
        log_lines(stream.logger, self._formatted([line.rstrip("\r") for line in lines]))

    def _formatted(self, lines: list[str]) -> list[str]:
        if (around := around_field(self._line_format, "line", {"this": self._action})) is not None:
            before, after = around
            return [f"{before}{line}{after}" for line in lines]
        return [self._line_format.format(line=line, this=self._action) for line in lines]
