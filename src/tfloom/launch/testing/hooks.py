"""Launch tests under pytest: a file with `generate_test_description` is one item. PYTEST_DONT_REWRITE."""

from __future__ import annotations

import inspect
import unittest
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tfloom.launch.testing.launch_test import import_file
from tfloom.launch.testing.loader import (
    ENTRY_POINT,
    DescriptionError,
    LoadTestsFromPythonModule,
    TestRun,
)
from tfloom.launch.testing.test_result import FailResult, SkipResult
from tfloom.launch.testing.test_runner import LaunchTestRunner
from tfloom.ros_imports.guard import ros_home

__all__ = [
    "LaunchROSTestItem",
    "LaunchROSTestModule",
    "LaunchTestFailure",
    "LaunchTestFailureRepr",
    "LaunchTestItem",
    "LaunchTestModule",
    "find_launch_test_entrypoint",
    "pytest_launch_collect_makemodule",
]

Results = dict[TestRun, unittest.TestResult]


class LaunchTestFailure(Exception):  # launch_testing's name
    """A launch failed, or tests of it.

    Args:
        message: What failed.
        results: The result of each launch.
    """

    __module__ = ros_home("launch_testing.pytest.hooks", __name__)

    def __init__(self, message: str, results: Results) -> None:
        super().__init__(message)
        self.results = results

    def __str__(self) -> str:
        return "\n".join(self._lines())

    def _lines(self) -> Iterator[str]:
        yield str(self.args[0])
        for run, result in self.results.items():
            if result.wasSuccessful():
                continue
            if isinstance(result, FailResult):
                yield f"\n{run}: {result.message}\n{result.details}"
            for kind, texts in (("FAIL", result.failures), ("ERROR", result.errors)):
                for case, text in texts:
                    yield f"\n{kind}: {case}\n{text}"
            for case in result.unexpectedSuccesses:
                yield f"\nUNEXPECTED SUCCESS: {case}"


class LaunchTestFailureRepr(str):
    """The text of a failure, as pytest prints it."""

    __slots__ = ()

    def toterminal(self, out: Any) -> None:
        """Write the text to pytest's terminal."""
        out.line(str(self))


class LaunchTestItem(pytest.Item):
    """All launches of a file, and their tests, as one item of pytest."""

    runner_class: type[LaunchTestRunner] = LaunchTestRunner

    def __init__(self, *, test_runs: Iterable[TestRun], **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.test_runs = list(test_runs)

    def runtest(self) -> None:
        """Run the launches.

        Raises:
            LaunchTestFailure: one failed, or a test of it.
        """
        options: list[str] = self.config.getoption("--launch-args", default=None) or []
        runner = self.runner_class(self.test_runs, [word for option in options for word in option.split()])
        runner.validate()
        results = runner.run()
        failed = [run for run, result in results.items() if not result.wasSuccessful()]
        if failed:
            names = ", ".join(str(run) for run in failed)
            raise LaunchTestFailure(f"launch tests failed: {names}", results)
        if results and all(isinstance(result, SkipResult) for result in results.values()):
            pytest.skip(
                "; ".join(dict.fromkeys(str(getattr(result, "message", "")) for result in results.values()))
            )

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """Return the text of a failure: that of the tests, or of the description, without the stack above it."""
        if isinstance(excinfo.value, (LaunchTestFailure, DescriptionError)):
            return LaunchTestFailureRepr(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int, str]:
        """Return file, line and name for pytest's reports."""
        return self.path, 0, f"{self.name}: launch tests"


class LaunchTestModule(pytest.Module):
    """A file with `generate_test_description`; one whose function is none is collected as any other."""

    item_class: type[LaunchTestItem] = LaunchTestItem

    def _getobj(self) -> Any:
        # A name as `talker.test.py` is not a module's, so that pytest would not import it.
        return import_file(self.path) if "." in self.path.stem else super()._getobj()  # type: ignore[no-untyped-call]

    def collect(self) -> Iterable[pytest.Item | pytest.Collector]:
        """Return the item, or the tests of a file that is not a launch test."""
        entry_point = find_launch_test_entrypoint(self.obj)
        if entry_point is None:
            return super().collect()
        runs = LoadTestsFromPythonModule(self.obj, name=self.path.name.removesuffix(".py"))
        item = self.makeitem(name=self.path.name.split(".")[0], parent=self, test_runs=runs)
        item.own_markers += _markers(entry_point)
        return [item]

    def makeitem(self, **kwargs: Any) -> LaunchTestItem:
        """Return the item of the file."""
        return self.item_class.from_parent(**kwargs)


class LaunchROSTestItem(LaunchTestItem):
    """All launches of a file with nodes, and their tests, as one item of pytest: nodes need nothing more."""


class LaunchROSTestModule(LaunchTestModule):
    """A file with `generate_test_description` whose description has nodes."""

    item_class = LaunchROSTestItem


def find_launch_test_entrypoint(module: Any) -> Any:
    """Return the `generate_test_description` of a module if it is that of a launch test, otherwise None.

    It is a function, or several of `launch_testing.parametrize`; the same name may be a fixture of launch_pytest.
    """
    function = getattr(module, ENTRY_POINT, None)
    is_function = inspect.isfunction(function) and not hasattr(function, "_pytestfixturefunction")
    return function if is_function or getattr(function, "__parametrized__", False) else None


def pytest_launch_collect_makemodule(
    module_path: Path, parent: pytest.Collector, entrypoint: object
) -> LaunchTestModule:
    """Return the collector of a file with launch tests."""
    del entrypoint
    return LaunchTestModule.from_parent(parent, path=module_path)


def _markers(entry_point: Any) -> list[pytest.Mark]:
    """Return the marks on a function."""
    marks = getattr(entry_point, "pytestmark", [])
    return list(marks) if isinstance(marks, list) else [marks]
