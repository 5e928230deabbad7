"""Names of the services and topics of an action."""

from __future__ import annotations

from typing import Any

from tfloom.node.values.type_support import check_type
from tfloom.rmw.action_names import CANCEL_GOAL, FEEDBACK, GET_RESULT, SEND_GOAL, STATUS, key_of, new_goal_id
from tfloom.rosidl.service import Action

__all__ = [
    "CANCEL_GOAL",
    "FEEDBACK",
    "GET_RESULT",
    "SEND_GOAL",
    "STATUS",
    "check_is_valid_action_type",
    "key_of",
    "new_goal_id",
]


def check_is_valid_action_type(action_type: Any) -> None:
    """Check that a class is an action.

    Raises:
        AttributeError: it is not a ROS type.
        RuntimeError: it is a message or a service.
    """
    check_type(action_type, Action, "action class, such as example_interfaces.action.Fibonacci")
