"""The severities of log records."""

from __future__ import annotations

from enum import IntEnum

__all__ = ["LoggingSeverity"]


class LoggingSeverity(IntEnum):
    """Severity of a log record; the numbers are those of `rcl_interfaces/msg/Log`."""

    UNSET = 0
    DEBUG = 10
    INFO = 20
    WARN = 30
    ERROR = 40
    FATAL = 50
