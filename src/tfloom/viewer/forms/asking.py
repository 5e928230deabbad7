"""A call of one service, and a goal of one action, in steps that never wait."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom.interfaces.action_msgs.msg import GoalInfo
from tfloom.rmw.qos import QoS
from tfloom.rmw.shared.service_request import ServiceRequest, ServiceRequestError
from tfloom.rmw.typed_names import (
    CANCEL_GOAL,
    CANCEL_REFUSALS,
    FEEDBACK,
    GET_RESULT,
    GOAL_STATUS,
    SEND_GOAL,
    key_of,
    new_goal_id,
    topic_of,
)
from tfloom.rosidl import cdr
from tfloom.rosidl.yaml_text import message_to_yaml
from tfloom.viewer.forms.task import Task
from tfloom.viewer.page_command import PageError

if TYPE_CHECKING:
    from tfloom._native import ReadyQueue
    from tfloom.rmw.base import NodeName, Participant

__all__ = ["Call", "Goal", "Wire"]

CANCEL_S = 3.0
"""The longest wait for the response to a goal's cancellation [s]."""
FEEDBACK_S = 0.2
"""Least time between two feedbacks that a page gets [s]."""
MAX_FEEDBACK = 100
"""Number of feedbacks that are taken at once, of which the newest counts."""
MAX_ELEMENTS = 100
"""Length of arrays and texts of a message that is shown."""

Tell = Callable[[str, str], None]
"""Tells a page of what was sent: a state (`waiting`, `accepted`, `feedback`, `done` or `error`), and a text."""


class Wire(NamedTuple):
    """What ends of services and topics are created with."""

    participant: Participant
    node: NodeName
    arrived: ReadyQueue
    """Gets a token when something may have arrived."""

    def request(self, name: str, service_class: type[Any]) -> ServiceRequest:
        """Return a request of a service, by its full name."""
        return ServiceRequest(self.participant, self.node, name, service_class, self.arrived)


class Call(Task):
    """A call of a service, of which the response is told. One thread may use it.

    Args:
        wire: What its end is created with.
        name: The full name of the service.
        service_class: Its class.
        request: The bytes of the request.
        tell: Tells the page.
    """

    def __init__(self, wire: Wire, name: str, service_class: type[Any], request: bytes, tell: Tell) -> None:
        self._request = wire.request(name, service_class)
        self._request.ask(request)
        self._tell = tell

    def step(self) -> bool:
        """Do what can be done now; return whether the call is over.

        Raises:
            PageError, ServiceRequestError: it has failed.
        """
        response = self._request.take()
        if response is None:
            return False
        self._tell("done", _text_of(response) or "the response has no fields")
        return True

    def close(self) -> None:
        """Leave the service; a server can't be told that nobody waits."""
        self._request.close()


class Goal(Task):
    """A goal of an action, of which feedback and result are told. One thread may use it.

    Args:
        wire: What its ends are created with.
        name: The full name of the action.
        action_class: Its class.
        goal: The goal.
        tell: Tells the page.
    """

    def __init__(self, wire: Wire, name: str, action_class: type[Any], goal: Any, tell: Tell) -> None:
        self._tell = tell
        parts = action_class.Impl
        self._feedback_class = parts.FeedbackMessage
        self._id = new_goal_id()
        # Before the services, because a server discovers ends in the order of their creation: one that responds to a
        # goal then sends its feedback here, too.
        self._feedback = wire.participant.create_reader(
            wire.node, topic_of(self._feedback_class, name + FEEDBACK), QoS()
        )
        self._feedback.notify(wire.arrived, 1)
        self._requests: list[ServiceRequest] = []
        try:
            self._accepting = self._open(wire, name + SEND_GOAL, parts.SendGoalService)
            self._resulting = self._open(wire, name + GET_RESULT, parts.GetResultService)
            self._cancelling = self._open(wire, name + CANCEL_GOAL, parts.CancelGoalService)
        except BaseException:
            self.close()
            raise
        self._result_request = cdr.encode(parts.GetResultService.Request(goal_id=self._id))
        self._cancel_request = cdr.encode(
            parts.CancelGoalService.Request(goal_info=GoalInfo(goal_id=self._id))
        )
        self._accepting.ask(cdr.encode(parts.SendGoalService.Request(goal_id=self._id, goal=goal)))
        self._is_accepted = False
        self._is_cancel_wanted = False
        self._is_cancelling = False
        self._newest: Any = None
        """The newest feedback that the page has not been told."""
        self._next_feedback_s = 0.0

    def _open(self, wire: Wire, name: str, service_class: type[Any]) -> ServiceRequest:
        request = wire.request(name, service_class)
        self._requests.append(request)
        return request

    def step(self) -> bool:
        """Do what can be done now; return whether the goal has ended.

        Raises:
            PageError, ServiceRequestError: it has failed.
        """
        self._take_feedback()
        if not self._is_accepted:
            response = self._accepting.take()
            if response is None:
                return False
            if not response.accepted:
                raise PageError("the server rejected the goal")
            self._is_accepted = True
            self._tell("accepted", "the goal is accepted")
            self._resulting.ask(self._result_request, response_s=math.inf)
        if self._is_cancel_wanted:
            self._is_cancel_wanted, self._is_cancelling = False, True
            self._cancelling.ask(self._cancel_request, response_s=CANCEL_S)
        if self._is_cancelling:
            self._take_cancellation()
        result = self._resulting.take()
        if result is None:
            self._tell_feedback(time.monotonic())
            return False
        self._take_feedback()
        self._tell_feedback(math.inf)
        status = GOAL_STATUS[result.status] if 0 <= result.status < len(GOAL_STATUS) else str(result.status)
        self._tell("done", f"{status}\n{_text_of(result.result)}")
        return True

    def _take_feedback(self) -> None:
        for _ in range(MAX_FEEDBACK):
            sample = self._feedback.take()
            if sample is None:
                return
            try:
                message = cdr.decode(self._feedback_class, sample.data)
            except cdr.DecodeError:
                continue
            if key_of(message.goal_id) == key_of(self._id):
                self._newest = message.feedback

    def _tell_feedback(self, now_s: float) -> None:
        if self._newest is not None and now_s >= self._next_feedback_s:
            self._next_feedback_s = time.monotonic() + FEEDBACK_S
            self._tell("feedback", _text_of(self._newest))
            self._newest = None

    def _take_cancellation(self) -> None:
        try:
            response = self._cancelling.take()
        except ServiceRequestError as error:
            self._is_cancelling = False
            self._tell("accepted", str(error))
            return
        if response is None:
            return
        self._is_cancelling = False
        if any(key_of(info.goal_id) == key_of(self._id) for info in response.goals_canceling):
            self._tell("accepted", "the goal is being canceled")
        else:
            reason = CANCEL_REFUSALS.get(response.return_code, "no reason given")
            self._tell("accepted", f"the server did not cancel the goal: {reason}")

    def cancel(self) -> bool:
        """Let the server be asked to cancel the goal; return whether it is over, because it was never sent.

        A goal that was sent may be accepted yet, so it is cancelled then.
        """
        self._is_cancel_wanted = not self._is_cancelling
        return not self._accepting.is_sent

    def close(self) -> None:
        """Leave the action."""
        self._feedback.close()
        for request in self._requests:
            request.close()


def _text_of(message: Any) -> str:
    """Return a message as YAML, with long arrays and texts cut."""
    return message_to_yaml(message, truncate_length=MAX_ELEMENTS) if type(message)._FIELDS else ""
