"""Whether a class is a type that ROS knows."""

from __future__ import annotations

from typing import Any

from tfloom.node.exceptions import NoTypeSupportImportedException
from tfloom.rmw.base import Topic
from tfloom.rosidl.message import Message

__all__ = ["check_for_type_support", "check_is_valid_msg_type"]


def check_for_type_support(msg_or_srv_type: Any) -> None:
    """Check that a class is a message.

    Raises:
        NoTypeSupportImportedException: it isn't.
    """
    check_is_valid_msg_type(msg_or_srv_type)


def check_is_valid_msg_type(msg_type: Any) -> None:
    """Check that a class is a message.

    Raises:
        NoTypeSupportImportedException: it isn't.
    """
    if not (isinstance(msg_type, type) and issubclass(msg_type, Message)):
        raise NoTypeSupportImportedException


def topic_of(msg_type: type[Message], full_name: str) -> Topic:
    """Return what to write or read for messages of a class on a topic."""
    return Topic(full_name, msg_type._TYPE_NAME, msg_type._TYPE_HASH)  # ours
