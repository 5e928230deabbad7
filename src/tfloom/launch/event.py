"""The base class of events."""

from __future__ import annotations

__all__ = ["Event"]


class Event:
    """Something that has happened, or is to be done, which event handlers handle in order."""

    name = "launch.Event"
    """A name that describes the kind, for logs and for `event_named`."""
