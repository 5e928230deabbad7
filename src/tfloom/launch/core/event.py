"""The base class of events."""

from __future__ import annotations

from tfloom.launch.core.private_names import HasPrivateNames
from tfloom.ros_imports.guard import ros_repr

__all__ = ["Event"]


class Event(HasPrivateNames):
    """Something that has happened, or is to be done, which event handlers handle in order."""

    name = "launch.Event"
    """A name that describes the kind, for logs and for `event_named`."""

    def __repr__(self) -> str:
        return ros_repr(self)
