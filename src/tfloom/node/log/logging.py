"""Loggers by name, their levels, and the folder of log files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.node.log import log_output
from tfloom.node.log.log_file import log_directory
from tfloom.node.log.log_output import LoggingSeverity
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


_root_logger = RcutilsLogger()
"""The root's logger, by rclpy's name."""


def get_logger(name: str) -> RcutilsLogger:
    """Return the logger of a name.

    Raises:
        ValueError: the name is empty.
    """
    if not name:
        raise ValueError("Logger name must not be empty.")
    return RcutilsLogger(name)


def initialize() -> None:
    """Do nothing, because loggers work from the first import."""


def shutdown() -> None:
    """Do nothing, because each record is written at once."""


def clear_config() -> None:
    """Remove all levels that were set."""
    log_output.reset_levels()


def set_logger_level(name: str, level: LoggingSeverity | int, detailed_error: bool = False) -> None:
    """Set the level of a logger; UNSET: the level of the nearest name above it that has one.

    Raises:
        ValueError: `level` is not a severity.
    """
    log_output.set_level(name, LoggingSeverity(level))


def get_logger_level(name: str) -> LoggingSeverity:
    """Return the level set for a logger; UNSET if there is none."""
    return log_output.get_level(name)


def get_logger_effective_level(name: str) -> LoggingSeverity:
    """Return the least severity that a logger logs."""
    return log_output.effective_level(name)


def get_logging_severity_from_string(log_severity: str) -> LoggingSeverity:
    """Return the severity of a name such as `info`, in upper or lower case.

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
    """Return the folder of log files: `ROS_LOG_DIR`, else `log` in `ROS_HOME`, else `~/.ros/log`."""
    return log_directory()
