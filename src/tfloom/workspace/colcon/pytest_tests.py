"""The tests that a CMakeLists.txt names by `ament_add_pytest_test` or `add_launch_test`, run without CTest."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape

from colcon_core.event.test import TestFailure
from colcon_core.shell import get_command_environment
from colcon_core.task import run

from tfloom.common.files import write_file
from tfloom.workspace.cmake_plan import BINARY_FOLDER, PytestTest

_TESTS_FAILED = 1
_NO_TESTS = 5
_MISSING = """\
<?xml version="1.0" encoding="UTF-8"?>
<testsuite name="{name}" tests="1" failures="0" time="0" errors="1" skipped="0">
  <testcase classname="{name}" name="missing_result" time="0">
    <failure message="The test ended without a result: see its output in the folder log."/>
  </testcase>
</testsuite>
"""


async def run_pytest_tests(context: Any, tests: Sequence[PytestTest]) -> int:
    """Run tests, each by a separate pytest; `colcon test-result` finds the results.

    Args:
        context: That of the task.
        tests: In order.

    Returns:
        0, or pytest's exit code if one did not run to its end; failures are posted as events.
    """
    args, name = context.args, context.pkg.name
    build = Path(args.build_base)
    results = Path(args.test_result_base or build) / "test_results" / name
    results.mkdir(parents=True, exist_ok=True)
    environment = await get_command_environment("test", args.build_base, context.dependencies)
    code = 0
    for test in tests:
        result = results / f"{test.name}.xunit.xml"
        # A pytest that is killed writes none.
        write_file(result, _MISSING.format(name=escape(f"{name}.{test.name}")))
        words = [
            *(str(Path(args.path, test.path)), "--tb=short", "-o", f"cache_dir={build / '.pytest_cache'}"),
            *(f"--launch-args={argument}" for argument in test.launch_arguments),
            *(f"--junit-xml={result}", f"--junit-prefix={name}", *(getattr(args, "pytest_args", None) or ())),
        ]
        ended = await run(
            context,
            [sys.executable, "-m", "pytest", *words],
            cwd=str(Path(args.path, test.folder.replace(BINARY_FOLDER, str(build)))),
            env=_environment_of(test, environment, build),
        )
        if ended.returncode == _TESTS_FAILED:
            context.put_event_into_queue(TestFailure(name))
        elif ended.returncode not in {0, _NO_TESTS}:
            code = int(ended.returncode)
    return code


def _environment_of(test: PytestTest, environment: Mapping[str, str], build: Path) -> dict[str, str]:
    """Return the variables of a test; those of APPEND_ENV follow the values that are there."""
    result = dict(environment)
    for text in test.set_variables:
        name, _, value = text.partition("=")
        result[name] = value.replace(BINARY_FOLDER, str(build))
    for text in test.appended_variables:
        name, _, value = text.partition("=")
        parts = (result.get(name, ""), value.replace(BINARY_FOLDER, str(build)))
        result[name] = os.pathsep.join(filter(None, parts))
    return result
