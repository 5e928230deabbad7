"""The handlers of a launch's logs: lines on the screen and in files, written in the background while a launch runs."""

from __future__ import annotations

import contextlib
import io
import logging
import os
import select
import sys
import weakref
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tfloom.common.terminal import is_terminal, report, shown, shown_in_colors, unescaped
from tfloom.launch.logs.background_writing import SCREEN, background_writing
from tfloom.launch.logs.terminal_colors import colors_of

__all__ = [
    "BraceFormatter",
    "FileHandler",
    "StdoutHandler",
    "around_field",
    "close_handler",
    "is_behind",
    "log_lines",
]


def around_field(text: str, name: str, values: Mapping[str, Any]) -> tuple[str, str] | None:
    """Return what a format writes before and after a field, which is faster than to format it for each line.

    None if the field is not there once and plainly, as `{name}`, or another one is not in `values`.
    """
    before, field, after = text.partition(f"{{{name}}}")
    if not field or name in before + after or before.endswith("{") or after.startswith("}"):
        return None
    try:
        return before.format(**values), after.format(**values)
    except (KeyError, ValueError, IndexError, AttributeError):
        return None


class BraceFormatter(logging.Formatter):
    """Formats by `str.format`, with the colors of the level and of the process if the stream is a terminal."""

    def __init__(self, text: str, stream: Any = None) -> None:
        super().__init__(text, style="{")
        self._text = text.replace("{message}", "{msg}")  # the same here, and looked for in one form
        self._has_time = "{asctime" in text
        self._colors = colors_of(stream)

    def around_message(self, record: logging.LogRecord) -> tuple[str, str] | None:
        """Return what stands before and after the message of each line; None if that depends on the line."""
        if self._has_time:
            return None
        return around_field(self._text, "msg", record.__dict__)

    def colored(self, line: str, level: str, name: str) -> str:
        """Return a line with the colors of its level and logger, if the stream is a terminal."""
        return self._colors(line, level, name) if self._colors else line

    def format(self, record: logging.LogRecord) -> str:
        """Return the line of a record."""
        message = record.getMessage()
        values = {**record.__dict__, "msg": message, "message": message}
        if self._has_time:
            values["asctime"] = self.formatTime(record)
        try:
            line = self._text.format(**values)
        except (KeyError, ValueError, IndexError):
            line = f"{record.levelname} {record.name}: {message}"
        if record.exc_info:
            line += "\n" + self.formatException(record.exc_info)
        return self.colored(line, record.levelname, record.name)


if TYPE_CHECKING:
    _StreamHandler = logging.StreamHandler[Any]
else:
    _StreamHandler = logging.StreamHandler  # Python 3.10 has no subscript of it


class StdoutHandler(_StreamHandler):
    """Writes on the `sys.stdout` of the moment, which tests and notebooks replace."""

    destination = SCREEN

    def __init__(self) -> None:
        super().__init__(sys.stdout)

    def emit(self, record: logging.LogRecord) -> None:
        """Write a record at once, or hand it over while a launch runs."""
        self.emit_lines(record, None)

    def emit_lines(self, record: logging.LogRecord, lines: Sequence[str] | None) -> None:
        """Write the lines of a process, each with the attributes of `record`; None: the record itself."""
        self.stream = unescaped(sys.stdout)
        if self.stream is None:
            return
        try:
            # Formatted on this thread, because the record is used again for the next line and the next handler. Written
            # by the writer's thread if a launch runs and there is a descriptor; otherwise here.
            text = _formatted_text(self, record, lines)
            descriptor = _descriptor(self.stream)
            writer = None if descriptor is None else background_writing.writer(SCREEN)
            if descriptor is None or writer is None:
                self.stream.write(text)
                self.flush()
            else:
                stream = self.stream
                writer.put(
                    lambda piece: self._write(record, stream, descriptor, piece),
                    text,
                    is_droppable=lines is not None,
                )
        except Exception:
            self.handleError(record)

    def _write(self, record: logging.LogRecord, stream: Any, descriptor: int, text: str) -> None:
        """Write on the writer's thread.

        Not by `stream.write`, which would hold the stream's lock for as long as the screen takes nothing, and Python
        takes that lock at its end.
        """
        try:
            data = memoryview(text.encode(stream.encoding, stream.errors or "strict"))
            while data:  # a pipe may take a part only
                data = data[os.write(descriptor, data) :]
        except Exception:
            self.handleError(record)

    def handleError(self, record: logging.LogRecord) -> None:
        """Print one line on stderr, once, if stdout can't be written."""
        if not _is_file_error(self, "stdout"):
            super().handleError(record)

    def format(self, record: logging.LogRecord) -> str:
        """Return the line of a record; on a terminal, colors are the only control sequences in it."""
        lines = super().format(record)
        if not is_terminal(self.stream):
            return lines
        return "\n".join(map(shown_in_colors, lines.split("\n")))


class FileHandler(logging.FileHandler):
    """Writes to a log file."""

    @property
    def destination(self) -> str:
        """Path of the file, which is the name of its background writer."""
        return self.baseFilename

    def emit(self, record: logging.LogRecord) -> None:
        """Write a record at once, or hand it over while a launch runs."""
        self.emit_lines(record, None)

    def emit_lines(self, record: logging.LogRecord, lines: Sequence[str] | None) -> None:
        """Write the lines of a process, each with the attributes of `record`; None: the record itself."""
        try:
            text = _formatted_text(self, record, lines)
            writer = background_writing.writer(self.baseFilename)
            if writer is None:
                self._write(record, text)
            else:
                writer.put(lambda piece: self._write(record, piece), text, is_droppable=lines is not None)
        except Exception:
            self.handleError(record)

    def _write(self, record: logging.LogRecord, text: str) -> None:
        try:
            if self.stream is None:  # it was closed
                self.stream = self._open()
            self.stream.write(text)
            self.stream.flush()
        except Exception:
            self.handleError(record)

    def handleError(self, record: logging.LogRecord) -> None:
        """Print one line on stderr, once, if the file can't be written."""
        if not _is_file_error(self, self.baseFilename):
            super().handleError(record)


_OWN_HANDLERS = (StdoutHandler, FileHandler)


def _formatted_text(handler: logging.Handler, record: logging.LogRecord, lines: Sequence[str] | None) -> str:
    """Return what a handler writes of a record, or of lines of a process.

    Short lines come by the ten thousand, in one part of a process's output: what is equal in all of them is found once.
    """
    if lines is None:
        return handler.format(record) + "\n"
    formatter = handler.formatter
    if not isinstance(formatter, BraceFormatter) or (around := formatter.around_message(record)) is None:
        return "".join(_format_line(handler, record, line) for line in lines)
    # What stands around the message is the same in all lines. A terminal needs more for each line: its color, and no
    # control sequences of the process.
    before, after = around
    if isinstance(handler, StdoutHandler) and is_terminal(handler.stream):
        text = "\n".join(lines)
        if "\x1b" in text:  # their own colors, which end with each line
            return "".join(_format_line(handler, record, line) for line in lines)
        level, name = record.levelname, record.name
        return "".join(
            formatter.colored(f"{before}{line}{after}", level, name) + "\n"
            for line in shown(text).split("\n")
        )
    return f"{before}{(after + chr(10) + before).join(lines)}{after}\n"


def _format_line(handler: logging.Handler, record: logging.LogRecord, line: str) -> str:
    record.msg = line
    return handler.format(record) + "\n"


def _descriptor(stream: Any) -> int | None:
    """Return the descriptor that stands behind a stream; None if it is another kind of stream, or on Windows."""
    buffer = getattr(stream, "buffer", None)
    raw = getattr(buffer, "raw", buffer)
    if os.name == "nt" or not isinstance(stream, io.TextIOWrapper) or not isinstance(raw, io.FileIO):
        return None  # a notebook's, or one of a test: they take all at once, and on Windows line ends are translated
    # What was printed before stands before. A screen that takes nothing now may keep this for ever.
    if select.select([], [raw], [], 0.0)[1]:
        stream.flush()
    return raw.fileno()


_failed_handlers: weakref.WeakSet[logging.Handler] = weakref.WeakSet()
"""Handlers whose files could not be written: the next line says no more. Two of them may have the same file."""


def _is_file_error(handler: logging.Handler, name: str) -> bool:
    """Return whether the error that is handled is one of the file; print it if it is the first one."""
    error = sys.exc_info()[1]
    if not isinstance(error, OSError):
        return False
    # After `| head -1` nobody reads stdout any more, and the log files have every line.
    is_told = any(
        other is handler or getattr(other, "baseFilename", None) == name for other in _failed_handlers
    )
    if not isinstance(error, BrokenPipeError) and not is_told:
        _failed_handlers.add(handler)
        report(f"[launch]: lines of {name} are lost: {error.strerror}")
    return True


def close_handler(handler: logging.Handler, name: str) -> None:
    """Close the handler of a file; print one line on stderr, once, if what it has left can't be written."""
    try:
        handler.close()
    except OSError:
        _is_file_error(handler, getattr(handler, "baseFilename", name))


def log_lines(logger: logging.Logger, lines: Sequence[str]) -> None:
    """Log lines of a process.

    The launch's own handlers write them together, because a record for each line takes longer than a loud process needs
    to write it. Those of users get a record for each.
    """
    if not lines or not logger.isEnabledFor(logging.INFO):
        return
    # The short way is taken only if nobody could tell the difference: no filter, which may change a record, no handler
    # of a user's, here or at a parent logger, and no level that leaves lines out.
    is_plain = not logger.filters and not logger.propagate
    own = [
        handler
        for handler in logger.handlers
        if is_plain
        and isinstance(handler, _OWN_HANDLERS)
        and not handler.filters
        and handler.level <= logging.INFO
    ]
    if len(own) < len(logger.handlers) or not is_plain:
        for line in lines:
            logger.info("%s", line)
        return
    record = logger.makeRecord(logger.name, logging.INFO, "", 0, "", (), None)
    # In place of `Handler.handle`, which takes this lock, and checks the filters: there are none.
    for handler in own:
        with handler.lock or contextlib.nullcontext():
            handler.emit_lines(record, lines)


def is_behind(logger: logging.Logger) -> bool:
    """Return whether the screen or a log file of a process has more to write than it should: its output waits."""
    return any(
        isinstance(handler, _OWN_HANDLERS) and background_writing.is_behind(handler.destination)
        for handler in logger.handlers
    )
