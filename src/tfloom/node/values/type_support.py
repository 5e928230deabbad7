"""Whether a class is a type that ROS knows."""

from __future__ import annotations

from typing import Any

from tfloom.node.values.exceptions import NoTypeSupportImportedException
from tfloom.rmw.base import Service, Topic
from tfloom.rosidl.message import Message
from tfloom.rosidl.service import Service as ServiceType

__all__ = [
    "check_for_type_support",
    "check_is_valid_msg_type",
    "check_is_valid_srv_type",
]


def check_for_type_support(msg_or_srv_type: Any) -> None:
    """Check that a class is a message or a service.

    Raises:
        NoTypeSupportImportedException: it is neither.
    """
    if not _is_subclass(msg_or_srv_type, (Message, ServiceType)):
        raise NoTypeSupportImportedException


def check_is_valid_msg_type(msg_type: Any) -> None:
    """Check that a class is a message.

    Raises:
        NoTypeSupportImportedException: it isn't.
    """
    if not _is_subclass(msg_type, (Message,)):
        raise NoTypeSupportImportedException


def check_is_valid_srv_type(srv_type: Any) -> None:
    """Check that a class is a service.

    Raises:
        NoTypeSupportImportedException: it isn't.
    """
    if not _is_subclass(srv_type, (ServiceType,)):
        raise NoTypeSupportImportedException


def _is_subclass(candidate: Any, bases: tuple[type, ...]) -> bool:
    return isinstance(candidate, type) and issubclass(candidate, bases)


def topic_of(msg_type: type[Message], full_name: str, *, is_native: bool = False) -> Topic:
    """Return what to write or read for messages of a class on a topic; `is_native`: one without ROS's prefix."""
    return Topic(full_name, msg_type._TYPE_NAME, msg_type._TYPE_HASH, is_native)  # ours


def service_of(srv_type: type[ServiceType], full_name: str) -> Service:
    """Return what to call or serve for a service class under a name."""
    return Service(
        full_name,
        srv_type._TYPE_NAME,  # ours, here and below
        srv_type.Request._TYPE_HASH,
        srv_type.Response._TYPE_HASH,
    )
