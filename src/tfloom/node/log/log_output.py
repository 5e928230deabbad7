"""Output of log records: to the console in ROS's format, to a file, and to a node's /rosout."""

from __future__ import annotations

import os
import sys
import threading
import time
from collections.abc import Callable
from enum import IntEnum

from tfloom.common.terminal import is_terminal, shown, shown_name, unescaped
from tfloom.node.log.log_file import LogFile
from tfloom.node.values.duration import S_TO_NS

__all__ = [
    "LoggingSeverity",
    "Record",
    "add_listener",
    "configure",
    "effective_level",
    "get_level",
    "remove_listener",
    "reset_levels",
    "set_level",
    "write",
]


class LoggingSeverity(IntEnum):
    """Severity of a log record; the numbers are those of `rcl_interfaces/msg/Log`."""

    UNSET = 0
    DEBUG = 10
    INFO = 20
    WARN = 30
    ERROR = 40
    FATAL = 50


DEFAULT_FORMAT = "[{severity}] [{time}] [{name}]: {message}"
_COLORS = {
    LoggingSeverity.DEBUG: "\033[32m",
    LoggingSeverity.INFO: "\033[0m",
    LoggingSeverity.WARN: "\033[33m",
    LoggingSeverity.ERROR: "\033[31m",
    LoggingSeverity.FATAL: "\033[31m",
}
_NO_COLOR = "\033[0m"
_ESCAPES = {"\\n": "\n", "\\t": "\t", "\\r": "\r", "\\a": "\a", "\\b": "\b", "\\x1b": "\x1b"}


def _replace_escapes(text: str) -> str:
    for written, meant in _ESCAPES.items():
        text = text.replace(written, meant)
    return text


class Record:
    """One call of a logger."""

    __slots__ = ("file", "function", "line", "message", "name", "severity", "stamp_ns")

    def __init__(
        self, severity: LoggingSeverity, name: str, message: str, file: str, function: str, line: int
    ) -> None:
        self.severity = severity
        self.name = name
        self.message = message
        self.file = file
        self.function = function
        self.line = line
        self.stamp_ns = time.time_ns()

    def format(self, template: str) -> str:
        r"""Return `template` with each known `{token}` replaced by its value; others stay unchanged.

        Known: severity, name, message, time (seconds), time_as_nanoseconds, date_time_with_ms, file_name,
        function_name, line_number. In the template itself, the escape sequences `\n`, `\t`, `\r`, `\a`, `\b` and
        `\x1b` are replaced by their control characters.
        """
        if template == DEFAULT_FORMAT:
            return f"[{self.severity.name}] [{self._seconds()}] [{self.name}]: {self.message}"
        parts: list[str] = []
        rest = template
        while rest:
            before, brace, rest = rest.partition("{")
            parts.append(_replace_escapes(before) if "\\" in before else before)
            if not brace:
                break
            token, end, after = rest.partition("}")
            value = self._token(token) if end else None
            # An unknown token stays as it is, and a known one may begin inside it: go on right behind the brace.
            parts.append("{" if value is None else value)
            rest = rest if value is None else after
        return "".join(parts)

    def shown(self) -> Record:
        """Return this record with the control characters of its message and name shown; itself if it has none."""
        message, name = shown(self.message), shown_name(self.name)
        if message == self.message and name == self.name:
            return self
        safe = Record(self.severity, name, message, self.file, self.function, self.line)
        safe.stamp_ns = self.stamp_ns
        return safe

    def _seconds(self) -> str:
        seconds, rest = divmod(self.stamp_ns, S_TO_NS)
        return f"{seconds}.{rest:09d}"

    def _token(self, token: str) -> str | None:
        if token == "date_time_with_ms":  # noqa: S105  # a token of a format
            stamp = time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(self.stamp_ns // S_TO_NS))
            return f"{stamp}.{self.stamp_ns // 1_000_000 % 1000:03d}"
        tokens = {
            "severity": self.severity.name,
            "name": self.name,
            "message": self.message,
            "time": self._seconds(),
            "time_as_nanoseconds": str(self.stamp_ns),
            "file_name": self.file,
            "function_name": self.function,
            "line_number": str(self.line),
        }
        return tokens.get(token)


_lock = threading.RLock()
"""Guards changes of the names below; records are written without it, from the values at that moment."""
_levels: dict[str, LoggingSeverity] = {"": LoggingSeverity.INFO}
_effective: dict[str, LoggingSeverity] = {}
_file: LogFile | None = None
_to_console = True
_listeners: dict[str, list[Callable[[Record], None]]] = {}


def set_level(name: str, level: LoggingSeverity) -> None:
    """Set the level of a name and of all below it that have no level; "" is the root."""
    with _lock:
        if level is LoggingSeverity.UNSET:
            _levels.pop(name, None)
        else:
            _levels[name] = level
        _effective.clear()


def get_level(name: str) -> LoggingSeverity:
    """Return the level set for exactly this name; UNSET if there is none."""
    return _levels.get(name, LoggingSeverity.UNSET)


def effective_level(name: str) -> LoggingSeverity:
    """Return the level of the nearest name, from `name` upwards, that has one."""
    level = _effective.get(name)
    if level is not None:
        return level
    with _lock:
        at = name
        while at and at not in _levels:
            at = at.rpartition(".")[0]
        level = _effective[name] = _levels.get(at, LoggingSeverity.INFO)
        return level


def reset_levels() -> None:
    """Remove all levels that were set."""
    with _lock:
        _levels.clear()
        _effective.clear()
        _levels[""] = LoggingSeverity.INFO


def _reset_in_forked_child() -> None:
    """In a forked child, drop the parent's listeners, and locks that a thread of the parent may have held."""
    global _lock, _listeners
    _lock, _listeners = threading.RLock(), {}
    if _file is not None:
        _file.reset_in_forked_child()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_reset_in_forked_child)


def configure(*, file: LogFile | None, console: bool) -> None:
    """Set the log file (None: no file) and whether records are written to the console."""
    global _file, _to_console  # the process has one of each
    with _lock:
        if _file is not None:
            _file.close()
        _file, _to_console = file, console


def add_listener(name: str, listener: Callable[[Record], None]) -> None:
    """Call `listener` with each record of a logger and of the loggers below it, on the thread that logs."""
    with _lock:
        _listeners[name] = [*_listeners.get(name, ()), listener]


def remove_listener(name: str, listener: Callable[[Record], None]) -> None:
    """Undo one `add_listener`."""
    with _lock:
        listeners = [other for other in _listeners.get(name, ()) if other != listener]
        if listeners:
            _listeners[name] = listeners
        else:
            _listeners.pop(name, None)


def _use_color(on_terminal: bool) -> bool:
    wish = os.environ.get("RCUTILS_COLORIZED_OUTPUT", "")
    return wish == "1" if wish in ("0", "1") else on_terminal


def write(record: Record) -> None:
    """Write a record to the console and the log file, and call the listeners of its name."""
    template = os.environ.get("RCUTILS_CONSOLE_OUTPUT_FORMAT") or DEFAULT_FORMAT
    text = record.format(template)
    if _to_console:
        _print(record, template, text)
    file = _file
    if file is not None:
        file.write(text)
    # Each logger passes its records on to those above it: for `a.b`, the listeners of `a.b` and then of `a`.
    name = record.name
    while name and _listeners:
        for listener in _listeners.get(name, ()):
            listener(record)
        name = name.rpartition(".")[0]


def _print(record: Record, template: str, text: str) -> None:
    """Write `text`, the formatted record, to the console.

    On a terminal, control characters in the message and the name are shown; those of the template are obeyed.
    """
    stream = sys.stdout if os.environ.get("RCUTILS_LOGGING_USE_STDOUT") == "1" else sys.stderr
    if stream is None:
        return
    try:
        on_terminal = is_terminal(stream)
        if on_terminal:
            stream = unescaped(stream)
            if (safe := record.shown()) is not record:
                text = safe.format(template)
        if _use_color(on_terminal):
            text = f"{_COLORS.get(record.severity, '')}{text}{_NO_COLOR}"
        stream.write(f"{text}\n")
        stream.flush()
    except (OSError, ValueError):
        pass  # a closed or broken stream: there is no other output to report that on
