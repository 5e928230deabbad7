"""Logs of a launch: on the screen, in the launch's log folder, and a process's own files."""

from __future__ import annotations

import logging
import os
import sys
import time
from collections.abc import Callable, Mapping
from datetime import datetime
from pathlib import Path
from typing import Any, Union

from tfloom.launch.log_handlers import BraceFormatter, FileHandler, StdoutHandler

__all__ = [
    "LaunchConfig",
    "LaunchLogger",
    "OutputConfig",
    "get_logger",
    "get_output_loggers",
    "launch_config",
    "log_launch_config",
    "reset",
]

OutputConfig = Union[str, Mapping[str, Any]]
"""Where a process's output goes: a name in OUTPUTS, or a dictionary like one of those in it."""

OUTPUTS: dict[str, dict[str, set[str]]] = {
    "screen": {"both": {"screen"}},
    "log": {"stdout": {"log"}, "stderr": {"log", "screen"}},
    "both": {"both": {"log", "screen"}},
    "own_log": {"stdout": {"own_log"}, "stderr": {"own_log"}, "both": {"own_log"}},
    "full": {"stdout": {"own_log"}, "stderr": {"own_log"}, "both": {"screen", "log", "own_log"}},
}

STAMPED = "{created:.7f} [{levelname}] [{name}]: {msg}"
SCREEN_FORMATS = {"default": "[{levelname}] [{name}]: {msg}", "default_with_timestamp": STAMPED}
LOG_FORMATS = {"default": STAMPED}
LINE_FORMAT = "{msg}"
"""Of a process's output, whose prefix is part of the line."""

MAX_FOLDERS = 1000
"""Attempts to create a log folder with a new name."""


class LaunchLogger(logging.Logger):
    """A logger of the launch, or of a process's output."""

    all_loggers: dict[str, LaunchLogger] = {}  # noqa: RUF012  # by name, as a public attribute of the class

    def setLevel(self, level: int | str) -> None:  # noqa: N802  # of the base class
        """Set the level below which nothing is logged."""
        super().setLevel(level)
        self._cache.clear()  # type: ignore[attr-defined]  # the base class clears those of its own loggers only


def _file_handler(path: str) -> logging.Handler:
    return FileHandler(path, encoding="utf-8")


class LaunchConfig:
    """Where and how a launch logs. There is one, `launch_config`."""

    def __init__(self) -> None:
        self._loggers: list[logging.Logger] = []
        self.reset()

    def reset(self) -> None:
        """Return to what the environment variables say, with a new log folder."""
        self._log_dir: str | None = None
        self._file_handlers: dict[str, logging.Handler] = {}
        self._screen: dict[str, logging.Handler] = {}
        self.level = logging.INFO
        self.log_handler_factory: Callable[[str], logging.Handler] = _file_handler
        self.set_screen_format(os.environ.get("OVERRIDE_LAUNCH_SCREEN_FORMAT", "default"))
        self.set_log_format(os.environ.get("OVERRIDE_LAUNCH_LOG_FORMAT", "default"))

    @property
    def level(self) -> int:
        """Level below which nothing is logged; new loggers have it."""
        return self._level

    @level.setter
    def level(self, level: int | str) -> None:
        self._level = level if isinstance(level, int) else logging.getLevelName(level.upper())
        for logger in self._loggers:
            logger.setLevel(self._level)

    @property
    def log_dir(self) -> str:
        """Folder of this launch's log files, created at the first use.

        Raises:
            ValueError: (on setting) it is another one already.
        """
        if self._log_dir is None:
            self._log_dir = _create_log_dir()
        return self._log_dir

    @log_dir.setter
    def log_dir(self, log_dir: str) -> None:
        if self._log_dir is not None and self._log_dir != log_dir:
            raise ValueError(f"Cannot set log directory to '{log_dir}': it is '{self._log_dir}' already")
        path = Path(log_dir).expanduser()
        path.mkdir(parents=True, exist_ok=True)
        self._log_dir = str(path)

    def set_screen_format(self, screen_format: str, *, screen_style: str | None = None) -> None:
        """Set the format of lines on the screen: "default", "default_with_timestamp", or a format of `str.format`."""
        self.screen_format = SCREEN_FORMATS.get(screen_format, screen_format)
        self._screen.clear()

    def set_log_format(self, log_format: str, *, log_style: str | None = None) -> None:
        """Set the format of lines in log files: "default", or a format of `str.format`."""
        self.log_format = LOG_FORMATS.get(log_format, log_format)

    def get_log_file_path(self, file_name: str = "launch.log") -> str:
        """Return the path of a file in the log folder."""
        return str(Path(self.log_dir) / file_name)

    def get_screen_handler(self, *, lines: bool = False) -> logging.Handler:
        """Return the handler that writes on the screen; `lines` are those of processes."""
        name = "lines" if lines else "records"
        if name not in self._screen:
            handler = StdoutHandler()
            handler.setFormatter(BraceFormatter(LINE_FORMAT if lines else self.screen_format, sys.stdout))
            self._screen[name] = handler
        return self._screen[name]

    def get_log_file_handler(self, file_name: str = "launch.log", *, lines: bool = False) -> logging.Handler:
        """Return the handler that writes to a file in the log folder."""
        key = f"{file_name}{'/lines' if lines else ''}"
        if key not in self._file_handlers:
            handler = self.log_handler_factory(self.get_log_file_path(file_name))
            is_own = file_name != "launch.log"
            text = LINE_FORMAT if is_own else "{created:.7f} {msg}" if lines else self.log_format
            handler.setFormatter(BraceFormatter(text))
            self._file_handlers[key] = handler
        return self._file_handlers[key]

    def add_logger(self, logger: logging.Logger) -> None:
        """Make `level` that of a logger, too."""
        if logger not in self._loggers:
            self._loggers.append(logger)
            logger.setLevel(self._level)

    def close(self) -> None:
        """Close the log files, and remove the handlers of all loggers."""
        for handler in self._file_handlers.values():
            handler.close()
        for logger in self._loggers:
            logger.handlers.clear()


launch_config = LaunchConfig()


def get_logger(name: str | None = None) -> logging.Logger:
    """Return the logger of a name ("launch", "launch.user", a process): it writes on the screen and to launch.log."""
    logger = LaunchLogger.all_loggers.get(name or "")
    if logger is None:
        logger = LaunchLogger(name or "root")
        LaunchLogger.all_loggers[name or ""] = logger
    if not logger.handlers:
        launch_config.add_logger(logger)
        logger.propagate = False
        logger.addHandler(_DeferredHandler(launch_config.get_screen_handler))
        logger.addHandler(_DeferredHandler(launch_config.get_log_file_handler))
    return logger


def get_output_loggers(
    process_name: str, output_config: OutputConfig
) -> tuple[logging.Logger, logging.Logger]:
    """Return the loggers of a process's stdout and stderr.

    Args:
        process_name: Its name; the loggers are `<name>-stdout` and `<name>-stderr`.
        output_config: "screen", "log", "both", "own_log", "full", or a dictionary: see OutputConfig.

    Raises:
        ValueError: the output is none of them.
    """
    sinks = _sinks(process_name, output_config)
    loggers = []
    for stream in ("stdout", "stderr"):
        name = f"{process_name}-{stream}"
        logger = LaunchLogger.all_loggers.setdefault(name, LaunchLogger(name))
        logger.handlers.clear()
        launch_config.add_logger(logger)
        logger.propagate = False
        if "screen" in sinks[stream] | sinks["both"]:
            logger.addHandler(launch_config.get_screen_handler(lines=True))
        if "log" in sinks[stream] | sinks["both"]:
            logger.addHandler(launch_config.get_log_file_handler(lines=True))
        if "own_log" in sinks[stream]:
            logger.addHandler(launch_config.get_log_file_handler(f"{name}.log"))
        if "own_log" in sinks["both"]:
            logger.addHandler(launch_config.get_log_file_handler(f"{process_name}.log"))
        loggers.append(logger)
    return loggers[0], loggers[1]


def log_launch_config(*, logger: logging.Logger) -> None:
    """Log where the log files are, and the level."""
    if launch_config.level <= logging.INFO:
        logger.info("All log files can be found below %s", launch_config.log_dir)
        logger.info("Default logging verbosity is set to %s", logging.getLevelName(launch_config.level))


def reset() -> None:
    """Close the log files, and begin anew with the next launch."""
    launch_config.close()
    launch_config.reset()


class _DeferredHandler(logging.Handler):
    """Passes records on to a handler that exists from the first record on: most commands log nothing."""

    def __init__(self, make: Callable[[], logging.Handler]) -> None:
        super().__init__()
        self._make = make

    def emit(self, record: logging.LogRecord) -> None:
        """Pass a record on."""
        self._make().handle(record)


def _sinks(process_name: str, output_config: OutputConfig) -> dict[str, set[str]]:
    config: Mapping[str, Any]
    if isinstance(output_config, str):
        if output_config not in OUTPUTS:
            raise ValueError(
                f"'{output_config}' is not a valid standard output config for '{process_name}': "
                f"use one of {', '.join(OUTPUTS)}"
            )
        config = OUTPUTS[output_config]
    else:
        config = output_config
    sinks: dict[str, set[str]] = {"stdout": set(), "stderr": set(), "both": set()}
    for stream, where in config.items():
        if stream not in sinks:
            raise ValueError(f"'{stream}' is no output of '{process_name}': use stdout, stderr or both")
        names = {where} if isinstance(where, str) else set(where)
        if wrong := names - {"screen", "log", "own_log"}:
            raise ValueError(
                f"{', '.join(sorted(map(str, wrong)))} is no place for the output of '{process_name}': "
                "use screen, log or own_log"
            )
        sinks[stream] |= names
    return sinks


def _create_log_dir() -> str:
    """Create `<root>/<time>-<host>-<pid>` under ROS_LOG_DIR, else ROS_HOME/log, else ~/.ros/log."""
    import socket  # which printing the arguments of a file does not need

    environment = os.environ
    if environment.get("ROS_LOG_DIR"):
        root = Path(environment["ROS_LOG_DIR"]).expanduser()
    else:
        root = Path(environment.get("ROS_HOME") or "~/.ros").expanduser() / "log"
    try:
        root.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        error.strerror = (
            f"{error.strerror}: no folder for the logs; set ROS_LOG_DIR to one that can be written"
        )
        raise
    for _ in range(MAX_FOLDERS):
        stamp = datetime.now().astimezone().strftime("%Y-%m-%d-%H-%M-%S-%f")
        folder = root / f"{stamp}-{socket.gethostname()}-{os.getpid()}"
        try:
            folder.mkdir()
        except FileExistsError:
            time.sleep(1e-4)
        else:
            return str(folder)
    raise FileExistsError(f"no new log folder could be created in {root}")
