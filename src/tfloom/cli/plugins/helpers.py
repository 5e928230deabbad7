"""Small functions that extensions of the command share."""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Callable
from typing import Any, TypeVar

from tfloom.common.seconds import checked_timeout

__all__ = [
    "before_invocation",
    "bind",
    "collect_stdin",
    "get_ros_domain_id",
    "pretty_print_call",
    "unsigned_int",
    "wait_for",
]

_Function = TypeVar("_Function", bound=Callable[..., Any])


def get_ros_domain_id() -> int:
    """Return the number in ROS_DOMAIN_ID, 0 without one."""
    return int(os.environ.get("ROS_DOMAIN_ID") or 0)


def wait_for(predicate: Callable[[], Any], timeout: float | None, period: float = 0.1) -> bool:
    """Wait until a condition holds; return whether it does at the end.

    Args:
        predicate: The condition.
        timeout: Longest wait [s]; None: no limit.
        period: Time between two looks [s].
    """
    timeout_s = checked_timeout("wait_for", timeout)
    period_s = checked_timeout("wait_for", period)
    end_s = None if timeout_s is None else time.monotonic() + timeout_s
    while not (is_met := bool(predicate())):
        if end_s is not None and time.monotonic() >= end_s:
            break
        time.sleep(1e9 if period_s is None else max(0.0, period_s))
    return is_met


def collect_stdin() -> str:
    """Return all lines of standard input."""
    return sys.stdin.read()


def unsigned_int(string: str) -> int:
    """Return a whole number that isn't negative.

    Raises:
        argparse.ArgumentTypeError: it is not such a number.
    """
    try:
        value = int(string)
    except ValueError:
        value = -1
    if value < 0:
        raise argparse.ArgumentTypeError("value must be non-negative integer")
    return value


def bind(func: _Function, *args: Any, **kwargs: Any) -> Callable[..., Any]:
    """Return a function with its first arguments given, under its own name and docstring."""
    from functools import partial, update_wrapper

    return update_wrapper(partial(func, *args, **kwargs), func)


def before_invocation(func: _Function, hook: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function that calls a hook with its arguments before itself."""
    from functools import wraps

    @wraps(func)
    def with_hook(*args: Any, **kwargs: Any) -> Any:
        hook(func, *args, **kwargs)
        return func(*args, **kwargs)

    return with_hook


def pretty_print_call(func: Callable[..., Any], *args: Any, **kwargs: Any) -> None:
    """Print a call as its source code: the function's name, and its arguments."""
    arguments = [*map(repr, args), *(f"{name}={value!r}" for name, value in kwargs.items())]
    print(f"{func.__name__}({', '.join(arguments)})")
