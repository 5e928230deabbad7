"""Results of the tests of one launch."""

from __future__ import annotations

import time
import unittest
from typing import Any

__all__ = ["FailResult", "SkipResult", "TestResult"]


class FailResult(unittest.TestResult):
    """The result of a launch that failed, whatever its tests have found.

    Args:
        test_run: The launch.
        message: Why it failed.
        details: More, for people: what the processes have printed.
    """

    def __init__(self, test_run: object = None, message: str = "", details: str = "") -> None:
        super().__init__()
        self.test_run = test_run
        self.message = message
        self.details = details

    def wasSuccessful(self) -> bool:
        """Return False, because the launch has failed as a whole."""
        return False


class SkipResult(unittest.TestResult):
    """The result of a launch that was skipped.

    Args:
        test_run: The launch.
        skip_reason: Why.
        msg: The same, by its other name.
    """

    def __init__(self, test_run: object = None, skip_reason: str = "", msg: str = "") -> None:
        super().__init__()
        self.test_run = test_run
        self.message = skip_reason or msg
        self.testCases: list[unittest.TestCase] = list(getattr(test_run, "all_tests", ()))
        """Each test of the launch, which are skipped with it."""
        self.skipped = [(test, self.message) for test in self.testCases]
        self.testsRun = len(self.testCases)

    def wasSuccessful(self) -> bool:
        """Return True, because a skipped launch is not a failure."""
        return True


class TestResult(unittest.TextTestResult):
    """A result that has all tests, and how long each took."""

    __test__ = False  # for pytest

    def __init__(self, stream: Any = None, descriptions: bool = True, verbosity: int = 1) -> None:
        super().__init__(stream, descriptions, verbosity)
        self.testCases: list[unittest.TestCase] = []
        self.testTimes: dict[unittest.TestCase, float] = {}
        """Times [s]."""

    def startTest(self, test: unittest.TestCase) -> None:
        """Note the time at which a test starts."""
        self.testCases.append(test)
        self.testTimes[test] = -time.monotonic()
        super().startTest(test)

    def stopTest(self, test: unittest.TestCase) -> None:
        """Note how long a test took."""
        if test in self.testTimes:
            self.testTimes[test] += time.monotonic()
        super().stopTest(test)

    def addSkip(self, test: unittest.TestCase, reason: str) -> None:
        """Note a test that was skipped, which Python 3.12.1 does not start."""
        if test not in self.testTimes:
            self.testCases.append(test)
        super().addSkip(test, reason)

    def append(self, results: unittest.TestResult) -> None:
        """Add what another result has."""
        self.failures += results.failures
        self.errors += results.errors
        self.skipped += results.skipped
        self.expectedFailures += results.expectedFailures
        self.unexpectedSuccesses += results.unexpectedSuccesses
        self.testsRun += results.testsRun
        if isinstance(results, TestResult):
            self.testCases += results.testCases
            self.testTimes |= results.testTimes
