"""The handlers of the standard library, each with a format for single loggers: `launch.logging.handlers`."""

from __future__ import annotations

import logging
import logging.handlers as standard
from typing import TYPE_CHECKING, Any

__all__ = [
    "BufferingHandler",
    "DatagramHandler",
    "FileHandler",
    "HTTPHandler",
    "Handler",
    "MemoryHandler",
    "NullHandler",
    "QueueHandler",
    "RotatingFileHandler",
    "SMTPHandler",
    "SocketHandler",
    "StreamHandler",
    "SysLogHandler",
    "TimedRotatingFileHandler",
    "WatchedFileHandler",
]


class _FormatsByLogger(logging.Handler):
    """A handler that formats the records of some loggers otherwise than those of the others."""

    def _formatters(self) -> dict[str, logging.Formatter]:
        """Return the formatters by the names of their loggers."""
        formatters: dict[str, logging.Formatter] = self.__dict__.setdefault("formatters_by_logger", {})
        return formatters

    def setFormatterFor(self, logger: logging.Logger, formatter: logging.Formatter) -> None:
        """Set the formatter of a logger's records."""
        self._formatters()[logger.name] = formatter

    def unsetFormatterFor(self, logger: logging.Logger) -> None:
        """Format a logger's records as those of others again."""
        self._formatters().pop(logger.name, None)

    def getFormatterFor(self, logger: logging.Logger) -> logging.Formatter | None:
        """Return the formatter of a logger's records, or that of all loggers."""
        return self._formatters().get(logger.name, self.formatter)

    def format(self, record: logging.LogRecord) -> str:
        """Return the text of a record."""
        formatter = self._formatters().get(record.name)
        return super().format(record) if formatter is None else formatter.format(record)


if TYPE_CHECKING:
    _Stream = logging.StreamHandler[Any]
    _Queue = standard.QueueHandler
else:
    _Stream, _Queue = logging.StreamHandler, standard.QueueHandler


class Handler(_FormatsByLogger):
    """The base of handlers of one's own: see `logging.Handler`."""


class BufferingHandler(_FormatsByLogger, standard.BufferingHandler):
    """Collects records: see `logging.handlers.BufferingHandler`."""


class DatagramHandler(_FormatsByLogger, standard.DatagramHandler):
    """Sends records as datagrams: see `logging.handlers.DatagramHandler`."""


class FileHandler(_FormatsByLogger, logging.FileHandler):
    """Writes to a file: see `logging.FileHandler`."""


class HTTPHandler(_FormatsByLogger, standard.HTTPHandler):
    """Sends records to a web server: see `logging.handlers.HTTPHandler`."""


class MemoryHandler(_FormatsByLogger, standard.MemoryHandler):
    """Collects records for another handler: see `logging.handlers.MemoryHandler`."""


class NullHandler(_FormatsByLogger, logging.NullHandler):
    """Does nothing: see `logging.NullHandler`."""


class QueueHandler(_FormatsByLogger, _Queue):
    """Puts records into a queue: see `logging.handlers.QueueHandler`."""


class RotatingFileHandler(_FormatsByLogger, standard.RotatingFileHandler):
    """Writes to files of a limited length: see `logging.handlers.RotatingFileHandler`."""


class SMTPHandler(_FormatsByLogger, standard.SMTPHandler):
    """Sends records as e-mails: see `logging.handlers.SMTPHandler`."""


class SocketHandler(_FormatsByLogger, standard.SocketHandler):
    """Sends records over TCP: see `logging.handlers.SocketHandler`."""


class StreamHandler(_FormatsByLogger, _Stream):
    """Writes to a stream: see `logging.StreamHandler`."""


class SysLogHandler(_FormatsByLogger, standard.SysLogHandler):
    """Sends records to the system log: see `logging.handlers.SysLogHandler`."""


class TimedRotatingFileHandler(_FormatsByLogger, standard.TimedRotatingFileHandler):
    """Begins another file from time to time: see `logging.handlers.TimedRotatingFileHandler`."""


class WatchedFileHandler(_FormatsByLogger, standard.WatchedFileHandler):
    """Writes to a file, anew where another program has moved it: see `logging.handlers.WatchedFileHandler`."""
