"""Names of the services and topics of an action."""

from __future__ import annotations

import os
from typing import Any

from tfloom.interfaces.unique_identifier_msgs.msg import UUID
from tfloom.node.values.exceptions import NoTypeSupportImportedException
from tfloom.rosidl.service import Action

__all__ = [
    "CANCEL_GOAL",
    "FEEDBACK",
    "GET_RESULT",
    "SEND_GOAL",
    "STATUS",
    "check_is_valid_action_type",
    "new_goal_id",
]

SEND_GOAL = "/_action/send_goal"
CANCEL_GOAL = "/_action/cancel_goal"
GET_RESULT = "/_action/get_result"
FEEDBACK = "/_action/feedback"
STATUS = "/_action/status"


def check_is_valid_action_type(action_type: Any) -> None:
    """Check that a class is an action.

    Raises:
        NoTypeSupportImportedException: it isn't.
    """
    if not (isinstance(action_type, type) and issubclass(action_type, Action)):
        raise NoTypeSupportImportedException


def new_goal_id() -> UUID:
    """Return a random id, a UUID of version 4."""
    octets = bytearray(os.urandom(16))
    octets[6] = octets[6] & 0x0F | 0x40
    octets[8] = octets[8] & 0x3F | 0x80
    return UUID(uuid=list(octets))


def key_of(goal_id: UUID) -> bytes:
    """Return an id as 16 octets."""
    return bytes(bytearray(goal_id.uuid))
