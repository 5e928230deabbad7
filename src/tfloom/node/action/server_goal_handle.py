"""The server's handle of a goal."""

from __future__ import annotations

import threading
from collections.abc import Callable, Coroutine
from typing import Any, Generic, Protocol

from tfloom.interfaces.action_msgs.msg import GoalInfo, GoalStatus
from tfloom.interfaces.unique_identifier_msgs.msg import UUID
from tfloom.node.action.goal_states import ACTIVE, GoalEvent, next_state
from tfloom.node.executing.task import Future
from tfloom.node.values.type_support import FeedbackT, GoalT, ResultT
from tfloom.rmw.typed_names import key_of
from tfloom.ros_imports.guard import ros_repr
from tfloom.ros_imports.ros_distro import FEEDBACK_NEEDS_EXECUTING

__all__ = ["GoalServer", "ServerGoalHandle"]


class GoalServer(Protocol):
    """The methods of an action server that a goal handle calls."""

    def notify_goal_done(self) -> None:
        """Publish the states of the goals, because one has changed."""

    def notify_execute(
        self, goal_handle: ServerGoalHandle, execute_callback: Callable[[ServerGoalHandle], Any] | None
    ) -> None:
        """Execute a goal by `execute_callback`; None: by the server's callback."""

    def publish_feedback(self, goal_id: UUID, feedback: Any) -> None:
        """Publish the feedback of a goal; TypeError if it isn't of the action's feedback type."""

    def forget(self, goal_handle: ServerGoalHandle) -> None:
        """Drop a goal."""

    def warn(self, text: str) -> None:
        """Log a warning."""


class ServerGoalHandle(Generic[GoalT, ResultT, FeedbackT]):
    """An accepted goal: its request, its state, and the methods that end it.

    After `destroy`, of the handle or of its server, the state is unknown and nothing more is published.
    """

    def __init__(self, action_server: GoalServer, goal_info: GoalInfo, goal_request: GoalT) -> None:
        self._server = action_server
        self._info = goal_info
        self._request = goal_request
        self._status: int = GoalStatus.STATUS_ACCEPTED
        self._lock = threading.Lock()
        """Guards changes of `_status`."""
        self._destroyed = False
        self.result_future: Future[Any] = Future()
        """Future of the response to requests for the result."""
        self.cancel_future: Future[None] = Future()
        """Done once cancelling is accepted, so that an execute callback can wait for it."""

    def __repr__(self) -> str:
        return ros_repr(self)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ServerGoalHandle) and key_of(self.goal_id) == key_of(other.goal_id)

    def __hash__(self) -> int:
        return hash(key_of(self.goal_id))

    @property
    def request(self) -> GoalT:
        """The goal's message."""
        return self._request

    @property
    def goal_id(self) -> UUID:
        """Id of the goal."""
        return self._info.goal_id

    @property
    def goal_info(self) -> GoalInfo:
        """Id of the goal, and the time at which it was accepted."""
        return self._info

    @property
    def status(self) -> int:
        """Its state, a constant of `action_msgs/msg/GoalStatus`."""
        return GoalStatus.STATUS_UNKNOWN if self._destroyed else self._status

    @property
    def is_active(self) -> bool:
        """Whether it has not ended."""
        return self.status in ACTIVE

    @property
    def is_cancel_requested(self) -> bool:
        """Whether cancellation was accepted; call `canceled` when the work has stopped."""
        return self.status == GoalStatus.STATUS_CANCELING

    def update(self, event: GoalEvent) -> None:
        """Change to the state that follows `event`, and publish it; do nothing if the goal is destroyed.

        Raises:
            RCLError: the event can't happen in this state.
        """
        with self._lock:
            if self._destroyed:
                return
            self._status = next_state(self._status, event)
        self._server.notify_goal_done()
        if event is GoalEvent.CANCEL_GOAL:
            self.cancel_future.set_result(None)

    _update_state = update  # rclpy's name, which programs that cancel a goal by themselves use

    def execute(
        self,
        execute_callback: Callable[
            [ServerGoalHandle[GoalT, ResultT, FeedbackT]], ResultT | Coroutine[Any, Any, ResultT]
        ]
        | None = None,
    ) -> None:
        """Execute the goal, by the server's callback or `execute_callback`.

        Raises:
            RCLError: it is executing, or has ended.
        """
        if self._destroyed:
            return
        # A goal may be cancelled before it begins; its callback is then called with CANCELING.
        if not self.is_cancel_requested:
            self.update(GoalEvent.EXECUTE)
        self._server.notify_execute(self, execute_callback)

    def publish_feedback(self, feedback: FeedbackT) -> None:
        """Publish feedback.

        Where ROS_DISTRO says Lyrical, feedback of a goal that isn't executing is ignored, with a warning.

        Raises:
            TypeError: `feedback` isn't of the action's feedback type.
        """
        if FEEDBACK_NEEDS_EXECUTING and self.status != GoalStatus.STATUS_EXECUTING:
            self._server.warn("publish_feedback() called on a goal handle not in executing state, ignoring")
        elif not self._destroyed:
            self._server.publish_feedback(self.goal_id, feedback)

    def succeed(self) -> None:
        """End as SUCCEEDED; RCLError if it isn't executing or canceling."""
        self.update(GoalEvent.SUCCEED)

    def abort(self) -> None:
        """End as ABORTED; RCLError if it isn't executing or canceling."""
        self.update(GoalEvent.ABORT)

    def canceled(self) -> None:
        """End as CANCELED; RCLError if it isn't canceling."""
        self.update(GoalEvent.CANCELED)

    def destroy(self) -> None:
        """Drop the goal: requests for its result get the status UNKNOWN."""
        self._destroyed = True
        self._server.forget(self)
