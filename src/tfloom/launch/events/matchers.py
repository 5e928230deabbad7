"""Matchers, which tell whether an event is for an action."""

from __future__ import annotations

from collections.abc import Callable

from tfloom.launch.action import Action

__all__ = ["matches_action"]


def matches_action(target_action: Action) -> Callable[[Action], bool]:
    """Return a function that returns whether an action is `target_action`."""
    return lambda action: action is target_action
