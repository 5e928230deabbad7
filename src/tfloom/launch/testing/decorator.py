"""The mark of tests that run when the launch has ended."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

__all__ = ["post_shutdown_test"]

_Case = TypeVar("_Case", bound=type[Any])


def post_shutdown_test() -> Callable[[_Case], _Case]:
    """Return a decorator of a test case, whose tests then run when all processes have exited."""

    def decorate(case: _Case) -> _Case:
        case.__post_shutdown_test__ = True
        return case

    return decorate
