"""The time that a test description has until its ReadyToTest action."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

__all__ = ["DEFAULT_TIMEOUT_S", "ready_to_test_action_timeout", "timeout_of"]

DEFAULT_TIMEOUT_S = 15.0
_ATTRIBUTE = "__ready_to_test_action_timeout__"
_Function = TypeVar("_Function", bound=Callable[..., object])


def ready_to_test_action_timeout(timeout: float) -> Callable[[_Function], _Function]:
    """Return a decorator of `generate_test_description` that sets its time until ReadyToTest.

    Args:
        timeout: [s], instead of 15.
    """

    def decorate(function: _Function) -> _Function:
        setattr(function, _ATTRIBUTE, timeout)
        return function

    return decorate


def timeout_of(function: object) -> float:
    """Return the time that a test description has until its ReadyToTest action [s]."""
    return float(getattr(function, _ATTRIBUTE, DEFAULT_TIMEOUT_S))
