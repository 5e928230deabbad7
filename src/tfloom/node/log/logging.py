"""Loggers by name, their levels, and where log files go."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.node.log import log_output
from tfloom.node.log.log_file import log_directory
from tfloom.node.log.logging_severity import LoggingSeverity
from tfloom.node.log.rcutils_logger import RcutilsLogger

if TYPE_CHECKING:
    from pathlib import Path

__all__ = [
    "LoggingSeverity",
    "clear_config",
    "get_logger",
    "get_logger_effective_level",
    "get_logger_level",
    "get_logging_directory",
    "get_logging_severity_from_string",
    "initialize",
    "set_logger_level",
    "shutdown",
]


def get_logger(name: str) -> RcutilsLogger:
    """Return the logger of a name.

    Raises:
        ValueError: the name is empty.
    """
    if not name:
        raise ValueError("Logger name must not be empty.")
    return RcutilsLogger(name)


def initialize() -> None:
    """Nothing to do: loggers work from the first import. Programs that call it may go on to."""


def shutdown() -> None:
    """Nothing to do, as for `initialize`: each record is written through at once."""


def clear_config() -> None:
    """Forget all levels that were set."""
    log_output.reset_levels()


def set_logger_level(name: str, level: LoggingSeverity | int, detailed_error: bool = False) -> None:  # noqa: ARG001
    """Set the level of a logger; UNSET takes the level of the names above it again.

    Raises:
        ValueError: `level` is no severity.
    """
    log_output.set_level(name, LoggingSeverity(level))


def get_logger_level(name: str) -> LoggingSeverity:
    """Return the level that was set for a logger, UNSET if none was."""
    return log_output.get_level(name)


def get_logger_effective_level(name: str) -> LoggingSeverity:
    """Return the least severity that a logger logs."""
    return log_output.effective_level(name)


def get_logging_severity_from_string(log_severity: str) -> LoggingSeverity:
    """Return the severity of a name such as `info`, in any case.

    Raises:
        RuntimeError: there is none of that name.
    """
    try:
        return LoggingSeverity[log_severity.upper()]
    except KeyError:
        names = ", ".join(severity.name for severity in LoggingSeverity)
        raise RuntimeError(
            f"failed to get severity from string '{log_severity}': known are {names}"
        ) from None


def get_logging_directory() -> Path:
    """Return where log files go: `ROS_LOG_DIR`, else `log` in `ROS_HOME`, else `~/.ros/log`."""
    return log_directory()
