"""Checks that a class is a message or service class."""

from __future__ import annotations

from typing import Any

from tfloom.node.values.exceptions import NoTypeSupportImportedException
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
