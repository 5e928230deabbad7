"""The services that read and set the levels of loggers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.interfaces.rcl_interfaces.msg import LoggerLevel, SetLoggerLevelsResult
from tfloom.interfaces.rcl_interfaces.srv import (
    GetLoggerLevels,
    GetLoggerLevels_Request,
    GetLoggerLevels_Response,
    SetLoggerLevels,
    SetLoggerLevels_Request,
    SetLoggerLevels_Response,
)
from tfloom.node.log.logging import get_logger_level, set_logger_level
from tfloom.node.values.names import TOPIC_SEPARATOR_STRING

if TYPE_CHECKING:
    from tfloom.node.base.node_base import NodeBase

__all__ = ["TOPIC_SEPARATOR_STRING", "LoggingService"]


class LoggingService:
    """Serves the levels of all loggers of the process, below a node's name."""

    def __init__(self, node: NodeBase) -> None:
        node.create_service(GetLoggerLevels, "~/get_logger_levels", self._get)
        node.create_service(SetLoggerLevels, "~/set_logger_levels", self._set)

    def _get(
        self, request: GetLoggerLevels_Request, response: GetLoggerLevels_Response
    ) -> GetLoggerLevels_Response:
        response.levels = [LoggerLevel(name=name, level=get_logger_level(name)) for name in request.names]
        return response

    def _set(
        self, request: SetLoggerLevels_Request, response: SetLoggerLevels_Response
    ) -> SetLoggerLevels_Response:
        response.results = [_set_one(level) for level in request.levels]
        return response


def _set_one(level: LoggerLevel) -> SetLoggerLevelsResult:
    try:
        set_logger_level(level.name, level.level)
    except ValueError:
        return SetLoggerLevelsResult(successful=False, reason="Failed reason: Invalid logger level.")
    return SetLoggerLevelsResult(successful=True)
