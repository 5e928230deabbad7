"""Marks of test descriptions and of tests."""

from __future__ import annotations

import functools
import inspect
import threading
import unittest
from collections.abc import Callable
from typing import Any, TypeVar

from tfloom.common.seconds import checked_timeout

__all__ = ["is_kept_alive", "keep_alive", "post_shutdown_test", "retry_on_failure"]

_Marked = TypeVar("_Marked", bound=Callable[..., Any])
_Case = TypeVar("_Case", bound=type[Any])
_MARKERS = "__markers__"


def post_shutdown_test() -> Callable[[_Case], _Case]:
    """Return a decorator of a test case, whose tests then run when all processes have exited."""

    def decorate(case: _Case) -> _Case:
        case.__post_shutdown_test__ = True
        return case

    return decorate


def keep_alive(test_description: _Marked) -> _Marked:
    """Mark a test description: its launch goes on when all of its processes have exited, until the tests end."""
    markers = dict(getattr(test_description, _MARKERS, {}))
    setattr(test_description, _MARKERS, {**markers, "keep_alive": True})
    return test_description


def is_kept_alive(test_description: object) -> bool:
    """Return whether a test description is marked with `keep_alive`."""
    return bool(getattr(test_description, _MARKERS, {}).get("keep_alive"))


def retry_on_failure(*, times: int, delay: float | None = None) -> Callable[[_Marked], _Marked]:
    """Return a decorator of a test, or of a test case and so of all its tests, that repeats one that fails.

    Args:
        times: How often the test is tried, at most.
        delay: Time between two tries [s]; None for none.

    Raises:
        ValueError: `times` is less than one.
    """
    if times < 1:
        raise ValueError(f"times must be at least 1, and is {times}")
    delay_s = 0.0 if delay is None else checked_timeout("retry_on_failure", delay)

    def decorate(target: Any) -> Any:
        if not inspect.isclass(target):
            return _retrying_test(target, times, delay_s)
        case: Any = target
        for name in unittest.TestLoader().getTestCaseNames(case):
            setattr(target, name, _retrying_test(getattr(target, name), times, delay_s))
        return target

    return decorate


def _retrying_test(test: _Marked, times: int, delay_s: float | None) -> _Marked:
    @functools.wraps(test)
    def retry(*args: Any, **kwargs: Any) -> Any:
        for _ in range(times - 1):
            try:
                return test(*args, **kwargs)
            except AssertionError:  # it is the subject
                threading.Event().wait(delay_s)
        return test(*args, **kwargs)

    return retry  # type: ignore[return-value]  # has the same signature
