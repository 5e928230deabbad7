"""Action servers, which accept goals and execute them."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Coroutine
from contextlib import suppress
from enum import Enum
from functools import partial
from typing import TYPE_CHECKING, Any, Generic

from tfloom.common.seconds import checked_timeout, to_nanoseconds
from tfloom.interfaces.action_msgs.msg import GoalInfo, GoalStatus, GoalStatusArray
from tfloom.interfaces.action_msgs.srv import CancelGoal_Request, CancelGoal_Response
from tfloom.interfaces.unique_identifier_msgs.msg import UUID
from tfloom.node.action.goal_states import GoalEvent
from tfloom.node.action.server_goal_handle import ServerGoalHandle
from tfloom.node.clock.clock import ROSClock
from tfloom.node.endpoints.service import ResponseFirst
from tfloom.node.executing.entity import make_parts
from tfloom.node.executing.executors import await_or_execute
from tfloom.node.executing.waitable import NumberOfEntities
from tfloom.node.qos.qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from tfloom.node.values.callback_errors import print_error
from tfloom.node.values.duration import S_TO_NS
from tfloom.node.values.exceptions import InvalidHandle, RCLError
from tfloom.node.values.names import name_error
from tfloom.node.values.type_support import (
    FeedbackT,
    GoalT,
    ResultT,
    check_is_valid_action_type,
    wrong_fields,
)
from tfloom.node.values.wrong_arguments import node_error, not_callable
from tfloom.rmw.typed_names import (
    CANCEL_GOAL,
    FEEDBACK,
    GET_RESULT,
    SEND_GOAL,
    STATUS,
    key_of,
)
from tfloom.ros_imports.guard import ros_repr
from tfloom.ros_imports.ros_distro import RESULT_TIMEOUT_S
from tfloom.rosidl.service import Action

if TYPE_CHECKING:
    from typing import TypeAlias

    from typing_extensions import Self

    from tfloom.node.clock.clock import Clock
    from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState
    from tfloom.node.executing.callback_groups import CallbackGroup
    from tfloom.node.executing.timer import Timer
    from tfloom.node.node import Node

__all__ = [
    "ActionServer",
    "CancelResponse",
    "GoalResponse",
    "ServerGoalHandle",
    "default_cancel_callback",
    "default_goal_callback",
    "default_handle_accepted_callback",
]

_NO_ID = bytes(16)


class GoalResponse(Enum):
    """Results of goal callbacks."""

    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    """Results of cancel callbacks."""

    REJECT = 1
    ACCEPT = 2


if TYPE_CHECKING:
    ExecuteCallback: TypeAlias = Callable[
        [ServerGoalHandle[GoalT, ResultT, FeedbackT]], ResultT | Coroutine[Any, Any, ResultT]
    ]
    GoalCallback: TypeAlias = Callable[[GoalT], GoalResponse | Coroutine[Any, Any, GoalResponse]]
    HandleAcceptedCallback: TypeAlias = Callable[[ServerGoalHandle[GoalT, ResultT, FeedbackT]], Any]
    CancelCallback: TypeAlias = Callable[
        [ServerGoalHandle[GoalT, ResultT, FeedbackT]], CancelResponse | Coroutine[Any, Any, CancelResponse]
    ]


def default_handle_accepted_callback(goal_handle: ServerGoalHandle) -> None:
    """Execute the goal."""
    goal_handle.execute()


def default_goal_callback(goal_request: Any) -> GoalResponse:
    """Accept all goals."""
    return GoalResponse.ACCEPT


def default_cancel_callback(cancel_request: Any) -> CancelResponse:
    """Reject all requests for cancellation."""
    return CancelResponse.REJECT


class ActionServer(Generic[GoalT, ResultT, FeedbackT]):
    """Accepts goals and executes them, several at once if the executor has threads or the callback is a coroutine.

    Args:
        node: The node that serves.
        action_type: Class of the action.
        action_name: Its name; it is expanded and remapped.
        execute_callback: Called with a goal handle; ends the goal, and returns its result. It runs as a task of the
            executor, in no callback group. None: `handle_accepted_callback` executes goals by a callback that it
            passes to their `execute`.
        callback_group: Group of the three callbacks below; None: the node's own.
        goal_callback: Called with a goal; returns whether it is accepted. Default: accept.
        handle_accepted_callback: Called with the handle of an accepted goal. Default: execute it.
        cancel_callback: Called with the handle of a goal; returns whether cancellation is accepted. Default: reject.
        goal_service_qos_profile: QoS of the service that accepts goals.
        result_service_qos_profile: QoS of the service that returns results.
        cancel_service_qos_profile: QoS of the service that cancels goals.
        feedback_pub_qos_profile: QoS of the feedback.
        status_pub_qos_profile: QoS of the goals' states.
        result_timeout: Time for which the result of an ended goal is kept [s], by simulated time where the node has
            that; negative: no limit. By default 900, from Kilted on 10.
        forget_sent_results: Whether a goal is dropped as soon as its result was sent to one client.

    Raises:
        AttributeError: `action_type` is not a ROS type.
        RuntimeError: `action_type` is a message or a service.
        InvalidServiceNameException: the name isn't valid.
    """

    def __init__(
        self,
        node: Node,
        action_type: type[Action[GoalT, ResultT, FeedbackT]],
        action_name: str,
        execute_callback: ExecuteCallback[GoalT, ResultT, FeedbackT] | None,
        *,
        callback_group: CallbackGroup | None = None,
        goal_callback: GoalCallback[GoalT] = default_goal_callback,
        handle_accepted_callback: HandleAcceptedCallback[
            GoalT, ResultT, FeedbackT
        ] = default_handle_accepted_callback,
        cancel_callback: CancelCallback[GoalT, ResultT, FeedbackT] = default_cancel_callback,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_pub_qos_profile: QoSProfile = QoSProfile(depth=10),  # never changed
        status_pub_qos_profile: QoSProfile = qos_profile_action_status_default,
        result_timeout: float = RESULT_TIMEOUT_S,
        forget_sent_results: bool = False,
    ) -> None:
        check_is_valid_action_type(action_type)
        if (
            error := node_error("ActionServer", node) or name_error(action_name, is_service=True)
        ) is not None:
            raise error
        node.resolve_service_name(action_name + SEND_GOAL)  # raises here, near the program's line
        self._node = node
        self._clock = node.get_clock()
        self._action_type: type[Any] = action_type
        timeout_s = checked_timeout("ActionServer", result_timeout)
        self._result_timeout_ns = -1 if timeout_s is None else to_nanoseconds(timeout_s)
        self._forgets_sent_results = forget_sent_results
        self._lock = threading.RLock()
        """Guards the four below."""
        self._is_status_stale = False
        """Whether a goal has changed since the states were read that were published last."""
        self._is_publishing_status = False
        """Whether a thread publishes the states."""
        self._goal_handles: dict[bytes, ServerGoalHandle[GoalT, ResultT, FeedbackT]] = {}
        self._ended: dict[bytes, tuple[bool, int]] = {}
        """When the goals ended, as `_now` tells."""
        self._execute_callback: ExecuteCallback[GoalT, ResultT, FeedbackT] = _checked_callable(
            execute_callback, "goal execution", _no_execute_callback
        )
        self._goal_callback = _checked_callable(goal_callback, "goal", default_goal_callback)
        self._handle_accepted_callback = _checked_callable(
            handle_accepted_callback, "handle accepted", default_handle_accepted_callback
        )
        self._cancel_callback = _checked_callable(cancel_callback, "cancel", default_cancel_callback)
        carrier = self._action_type.Impl
        services = (
            (carrier.GetResultService, GET_RESULT, self._on_result, result_service_qos_profile),
            (carrier.CancelGoalService, CANCEL_GOAL, self._on_cancel, cancel_service_qos_profile),
            (carrier.SendGoalService, SEND_GOAL, self._on_goal, goal_service_qos_profile),
        )
        self._feedback = node.create_publisher(
            carrier.FeedbackMessage, action_name + FEEDBACK, feedback_pub_qos_profile
        )
        self._status = node.create_publisher(GoalStatusArray, action_name + STATUS, status_pub_qos_profile)
        self._expiry: Timer = node.create_timer(3600.0, self._drop_expired_goals, autostart=False)
        # The services come last, and that of goals after the two others: where other threads spin the node, a goal can
        # arrive as soon as its service is there, from a client that knew the server before this one. It is executed at
        # once then, which takes all of the above, and its client asks for its result.
        self._services = [
            node.create_service(
                srv_type, action_name + suffix, callback, qos_profile=qos, callback_group=callback_group
            )
            for srv_type, suffix, callback, qos in services
        ]
        handlers = [
            handler for publisher in (self._feedback, self._status) for handler in publisher.event_handlers
        ]
        self.callback_group = callback_group or node.default_callback_group
        """The group of the callbacks, but for that of execution."""
        make_parts(
            self,
            self.callback_group,
            (*self._services, self._expiry, *handlers),
        )

    def __repr__(self) -> str:
        return ros_repr(self)

    @property
    def action_type(self) -> type[Action[GoalT, ResultT, FeedbackT]]:
        """Class of the action."""
        return self._action_type

    def register_execute_callback(self, execute_callback: ExecuteCallback[GoalT, ResultT, FeedbackT]) -> None:
        """Set the callback that executes goals; TypeError if it isn't callable."""
        self._execute_callback = _checked_callable(execute_callback, "goal execution")

    def register_goal_callback(self, goal_callback: GoalCallback[GoalT] | None) -> None:
        """Set the callback that accepts or rejects goals; None: accept all."""
        self._goal_callback = _checked_callable(goal_callback, "goal", default_goal_callback)

    def register_handle_accepted_callback(
        self, handle_accepted_callback: HandleAcceptedCallback[GoalT, ResultT, FeedbackT] | None
    ) -> None:
        """Set the callback for accepted goals; None: execute them."""
        self._handle_accepted_callback = _checked_callable(
            handle_accepted_callback, "handle accepted", default_handle_accepted_callback
        )

    def register_cancel_callback(
        self, cancel_callback: CancelCallback[GoalT, ResultT, FeedbackT] | None
    ) -> None:
        """Set the callback that accepts or rejects cancellation; None: reject."""
        self._cancel_callback = _checked_callable(cancel_callback, "cancel", default_cancel_callback)

    # Goals

    async def _on_goal(self, request: Any, response: Any) -> Any:
        key = key_of(request.goal_id)
        response.accepted = key not in self._goal_handles and await self._is_goal_accepted(request.goal)
        if not response.accepted:
            return response
        response.stamp = self._node.get_clock().now().to_msg()
        handle = ServerGoalHandle(self, GoalInfo(goal_id=request.goal_id, stamp=response.stamp), request.goal)
        with self._lock:
            self._goal_handles[key] = handle
        self._publish_status()
        # The response is sent before the callback is called, which may execute the whole goal: otherwise the client
        # would learn that its goal was accepted when that has ended.
        return ResponseFirst(response, lambda: await_or_execute(self._handle_accepted_callback, handle))

    async def _is_goal_accepted(self, goal: Any) -> bool:
        response = await await_or_execute(self._goal_callback, goal)
        if not isinstance(response, GoalResponse):
            self._node.get_logger().get_child("action_server").warning(
                "Goal request callback did not return a GoalResponse type. Rejecting goal."
            )
        return response is GoalResponse.ACCEPT

    def _start(self, callback: Callable[..., Any], *args: Any) -> None:
        executor = self._node.executor
        if executor is None or executor.is_shutdown:
            raise RCLError("cannot run a goal: no executor spins the action server's node")
        executor.create_task(callback, *args)

    def notify_execute(
        self, goal_handle: ServerGoalHandle, execute_callback: Callable[[ServerGoalHandle], Any] | None
    ) -> None:
        """Execute a goal; goal handles call this."""
        callback = execute_callback if execute_callback is not None else self._execute_callback
        self._start(self._execute, _checked_callable(callback, "goal execution"), goal_handle)

    async def _execute(self, callback: Callable[[ServerGoalHandle], Any], handle: ServerGoalHandle) -> None:
        try:
            result = await await_or_execute(callback, handle)
        except Exception as error:  # the goal fails, not the server
            if self._node.context.is_caused_by_signal(error):
                raise
            self._node.get_logger().get_child("action_server").error(
                f"Error raised in execute callback: {error}"
            )
            print_error(error)
            result = None
        # The callback has raised, or returned without an end of the goal. The client waits for its result in any case.
        if handle.is_active:
            goal_id = key_of(handle.goal_id).hex()
            self._node.get_logger().get_child("action_server").warning(
                f"Goal state not set, assuming aborted. Goal ID: {goal_id}"
            )
            handle.abort()
        response = self._action_type.Impl.GetResultService.Response(status=handle.status)
        if isinstance(result, self._action_type.Result):
            response.result = result
        elif result is not None:
            self._node.get_logger().get_child("action_server").error(
                f"The execute callback returned a {type(result).__name__}, not a {self._action_type.Result.__name__}"
            )
        # This sends the response to each request for the result that came before the end.
        handle.result_future.set_result(response)
        key = key_of(handle.goal_id)
        if self._goal_handles.get(key) is handle:  # otherwise the goal, or the server, was destroyed
            self._record_end(key)

    def _on_result(self, request: Any, response: Any) -> Any:
        handle = self._goal_handles.get(key_of(request.goal_id))
        if handle is None:
            response.status = GoalStatus.STATUS_UNKNOWN
            return response
        if self._forgets_sent_results:
            handle.result_future.when_complete(handle.destroy)
        # The service sends what the future is completed with: at once after the goal's end; before it, the request
        # waits without a thread.
        return handle.result_future

    # Cancelling

    async def _on_cancel(
        self, request: CancelGoal_Request, response: CancelGoal_Response
    ) -> CancelGoal_Response | ResponseFirst:
        goals = self._goals_to_cancel(request)
        key = key_of(request.goal_info.goal_id)
        # A request for one goal by its id alone has its own code for a goal that can't be cancelled. One for a
        # time, or for all goals, is answered by an empty list.
        if not goals and key != _NO_ID and not _stamp_ns(request.goal_info):
            is_known = key in self._goal_handles
            response.return_code = (
                response.ERROR_GOAL_TERMINATED if is_known else response.ERROR_UNKNOWN_GOAL_ID
            )
            return response
        raised: list[Exception] = []
        for handle in goals:
            try:
                answer = await await_or_execute(self._cancel_callback, handle)
            except Exception as error:  # raised below; the others are asked, and the client gets a response
                raised.append(error)
                continue
            if answer is not CancelResponse.ACCEPT:
                continue
            try:
                handle.update(GoalEvent.CANCEL_GOAL)
            except RCLError:  # it ended during its callback
                continue
            response.goals_canceling.append(handle.goal_info)
        if goals and not response.goals_canceling:
            response.return_code = response.ERROR_REJECTED
        return ResponseFirst(response, partial(_raise_all, raised)) if raised else response

    def _goals_to_cancel(
        self, request: CancelGoal_Request
    ) -> list[ServerGoalHandle[GoalT, ResultT, FeedbackT]]:
        """Return the goals of a request: one by its id, all up to a time, or all."""
        key = key_of(request.goal_info.goal_id)
        until_ns = _stamp_ns(request.goal_info)
        with self._lock:
            goals = dict(self._goal_handles)
        # As the action protocol has it: an id alone means that goal, a time alone all that were accepted up to then,
        # both mean that goal and those, and neither means all goals.
        return [
            handle
            for goal_key, handle in goals.items()
            if handle.status in (GoalStatus.STATUS_ACCEPTED, GoalStatus.STATUS_EXECUTING)
            and (
                goal_key == key
                or (until_ns and _stamp_ns(handle.goal_info) <= until_ns)
                or (key == _NO_ID and not until_ns)
            )
        ]

    # Publishing

    def publish_feedback(self, goal_id: UUID, feedback: Any) -> None:
        """Publish the feedback of a goal; goal handles call this."""
        if not isinstance(feedback, self._action_type.Feedback):
            written = f"{self._action_type.__name__}.Feedback"
            raise TypeError(wrong_fields(self._action_type.Feedback, feedback, "publish feedback", written))
        message = self._action_type.Impl.FeedbackMessage(goal_id=goal_id, feedback=feedback)
        with suppress(InvalidHandle):
            self._feedback.publish(message)

    def warn(self, text: str) -> None:
        """Log a warning; goal handles call this."""
        self._node.get_logger().get_child("action_server").warning(text)

    def notify_goal_done(self) -> None:
        """Publish the states of the goals, because one has changed; goal handles call this."""
        self._publish_status()

    def _publish_status(self) -> None:
        # Goals change on several threads. If each published what it has read, an older list could be the last one,
        # which clients would keep. So one thread publishes at a time, and again if another has asked meanwhile. It
        # holds no lock while it does, because a program's code may run in it.
        with self._lock:
            self._is_status_stale = True
            if self._is_publishing_status:
                return
            self._is_publishing_status = True
        try:
            while self._publish_stale_status():
                pass
        except BaseException:
            with self._lock:
                self._is_publishing_status = False
            raise

    def _publish_stale_status(self) -> bool:
        """Publish the states of the goals if they have changed, and return whether they had."""
        with self._lock:
            if not self._is_status_stale:
                self._is_publishing_status = False
                return False
            self._is_status_stale = False
            goals = list(self._goal_handles.values())
        if self._node.context.ok():
            with suppress(InvalidHandle):  # the node was destroyed meanwhile
                self._status.publish(
                    GoalStatusArray(
                        status_list=[
                            GoalStatus(goal_info=goal.goal_info, status=goal.status) for goal in goals
                        ]
                    )
                )
        return True

    # Dropping goals

    def forget(self, goal_handle: ServerGoalHandle) -> None:
        """Drop a goal and its result: later requests for it are those for an unknown goal."""
        key = key_of(goal_handle.goal_id)
        with self._lock:
            self._goal_handles.pop(key, None)
            self._ended.pop(key, None)

    def _now(self) -> tuple[bool, int]:
        """Return whether time is simulated, and the time [ns]: that, or the steady clock's, which nobody sets."""
        is_simulated = isinstance(self._clock, ROSClock) and self._clock.ros_time_is_active
        return is_simulated, self._clock.now_ns() if is_simulated else time.monotonic_ns()

    def _record_end(self, key: bytes) -> None:
        if self._result_timeout_ns < 0:
            return
        with self._lock:
            if key not in self._goal_handles:  # dropped before
                return
            self._ended[key] = self._now()
        self._drop_expired_goals()

    def _drop_expired_goals(self) -> None:
        """Drop the goals whose results have expired, and set the timer to the next expiry."""
        is_simulated, now_ns = self._now()
        with self._lock:
            for key, (was_simulated, ended_ns) in list(self._ended.items()):
                if was_simulated != is_simulated or ended_ns > now_ns:
                    # Of another clock, or before a jump back, as when a simulation begins again: its time begins anew.
                    self._ended[key] = (is_simulated, now_ns)
                elif ended_ns + self._result_timeout_ns <= now_ns:
                    self._goal_handles.pop(key, None)
                    del self._ended[key]
            oldest_ns = min((ended_ns for _, ended_ns in self._ended.values()), default=None)
        # One timer for all goals, set to the oldest of those that are left.
        with suppress(InvalidHandle):  # the node was destroyed while a goal was executed
            if oldest_ns is None:
                self._expiry.cancel()
                return
            self._expiry.timer_period_ns = max(1, oldest_ns + self._result_timeout_ns - now_ns)
            self._expiry.reset()

    def configure_introspection(
        self,
        clock: Clock,
        service_event_qos_profile: QoSProfile,
        introspection_state: ServiceIntrospectionState,
    ) -> None:
        """Publish requests and responses on `<action>/_action/<service>/_service_event`, for each of three services.

        These are `send_goal`, `cancel_goal` and `get_result`.

        Args:
            clock: Stamps the events.
            service_event_qos_profile: QoS of the events' publishers.
            introspection_state: OFF, METADATA, or CONTENTS, with requests and responses.

        Raises:
            InvalidHandle: it was destroyed.
        """
        for service in self._services:
            service.configure_introspection(clock, service_event_qos_profile, introspection_state)

    def get_num_entities(self) -> NumberOfEntities:
        """Return how many items of each kind the server consists of."""
        return NumberOfEntities(num_services=3, num_timers=1)

    def destroy(self) -> None:
        """Destroy the services and publishers. Goals continue to execute, and nothing is published about them."""
        with self._lock:
            goals = list(self._goal_handles.values())
        for goal in goals:
            goal.destroy()
        for service in self._services:
            self._node.destroy_service(service)
        self._node.destroy_publisher(self._feedback)
        self._node.destroy_publisher(self._status)
        self._node.destroy_timer(self._expiry)

    def __enter__(self) -> Self:
        with self._services[0].handle:  # raises InvalidHandle after `destroy`
            return self

    def __exit__(self, *_: object) -> None:
        self.destroy()


async def _raise_all(errors: list[Exception]) -> None:
    for error in errors[1:]:
        print_error(error)
    raise errors[0]


def _no_execute_callback(goal_handle: ServerGoalHandle) -> None:
    """Fail a goal that is executed without a callback."""
    raise TypeError(
        "the action server has no execute callback, and the goal was executed without one: give "
        "handle_accepted_callback a function that calls goal_handle.execute(callback)"
    )


def _checked_callable(callback: Any, what: str, default: Any = None) -> Any:
    """Return the callback, or the default for None, so that constructors and setters raise the same error."""
    callback = callback or default
    if not callable(callback):
        raise TypeError(f"Failed to register {what} callback: not callable, {not_callable(callback)}")
    return callback


def _stamp_ns(info: GoalInfo) -> int:
    return info.stamp.sec * S_TO_NS + info.stamp.nanosec
