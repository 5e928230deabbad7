"""The guard of each launch that runs."""

from __future__ import annotations

from weakref import WeakKeyDictionary

from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.processes.guard import Guard

__all__ = ["guard_of"]

_guards: WeakKeyDictionary[LaunchContext, Guard] = WeakKeyDictionary()


def guard_of(context: LaunchContext) -> Guard:
    """Return the guard of a launch."""
    return _guards.setdefault(context, Guard())
