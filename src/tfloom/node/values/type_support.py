"""Checks that a class is a message or service class."""

from __future__ import annotations

import reprlib
from typing import Any

from tfloom.rosidl.message import Message
from tfloom.rosidl.service import Action
from tfloom.rosidl.service import Service as ServiceType

__all__ = [
    "check_for_type_support",
    "check_is_valid_action_type",
    "check_is_valid_msg_type",
    "check_is_valid_srv_type",
]

_TYPES = (Message, ServiceType, Action)


def check_for_type_support(msg_or_srv_type: Any) -> None:
    """Check that a class is a message, a service or an action.

    Raises:
        AttributeError: it is none of them.
    """
    _check_is_ros_type(msg_or_srv_type, "message or service class, such as std_msgs.msg.String")


def check_is_valid_msg_type(msg_type: Any) -> None:
    """Check that a class is a message.

    Raises:
        AttributeError: it is not a ROS type.
        RuntimeError: it is a service or an action.
    """
    check_type(msg_type, Message, "message class, such as std_msgs.msg.String")


def check_is_valid_srv_type(srv_type: Any) -> None:
    """Check that a class is a service.

    Raises:
        AttributeError: it is not a ROS type.
        RuntimeError: it is a message or an action.
    """
    check_type(srv_type, ServiceType, "service class, such as std_srvs.srv.SetBool")


def check_is_valid_action_type(action_type: Any) -> None:
    """Check that a class is an action.

    Raises:
        AttributeError: it is not a ROS type.
        RuntimeError: it is a message or a service.
    """
    check_type(action_type, Action, "action class, such as example_interfaces.action.Fibonacci")


def check_type(candidate: Any, base: type, wanted: str) -> None:
    """Check that a class derives from `base`, one of Message, Service and Action; `wanted` begins with its kind.

    Raises:
        AttributeError: it is not a ROS type.
        RuntimeError: it is a ROS type of another kind.
    """
    _check_is_ros_type(candidate, wanted)
    if not _is_subclass(candidate, (base,)):
        kind = wanted.partition(" ")[0]
        others = " or ".join(other for other in ("message", "service", "action") if other != kind)
        raise RuntimeError(f"The {kind} type provided is not valid ({candidate}), this might be a {others}")


def _check_is_ros_type(candidate: Any, wanted: str) -> None:
    if not _is_subclass(candidate, _TYPES):
        article = "an" if wanted.startswith("a") else "a"
        raise AttributeError(f"expected {article} {wanted}, got {_describe(candidate)}")


def _is_subclass(candidate: Any, bases: tuple[type, ...]) -> bool:
    return isinstance(candidate, type) and issubclass(candidate, bases)


def _describe(candidate: Any) -> str:
    if isinstance(candidate, type):
        return f"the class {candidate.__module__}.{candidate.__qualname__}"
    return f"{reprlib.repr(candidate)} of class {type(candidate).__name__}"
