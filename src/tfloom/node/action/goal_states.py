"""The states of a goal, and the events that change them.

ACCEPTED --EXECUTE--> EXECUTING --SUCCEED--> SUCCEEDED
|                     |     --ABORT----> ABORTED
+----CANCEL_GOAL------+
|
v
CANCELING --CANCELED--> CANCELED, --SUCCEED--> SUCCEEDED, --ABORT--> ABORTED
"""

from __future__ import annotations

from enum import IntEnum

from tfloom.interfaces.action_msgs.msg import GoalStatus
from tfloom.node.values.exceptions import RCLError

__all__ = ["ACTIVE", "TERMINAL", "GoalEvent", "next_state"]


class GoalEvent(IntEnum):
    """Events of a goal."""

    EXECUTE = 0
    CANCEL_GOAL = 1
    SUCCEED = 2
    ABORT = 3
    CANCELED = 4


ACTIVE = (GoalStatus.STATUS_ACCEPTED, GoalStatus.STATUS_EXECUTING, GoalStatus.STATUS_CANCELING)
"""The states of a goal that hasn't ended."""
TERMINAL = (GoalStatus.STATUS_SUCCEEDED, GoalStatus.STATUS_CANCELED, GoalStatus.STATUS_ABORTED)
"""The states of a goal that has ended."""

_TRANSITIONS = {
    (GoalStatus.STATUS_ACCEPTED, GoalEvent.EXECUTE): GoalStatus.STATUS_EXECUTING,
    (GoalStatus.STATUS_ACCEPTED, GoalEvent.CANCEL_GOAL): GoalStatus.STATUS_CANCELING,
    (GoalStatus.STATUS_EXECUTING, GoalEvent.CANCEL_GOAL): GoalStatus.STATUS_CANCELING,
    (GoalStatus.STATUS_EXECUTING, GoalEvent.SUCCEED): GoalStatus.STATUS_SUCCEEDED,
    (GoalStatus.STATUS_EXECUTING, GoalEvent.ABORT): GoalStatus.STATUS_ABORTED,
    (GoalStatus.STATUS_CANCELING, GoalEvent.SUCCEED): GoalStatus.STATUS_SUCCEEDED,
    (GoalStatus.STATUS_CANCELING, GoalEvent.ABORT): GoalStatus.STATUS_ABORTED,
    (GoalStatus.STATUS_CANCELING, GoalEvent.CANCELED): GoalStatus.STATUS_CANCELED,
}
_NAMES = {
    value: name.removeprefix("STATUS_")
    for name, value in vars(GoalStatus).items()
    if name.startswith("STATUS_")
}


def next_state(status: int, event: GoalEvent) -> int:
    """Return the state after an event.

    Raises:
        RCLError: the event can't happen in this state.
    """
    next_status = _TRANSITIONS.get((status, event))
    if next_status is None:
        raise RCLError(
            f"goal_handle attempted invalid transition from state {_NAMES.get(status, status)} "
            f"with event {event.name}"
        )
    return next_status
