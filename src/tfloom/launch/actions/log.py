"""Actions that log a message at one of the levels."""

from __future__ import annotations

import logging
from typing import Any

from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.utilities.argument_errors import substitutions_error
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

__all__ = ["Log", "LogDebug", "LogError", "LogInfo", "LogWarning"]

_LEVELS = {
    "NOTSET": logging.NOTSET,
    "DEBUG": logging.DEBUG,
    "INFO": logging.INFO,
    "WARN": logging.WARNING,
    "WARNING": logging.WARNING,
    "ERROR": logging.ERROR,
    "FATAL": logging.CRITICAL,
    "CRITICAL": logging.CRITICAL,
}


@expose_action("log")
class Log(Action):
    """Logs a message by the logger `launch.user` when it is executed.

    Args:
        msg: The message; it may have substitutions.
        level: Name of its level, in any case: debug, info, warning, error or critical; it may have substitutions.
        kwargs: As for Action.
    """

    def __init__(self, *, msg: SomeSubstitutionsType, level: SomeSubstitutionsType, **kwargs: Any) -> None:
        if (error := substitutions_error("msg", msg)) is not None:
            raise error
        super().__init__(**kwargs)
        self.__msg = normalize_to_list_of_substitutions(msg)
        self.__level = normalize_to_list_of_substitutions(level)
        self.__logger = get_logger("launch.user")

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Log], dict[str, Any]]:
        """Return a class and its arguments, read from the tag `log`, or `log_info` and the like: `message`.

        The tag `log` may have a `level`; without one, it is a `LogInfo`.
        """
        _, kwargs = super().parse(entity, parser)
        kwargs["msg"] = parser.parse_substitution(entity.get_attr("message"))
        if cls is not Log:
            return cls, kwargs
        level = entity.get_attr("level", optional=True)
        if level is None:
            return LogInfo, kwargs
        kwargs["level"] = parser.parse_substitution(level)
        return cls, kwargs

    @property
    def msg(self) -> list[Substitution]:
        """Message that is logged, as substitutions."""
        return self.__msg

    @property
    def level(self) -> list[Substitution]:
        """The name of its level."""
        return self.__level

    def execute(self, context: LaunchContext) -> None:
        """Log it.

        Raises:
            KeyError: there is no such level.
        """
        level = perform_substitutions(context, self.__level).upper()
        if level not in _LEVELS:
            raise KeyError(f"Invalid log level '{level}', expected: {', '.join(_LEVELS)}")
        self.__logger.log(_LEVELS[level], "%s", perform_substitutions(context, self.__msg))


class _LogOfLevel(Log):
    """Logs a message of the class's level when it is executed."""

    _level_name = ""

    def __init__(self, *, msg: SomeSubstitutionsType, **kwargs: Any) -> None:
        kwargs.pop("level", None)
        super().__init__(msg=msg, level=self._level_name, **kwargs)


@expose_action("log_debug")
class LogDebug(_LogOfLevel):
    """Logs a message of level DEBUG when it is executed.

    Args:
        msg: The message; it may have substitutions.
        kwargs: As for Action.
    """

    _level_name = "DEBUG"


@expose_action("log_info")
class LogInfo(_LogOfLevel):
    """Logs a message of level INFO when it is executed.

    Args:
        msg: The message; it may have substitutions.
        kwargs: As for Action.
    """

    _level_name = "INFO"


@expose_action("log_warning")
class LogWarning(_LogOfLevel):
    """Logs a message of level WARNING when it is executed.

    Args:
        msg: The message; it may have substitutions.
        kwargs: As for Action.
    """

    _level_name = "WARNING"


@expose_action("log_error")
class LogError(_LogOfLevel):
    """Logs a message of level ERROR when it is executed.

    Args:
        msg: The message; it may have substitutions.
        kwargs: As for Action.
    """

    _level_name = "ERROR"
