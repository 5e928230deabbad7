"""Logged messages and their levels."""

from __future__ import annotations

import logging
from collections.abc import Iterator

import pytest

from tfloom.launch.actions.log import Log, LogDebug, LogError, LogInfo, LogWarning
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.substitutions.variables import LaunchConfiguration


@pytest.fixture
def logged() -> Iterator[list[tuple[str, str]]]:
    """Return the level and text of what `launch.user` logs."""
    records: list[tuple[str, str]] = []

    class Keeping(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            records.append((record.levelname, record.getMessage()))

    logger, handler = get_logger("launch.user"), Keeping()
    level = logger.level
    logger.setLevel(logging.DEBUG)
    logger.addHandler(handler)
    yield records
    logger.removeHandler(handler)
    logger.setLevel(level)


def test_each_level(logged: list[tuple[str, str]], context: LaunchContext) -> None:
    context.launch_configurations["who"] = "100 %d"
    message = ["hello ", LaunchConfiguration("who")]
    for action in (LogDebug, LogInfo, LogWarning, LogError):
        action(msg=message).visit(context)
    Log(msg=message, level=["cri", "tical"]).visit(context)
    Log(msg=message, level="Warn").visit(context)
    levels = ["DEBUG", "INFO", "WARNING", "ERROR", "CRITICAL", "WARNING"]
    assert logged == [(level, "hello 100 %d") for level in levels]


def test_unknown_level_is_an_error_that_lists_the_levels() -> None:
    with pytest.raises(KeyError, match=r"Invalid log level 'LOUD', expected: .*WARNING"):
        Log(msg="x", level="loud").visit(LaunchContext())


def test_level_of_a_derived_class_is_its_own() -> None:
    action = LogInfo(msg="x", level="ERROR")
    assert [part.describe() for part in action.level] == ["'INFO'"]
    assert [part.describe() for part in action.msg] == ["'x'"]
