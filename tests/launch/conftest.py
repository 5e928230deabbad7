"""Launches inside the test's process."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from typing import NamedTuple

import pytest

from tfloom.launch.actions import executable
from tfloom.launch.core.base_classes import LaunchDescriptionEntity
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.launch_service import LaunchService
from tfloom.launch.logs import logging as launch_logging


class Ran(NamedTuple):
    """A launch that has ended."""

    code: int
    lines: list[str]
    service: LaunchService


@pytest.fixture(autouse=True)
def _logs(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Write the logs of each test to its own folder."""
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path_factory.mktemp("launch_log")))
    launch_logging.reset()
    yield
    launch_logging.reset()


@pytest.fixture(autouse=True)
def _process_numbers(monkeypatch: pytest.MonkeyPatch) -> None:
    """Begin the numbers of processes anew, which count on within a program."""
    monkeypatch.setattr(executable, "_process_numbers", itertools.count(1))


@pytest.fixture
def context() -> LaunchContext:
    """Return the context of a launch that doesn't run."""
    return LaunchContext()


@pytest.fixture
def launch(capsys: pytest.CaptureFixture[str]) -> Callable[..., Ran]:
    """Return a function that launches entities to their end, and returns the exit code and the printed lines.

    The two lines about the log files are left out.
    """

    def launch(*entities: LaunchDescriptionEntity, argv: tuple[str, ...] = (), debug: bool = False) -> Ran:
        service = LaunchService(argv=argv, debug=debug)
        service.include_launch_description(LaunchDescription(entities))
        capsys.readouterr()
        code = service.run()
        lines = capsys.readouterr().out.splitlines()
        return Ran(code, [line for line in lines if not line.startswith("[INFO] [launch]: ")], service)

    return launch
