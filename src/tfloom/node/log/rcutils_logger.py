"""The logger class that `Node.get_logger()` returns, and warnings of limited rate."""

from __future__ import annotations

import math
import sys
import time
import warnings
from typing import Any

from tfloom.node.log import log_output
from tfloom.node.log.log_output import LoggingSeverity, Record
from tfloom.node.log.logging_filters import CallerId, CallState, FilterTable, options_error, place_of
from tfloom.ros_imports import ros_distro

__all__ = ["CallerId", "RcutilsLogger", "ThrottledWarning"]


_filters_of_all = FilterTable()
"""The filters of loggers that are of no node."""
WARNING_PERIOD_S = 1.0
"""The least time between two warnings [s]."""


class RcutilsLogger:
    """Logs records under a name. Without its own level it has that of the nearest name above it, up to the root.

    Each of `debug`, `info`, `warning`, `error` and `fatal` takes these options, which belong to the place of the
    call and to the name, also where each call fetches its own logger, as by `get_child`:

    - `once=True`: only the first call is logged;
    - `skip_first=True`: all but the first;
    - `throttle_duration_sec=t`: at most one each t seconds, by the Clock `throttle_time_source_type` if given,
      else by a steady one.

    Args:
        name: Names of nested loggers are joined by dots.
        filters: What is remembered of the calls with options, by this logger and others; None: by all loggers that are
            of no node. A node has its own table, so that the next one of its name begins anew.
    """

    def __init__(self, name: str = "", filters: FilterTable | None = None) -> None:
        self.name = name
        self._filters = _filters_of_all if filters is None else filters
        self._states: dict[CallerId, CallState] = {}
        """How this logger was called with options, by place."""

    def get_child(self, name: str) -> RcutilsLogger:
        """Return the logger `<name of this one>.<name>`.

        Raises:
            ValueError: `name` is empty.
        """
        if not name:
            raise ValueError("Child logger name must not be empty.")
        return RcutilsLogger(f"{self.name}.{name}" if self.name else name, self._filters)

    def set_level(self, level: LoggingSeverity | int) -> None:
        """Set the least severity to log; UNSET: that of the nearest name above that has a level.

        Raises:
            ValueError: there is no such severity.
        """
        try:
            severity = LoggingSeverity(level)
        except ValueError as error:
            names = ", ".join(known.name for known in LoggingSeverity)
            raise ValueError(f"{error}: write LoggingSeverity.NAME, with a name of {names}") from None
        log_output.set_level(self.name, severity)

    def get_effective_level(self) -> LoggingSeverity:
        """Return the least severity that is logged."""
        return log_output.effective_level(self.name)

    def is_enabled_for(self, severity: LoggingSeverity | int) -> bool:
        """Return whether records of this severity are logged."""
        return severity >= log_output.effective_level(self.name)

    def log(self, message: object, severity: LoggingSeverity | int, **kwargs: Any) -> bool:
        """Log `message` at `severity`.

        Returns:
            Whether it was logged: not filtered out, and severe enough.

        Raises:
            TypeError: an option is unknown or misused.
            ValueError: the call has options, and the same place has logged with another severity or other options.
        """
        return self._log(message, LoggingSeverity(severity), kwargs)

    def debug(self, message: object, **kwargs: Any) -> bool:
        """Log at DEBUG, as `log` does."""
        return self._log(message, LoggingSeverity.DEBUG, kwargs)

    def info(self, message: object, **kwargs: Any) -> bool:
        """Log at INFO, as `log` does."""
        return self._log(message, LoggingSeverity.INFO, kwargs)

    def warning(self, message: object, **kwargs: Any) -> bool:
        """Log at WARN, as `log` does."""
        return self._log(message, LoggingSeverity.WARN, kwargs)

    def error(self, message: object, **kwargs: Any) -> bool:
        """Log at ERROR, as `log` does."""
        return self._log(message, LoggingSeverity.ERROR, kwargs)

    def fatal(self, message: object, **kwargs: Any) -> bool:
        """Log at FATAL, as `log` does."""
        return self._log(message, LoggingSeverity.FATAL, kwargs)

    def warn(self, message: object, **kwargs: Any) -> bool:
        """Log at WARN, as `log` does; from Kilted on, warn that the method is deprecated."""
        if ros_distro.LOGGER_WARN_IS_DEPRECATED:
            warnings.warn(
                "Deprecated in favor of :py:classmethod:RcutilsLogger.warning:.",
                DeprecationWarning,
                stacklevel=2,
            )
        return self._log(message, LoggingSeverity.WARN, kwargs)

    def _log(self, message: object, severity: LoggingSeverity, options: dict[str, Any]) -> bool:
        if severity < log_output.effective_level(self.name):
            return False  # and the place doesn't count as called
        frame = sys._getframe(2)  # the caller of info() and the like
        name = options.pop("name", self.name) if options else self.name
        if options:
            if (error := options_error(options)) is not None:
                raise error
            caller = CallerId(frame.f_code, frame.f_lineno, frame.f_lasti)
            state = self._states.get(caller)
            if state is None:
                place = place_of(caller, severity, name, options)
                state = self._states[caller] = CallState(self._filters, place, options)
            else:
                state.check_unchanged(severity, name, options)
            if severity < log_output.effective_level(name) or not state.lets_through():
                return False
        log_output.write(
            Record(
                severity,
                name,
                str(message),
                frame.f_code.co_filename,
                frame.f_code.co_name,
                frame.f_lineno,
            )
        )
        return True


class ThrottledWarning:
    """Logs at most one warning each `WARNING_PERIOD_S`, and drops the others."""

    def __init__(self, logger: RcutilsLogger) -> None:
        self._logger = logger
        self._last_s = -math.inf

    def log(self, text: str) -> None:
        """Log a warning, unless the last one is less than `WARNING_PERIOD_S` ago."""
        now_s = time.monotonic()
        if now_s - self._last_s >= WARNING_PERIOD_S:
            self._last_s = now_s
            self._logger.warning(text)
