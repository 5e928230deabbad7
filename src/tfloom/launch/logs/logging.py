"""Logs of a launch: on the screen, in the launch's log folder, and a process's own files."""

from __future__ import annotations

import logging
import os
import sys
import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from datetime import datetime
from pathlib import Path
from typing import Any, ClassVar, Union

from tfloom.common.terminal import report
from tfloom.launch.logs.log_handlers import BraceFormatter, FileHandler, StdoutHandler, close_handler

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
STYLES = ("{", "%", "$")
"""Styles of formats, as `logging.Formatter` has them."""
LINE_FORMAT = "{msg}"
"""Of a process's output, whose prefix is part of the line."""

LOG_FILE_NAME = "launch.log"
"""Name of the launch's own log file, unless the program or the command line gives another one."""

MAX_FOLDERS = 1000
"""Attempts to create a log folder with a new name."""


class LaunchLogger(logging.Logger):
    """A logger of the launch, or of a process's output."""

    all_loggers: ClassVar[dict[str, LaunchLogger]] = {}

    def setLevel(self, level: int | str) -> None:
        """Set the level below which nothing is logged."""
        super().setLevel(level)
        self._cache.clear()  # type: ignore[attr-defined]  # the base class clears those of its own loggers only

    def addHandler(self, hdlr: logging.Handler) -> None:
        """Add a handler; those of `launch_config`, which each logger has from the start, write a record once."""
        self.handlers = [
            handler
            for handler in self.handlers
            if not (isinstance(handler, _DeferredHandler) and handler.stands_for(hdlr))
        ]
        super().addHandler(hdlr)


def _file_handler(path: str, encoding: str | None = None) -> logging.Handler:
    return FileHandler(path, encoding=encoding)


def _given_format(
    destination: str, given: str, style: str | None, defaults: Mapping[str, str]
) -> tuple[str, str]:
    """Return a format and its style, as the environment or the program gives them.

    Raises:
        ValueError: there is no such style, or it is given for a default.
    """
    if override := os.environ.get(f"OVERRIDE_LAUNCH_{destination}_FORMAT"):
        # A shell passes `\n` and `\033[1m` on as they are typed.
        return defaults.get(override) or _unescaped(override), "{"
    if style is not None and given in defaults:
        raise ValueError(f"a style can't be set for the format '{given}': it has one of its own")
    if style is not None and style not in STYLES:
        raise ValueError(f"'{style}' is not a style of formats: use one of {' '.join(STYLES)}")
    return defaults.get(given, given), style or "{"


def _unescaped(text: str) -> str:
    """Return a text with the escape sequences of Python's literals replaced."""
    import codecs

    decoded, _ = codecs.escape_decode(text.encode("utf-8"))  # of CPython
    return bytes(decoded).decode("utf-8")


def _formatter(text: str, style: str, stream: Any = None) -> logging.Formatter:
    if style == "{":
        return BraceFormatter(text, stream)
    return logging.Formatter(text, style=style)  # type: ignore[arg-type]  # checked by `_given_format`


class LaunchConfig:
    """Where and how a launch logs. There is one, `launch_config`."""

    def __init__(self) -> None:
        self._loggers: list[logging.Logger] = []
        self.reset()

    def reset(self) -> None:
        """Return to what the environment variables say, with a new log folder."""
        self._log_dir: str | None = None
        self._log_file_name = LOG_FILE_NAME
        self._is_loss_told = False
        self._file_handlers: dict[str, logging.Handler] = {}
        self._screen: dict[str, logging.Handler] = {}
        self.level = logging.INFO
        self.log_handler_factory: Callable[..., logging.Handler] = _file_handler
        """Takes the path of a log file and, by keyword, its encoding."""
        self.set_screen_format("default")
        self.set_log_format("default")

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
            ValueError: (on setting) it is not a folder, or another one is set already.
        """
        if self._log_dir is None:
            self._log_dir = _make_unique_log_dir(base_path=_get_logging_directory())
            _renew_latest_log_dir(log_dir=self._log_dir)
        return self._log_dir

    @log_dir.setter
    def log_dir(self, log_dir: str | None) -> None:
        if log_dir is None:  # a new folder at the next use
            self._log_dir = None
            return
        path = Path(log_dir).expanduser()
        if not path.is_dir():
            raise ValueError(f"{log_dir} is not a directory")
        if self._log_dir is not None and self._log_dir != str(path):
            raise ValueError(f"Cannot set log directory to '{log_dir}': it is '{self._log_dir}' already")
        self._log_dir = str(path)

    @property
    def log_file_name(self) -> str:
        """Name of the launch's own log file in its log folder.

        Raises:
            ValueError: (on setting) it is not the name of a file, because it is empty or has a folder.
        """
        return self._log_file_name

    @log_file_name.setter
    def log_file_name(self, name: str) -> None:
        if (
            not isinstance(name, str)
            or not name
            or name in (".", "..")
            or "\0" in name
            or Path(name).name != name
        ):
            raise ValueError(
                f"{name!r} is not the name of a log file: give one without folders; "
                "ROS_LOG_DIR says in which folder it is"
            )
        self._log_file_name = name

    def set_screen_format(self, screen_format: str, *, screen_style: str | None = None) -> None:
        """Set the format of lines on the screen; the environment variable OVERRIDE_LAUNCH_SCREEN_FORMAT overrides it.

        Args:
            screen_format: "default", "default_with_timestamp", or a format of `logging.Formatter`.
            screen_style: Style of a format that is none of the defaults: `{` (also for None), `%` or `$`.

        Raises:
            ValueError: there is no such style, or it is given for a default.
        """
        given = _given_format("SCREEN", screen_format, screen_style, SCREEN_FORMATS)
        self.screen_format, self._screen_style = given
        if "records" in self._screen:
            self._screen["records"].setFormatter(self._screen_formatter())

    def set_log_format(self, log_format: str, *, log_style: str | None = None) -> None:
        """Set the format of lines in log files; the environment variable OVERRIDE_LAUNCH_LOG_FORMAT overrides it.

        Args:
            log_format: "default", or a format of `logging.Formatter`.
            log_style: Style of a format that is not the default: `{` (also for None), `%` or `$`.

        Raises:
            ValueError: there is no such style, or it is given for the default.
        """
        self.log_format, self._log_style = _given_format("LOG", log_format, log_style, LOG_FORMATS)
        if self._log_file_name in self._file_handlers:
            self._file_handlers[self._log_file_name].setFormatter(self._log_formatter())

    def _screen_formatter(self) -> logging.Formatter:
        return _formatter(self.screen_format, self._screen_style, sys.stdout)

    def _log_formatter(self) -> logging.Formatter:
        return _formatter(self.log_format, self._log_style)

    def get_log_file_path(self, file_name: str | None = None) -> str:
        """Return the path of a file in the log folder; without a name, of the launch's own."""
        return str(Path(self.log_dir) / (file_name or self._log_file_name))

    def get_screen_handler(self, *, lines: bool = False) -> logging.Handler:
        """Return the handler that writes on the screen; `lines` are those of processes."""
        name = "lines" if lines else "records"
        if name not in self._screen:
            handler = StdoutHandler()
            handler.setFormatter(
                BraceFormatter(LINE_FORMAT, sys.stdout) if lines else self._screen_formatter()
            )
            self._screen[name] = handler
        return self._screen[name]

    def get_log_file_handler(self, file_name: str | None = None, *, lines: bool = False) -> logging.Handler:
        """Return the handler that writes to a file in the log folder; one that writes nothing where that can't be.

        Args:
            file_name: Name of the file; None: the launch's own.
            lines: Whether it writes the lines of processes, which have no level.
        """
        file_name = file_name or self._log_file_name
        key = f"{file_name}{'/lines' if lines else ''}"
        if key not in self._file_handlers:
            try:
                handler = self._make_file_handler(self.get_log_file_path(file_name))
            except OSError as error:  # the launch goes on without it
                self.tell_loss(file_name, error)
                handler = logging.NullHandler()
            if file_name != self._log_file_name:
                handler.setFormatter(BraceFormatter(LINE_FORMAT))
            else:
                handler.setFormatter(
                    BraceFormatter("{created:.7f} {msg}") if lines else self._log_formatter()
                )
            self._file_handlers[key] = handler
        return self._file_handlers[key]

    def tell_loss(self, file_name: str, error: OSError) -> None:
        """Print, once, that a log file can't be created."""
        if not self._is_loss_told:
            self._is_loss_told = True
            report(f"[launch]: lines of {file_name} are lost: {error}")

    def _make_file_handler(self, path: str) -> logging.Handler:
        import inspect  # which a command that logs nothing does not need

        try:
            inspect.signature(self.log_handler_factory).bind(path, encoding="utf-8")
        except TypeError:  # a factory that takes the path alone
            return self.log_handler_factory(path)
        return self.log_handler_factory(path, encoding="utf-8")

    def has_handler(self, handler: logging.Handler, *, is_screen: bool) -> bool:
        """Return whether a handler is that of the screen, or else that of the launch's log file."""
        return handler is (
            self._screen.get("records") if is_screen else self._file_handlers.get(self._log_file_name)
        )

    def add_logger(self, logger: logging.Logger) -> None:
        """Make `level` that of a logger, too."""
        if logger not in self._loggers:
            self._loggers.append(logger)
            logger.setLevel(self._level)

    def close(self) -> None:
        """Close the log files, and remove the handlers of all loggers."""
        for name, handler in self._file_handlers.items():
            close_handler(handler, name)
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
        logger.addHandler(_DeferredHandler(is_screen=True))
        logger.addHandler(_DeferredHandler(is_screen=False))
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
        try:
            logger.info("All log files can be found below %s", launch_config.log_dir)
        except OSError as error:
            launch_config.tell_loss(launch_config.log_file_name, error)
        logger.info("Default logging verbosity is set to %s", logging.getLevelName(launch_config.level))


def reset() -> None:
    """Close the log files, and begin anew with the next launch."""
    launch_config.close()
    launch_config.reset()


class _DeferredHandler(logging.Handler):
    """Passes records on to a handler of `launch_config`, which is made for the first record: most commands log nothing.

    Args:
        is_screen: Whether that is the handler of the screen; otherwise it is that of the launch's log file.
    """

    def __init__(self, *, is_screen: bool) -> None:
        super().__init__()
        self._is_screen = is_screen

    def emit(self, record: logging.LogRecord) -> None:
        """Pass a record on."""
        config = launch_config
        (config.get_screen_handler() if self._is_screen else config.get_log_file_handler()).handle(record)

    def stands_for(self, handler: logging.Handler) -> bool:
        """Return whether records are passed on to a handler."""
        return launch_config.has_handler(handler, is_screen=self._is_screen)


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
            raise ValueError(f"'{stream}' is not an output of '{process_name}': use stdout, stderr or both")
        names = {where} if isinstance(where, str) else set(where)
        if wrong := names - {"screen", "log", "own_log"}:
            raise ValueError(
                f"{', '.join(sorted(map(str, wrong)))} is not a place for the output of '{process_name}': "
                "use screen, log or own_log"
            )
        sinks[stream] |= names
    return sinks


def _get_logging_directory() -> str:
    """Return the folder of all launches' log folders: ROS_LOG_DIR, else ROS_HOME/log, else ~/.ros/log."""
    environment = os.environ
    if environment.get("ROS_LOG_DIR"):
        return str(Path(environment["ROS_LOG_DIR"]).expanduser())
    return str(Path(environment.get("ROS_HOME") or "~/.ros").expanduser() / "log")


def _make_unique_log_dir(*, base_path: str) -> str:
    """Create `<base_path>/<time>-<host>-<pid>`, and return its path."""
    import socket  # which printing the arguments of a file does not need

    root = Path(base_path)
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


def _renew_latest_log_dir(*, log_dir: str) -> bool:
    """Let the symbolic link `latest`, beside a log folder, lead to it.

    Returns:
        Whether it does; False where `latest` is not a link, or links can't be created.
    """
    folder = Path(log_dir)
    link = folder.parent / "latest"
    if link.exists() and not link.is_symlink():
        return False
    # Another launch may do the same now: the link is created beside, and takes the other's place in one step.
    new_link = folder.parent / f".latest-{folder.name}"
    try:
        new_link.symlink_to(folder, target_is_directory=True)
    except OSError:
        return False
    try:
        new_link.replace(link)
    except OSError:
        with suppress(OSError):
            new_link.unlink()
        return False
    return True
