"""Interface classes by type name."""

from __future__ import annotations

from tfloom.rosidl.class_search import (
    UnknownTypeError,
    find_by_definition,
    find_class,
    find_class_of_kind,
    full_name,
)
from tfloom.rosidl.message import Message
from tfloom.rosidl.service import Action, Service

__all__ = [
    "UnknownTypeError",
    "find_by_definition",
    "find_class",
    "full_name",
    "get_action_class",
    "get_message_class",
    "get_service_class",
]


def get_message_class(name: str) -> type[Message]:
    """Return the class of a message: `geometry_msgs/msg/Twist`, or `geometry_msgs/Twist` for short.

    The search order is tfloom's own classes, those of any importable module `package.msg`, and definitions in a
    sourced workspace.

    Raises:
        LookupError: there is no such message; the text has the nearest name that exists.
        ParseError: its definition can't be parsed.
    """
    return find_class_of_kind(name, "msg", Message)


def get_service_class(name: str) -> type[Service]:
    """Return the class of a service: `turtlesim/srv/Spawn`, or `turtlesim/Spawn` for short.

    Raises:
        LookupError, ParseError: as `get_message_class`.
    """
    return find_class_of_kind(name, "srv", Service)


def get_action_class(name: str) -> type[Action]:
    """Return the class of an action: `turtlesim/action/RotateAbsolute`, or `turtlesim/RotateAbsolute` for short.

    Raises:
        LookupError, ParseError: as `get_message_class`.
    """
    return find_class_of_kind(name, "action", Action)
