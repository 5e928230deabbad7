"""A matcher by an event's name."""

from __future__ import annotations

from collections.abc import Callable

from tfloom.launch.event import Event

__all__ = ["event_named"]


def event_named(name: str) -> Callable[[Event], bool]:
    """Return a matcher of the events that have a name."""
    return lambda event: event.name == name
