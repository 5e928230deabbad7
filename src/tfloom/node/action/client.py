"""Action clients, which send goals and receive feedback, states and results."""

from __future__ import annotations

import threading
import time
import weakref
from collections import OrderedDict
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from tfloom.common.seconds import checked_timeout
from tfloom.interfaces.action_msgs.msg import GoalInfo, GoalStatus, GoalStatusArray
from tfloom.interfaces.action_msgs.srv import CancelGoal, CancelGoal_Response
from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.unique_identifier_msgs.msg import UUID
from tfloom.node.action.goal_states import ACTIVE, TERMINAL
from tfloom.node.endpoints.client import ResponseFuture
from tfloom.node.executing.entity import make_parts
from tfloom.node.executing.executor import executor_of
from tfloom.node.executing.task import Future
from tfloom.node.executing.waitable import NumberOfEntities
from tfloom.node.qos.qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from tfloom.node.values.duration import S_TO_NS, Duration
from tfloom.node.values.names import name_error
from tfloom.node.values.type_support import (
    FeedbackMessageT,
    FeedbackT,
    GoalT,
    ResultResponseT,
    ResultT,
    WithDefaults,
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
    new_goal_id,
)
from tfloom.ros_imports.guard import ros_repr
from tfloom.rosidl.service import Action

if TYPE_CHECKING:
    from typing_extensions import Self

    from tfloom.node.clock.clock import Clock
    from tfloom.node.endpoints.client import Client
    from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState
    from tfloom.node.endpoints.subscription import MessageInfo
    from tfloom.node.executing.callback_groups import CallbackGroup
    from tfloom.node.node import Node
    from tfloom.rmw.base import Sample

__all__ = ["ActionClient", "ClientGoalHandle"]

T = TypeVar("T")

_POLL_S = 0.01
GOAL_ID = slice(4, 20)
"""Where the id of the goal is in encoded feedback: after the encapsulation header."""
MAX_ENDED = 64
"""Number of ended goals whose feedback callbacks are kept, because feedback may arrive behind the goal's end."""


class ClientGoalHandle(WithDefaults, Generic[GoalT, ResultT, FeedbackT, FeedbackMessageT, ResultResponseT]):
    """The client's handle of a goal."""

    def __init__(
        self,
        action_client: ActionClient[GoalT, ResultT, FeedbackT, FeedbackMessageT, ResultResponseT],
        goal_id: UUID,
        goal_response: Any,
    ) -> None:
        self._client = action_client
        self._goal_id = goal_id
        self._response = goal_response
        self.status: int = GoalStatus.STATUS_UNKNOWN
        """The last state received, a constant of `action_msgs/msg/GoalStatus`."""

    def __repr__(self) -> str:
        return ros_repr(self)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ClientGoalHandle) and key_of(self.goal_id) == key_of(other.goal_id)

    def __hash__(self) -> int:
        return hash(key_of(self.goal_id))

    @property
    def goal_id(self) -> UUID:
        """Id of the goal."""
        return self._goal_id

    @property
    def stamp(self) -> Time:
        """Time at which it was accepted."""
        stamp: Time = self._response.stamp
        return stamp

    @property
    def accepted(self) -> bool:
        """Whether the server accepted it."""
        return bool(self._response.accepted)

    def cancel_goal(self) -> CancelGoal_Response | None:
        """Request cancellation, and wait for the response; another thread must spin the node."""
        return self._client.wait_for(self.cancel_goal_async())

    def cancel_goal_async(self) -> Future[CancelGoal_Response]:
        """Request cancellation, and return the future of the `action_msgs/srv/CancelGoal` response."""
        return self._client.cancel(self._goal_id)

    def get_result(self) -> ResultResponseT | None:
        """Wait for the end, and return `.status` and `.result`; another thread must spin the node."""
        return self._client.wait_for(self.get_result_async())

    def get_result_async(self) -> Future[ResultResponseT]:
        """Request the result, and return its future, with `.status` and `.result`."""
        return self._client.get_result(self)


class ActionClient(WithDefaults, Generic[GoalT, ResultT, FeedbackT, FeedbackMessageT, ResultResponseT]):
    """Sends goals to an action server.

    Args:
        node: The node that sends.
        action_type: Class of the action.
        action_name: Its name; it is expanded and remapped.
        callback_group: Group of the feedback's callbacks; None: the node's own.
        goal_service_qos_profile: QoS of the service that accepts goals.
        result_service_qos_profile: QoS of the service that returns results.
        cancel_service_qos_profile: QoS of the service that cancels goals.
        feedback_sub_qos_profile: QoS of the feedback.
        status_sub_qos_profile: QoS of the goals' states.
        enable_feedback_msg_optimization: Whether feedback of other clients' goals is dropped by the goal's id alone,
            before it is decoded.

    Raises:
        AttributeError: `action_type` is not a ROS type.
        RuntimeError: `action_type` is a message or a service.
        InvalidServiceNameException: the name isn't valid.
    """

    def __init__(
        self,
        node: Node,
        action_type: type[Action[GoalT, ResultT, FeedbackT, FeedbackMessageT, ResultResponseT]],
        action_name: str,
        *,
        callback_group: CallbackGroup | None = None,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_sub_qos_profile: QoSProfile = QoSProfile(depth=10),  # never changed
        status_sub_qos_profile: QoSProfile = qos_profile_action_status_default,
        enable_feedback_msg_optimization: bool = False,
    ) -> None:
        check_is_valid_action_type(action_type)
        if (
            error := node_error("ActionClient", node) or name_error(action_name, is_service=True)
        ) is not None:
            raise error
        node.resolve_service_name(action_name + SEND_GOAL)  # raises here, near the program's line
        self._node = node
        self._action_type: type[Any] = action_type
        self._action_name = action_name
        self._lock = threading.Lock()
        """Guards the goals and their callbacks, below."""
        self._feedback_callbacks: dict[bytes, Callable[[FeedbackMessageT], Any]] = {}
        self._ended_ns: OrderedDict[bytes, int | None] = OrderedDict()
        """The goals that ended last, the oldest first: when the server sent the result, by its clock [ns since the
        epoch]; None where the result was not requested."""
        self._servers: dict[bytes, frozenset[Any]] = {}
        """The servers that were there when a goal with a feedback callback was sent."""
        self._unanswered: dict[bytes, int] = {}
        """The last state received of each goal whose request has no response yet. Guarded by `_lock`."""
        self._goals: weakref.WeakValueDictionary[
            bytes, ClientGoalHandle[GoalT, ResultT, FeedbackT, FeedbackMessageT, ResultResponseT]
        ] = weakref.WeakValueDictionary()

        def client(srv_type: Any, suffix: str, qos: QoSProfile) -> Client:
            return node.create_client(
                srv_type, action_name + suffix, qos_profile=qos, callback_group=callback_group
            )

        carrier = self._action_type.Impl
        self._send = client(carrier.SendGoalService, SEND_GOAL, goal_service_qos_profile)
        self._result = client(carrier.GetResultService, GET_RESULT, result_service_qos_profile)
        self._cancel = client(carrier.CancelGoalService, CANCEL_GOAL, cancel_service_qos_profile)
        self._feedback = node.create_subscription(
            carrier.FeedbackMessage,
            action_name + FEEDBACK,
            self._on_feedback,
            feedback_sub_qos_profile,
            callback_group=callback_group,
        )
        if enable_feedback_msg_optimization:
            self._feedback.filter_samples(self._is_of_own_goal)
        self._status = node.create_subscription(
            GoalStatusArray,
            action_name + STATUS,
            self._on_status,
            status_sub_qos_profile,
            callback_group=callback_group,
        )
        subscriptions = (self._feedback, self._status)
        handlers = [handler for subscription in subscriptions for handler in subscription.event_handlers]
        self.callback_group = callback_group or node.default_callback_group
        """The group of the feedback's callbacks."""
        make_parts(
            self,
            self.callback_group,
            (self._send, self._result, self._cancel, *subscriptions, *handlers),
        )

    def __repr__(self) -> str:
        return ros_repr(self)

    def server_is_ready(self) -> bool:
        """Return whether a server is matched by all services and topics, so that it receives a goal sent now."""
        return (
            all(client.service_is_ready() for client in (self._send, self._result, self._cancel))
            and self._feedback.get_publisher_count() > 0
            and self._status.get_publisher_count() > 0
        )

    def wait_for_server(self, timeout_sec: float | Duration | None = None) -> bool:
        """Wait until a server is ready; return False after `timeout_sec` [s] (None: no limit), or at shutdown."""
        if isinstance(timeout_sec, Duration):
            timeout_sec = timeout_sec.nanoseconds / S_TO_NS
        timeout_s = checked_timeout("wait_for_server", timeout_sec)
        end = None if timeout_s is None else time.monotonic() + timeout_s
        while self._node.context.ok():
            if self.server_is_ready():
                return True
            if end is not None and time.monotonic() >= end:
                return False
            time.sleep(_POLL_S)
        return False

    def send_goal_async(
        self,
        goal: GoalT,
        feedback_callback: Callable[[FeedbackMessageT], Any] | None = None,
        goal_uuid: UUID | None = None,
    ) -> Future[ClientGoalHandle[GoalT, ResultT, FeedbackT, FeedbackMessageT, ResultResponseT]]:
        """Send a goal.

        Args:
            goal: The goal's message.
            feedback_callback: Called with each feedback message, `.goal_id` and `.feedback`, until the goal ends.
            goal_uuid: Its id; None: a random one.

        Returns:
            The future of the goal's handle; its `accepted` is whether the server accepted the goal.

        Raises:
            TypeError: `goal` isn't of the action's goal type.
        """
        if not isinstance(goal, self._action_type.Goal):
            written = f"{self._action_type.__name__}.Goal"
            raise TypeError(wrong_fields(self._action_type.Goal, goal, "send a goal", written))
        if feedback_callback is not None and not callable(feedback_callback):
            raise TypeError(f"send_goal_async() needs a feedback callback, {not_callable(feedback_callback)}")
        goal_id = new_goal_id() if goal_uuid is None else goal_uuid
        key = key_of(goal_id)
        # All is registered before the request is sent: the goal's feedback and state are on their own topics, and
        # may be received before the response.
        # Only a feedback callback is kept until its goal ends: its servers are noted, so that it ends if they leave.
        if feedback_callback is not None:
            connected_servers = self._end_goals_of_servers_that_left()
        with self._lock:
            self._unanswered[key] = GoalStatus.STATUS_UNKNOWN
            if feedback_callback is not None:
                self._servers[key] = connected_servers
                self._feedback_callbacks[key] = feedback_callback
                self._ended_ns.pop(key, None)  # of an earlier goal with this id
        request = self._action_type.Impl.SendGoalService.Request(goal_id=goal_id, goal=goal)
        future: Future[ClientGoalHandle[GoalT, ResultT, FeedbackT, FeedbackMessageT, ResultResponseT]] = (
            Future()
        )

        def on_response(
            response: Any, stamp_ns: int | None
        ) -> ClientGoalHandle[GoalT, ResultT, FeedbackT, FeedbackMessageT, ResultResponseT]:
            handle = ClientGoalHandle(self, goal_id, response)
            if response.accepted:
                # Under one lock, so that `_on_status` always finds the goal in one of the two, and no state is lost.
                with self._lock:
                    handle.status = self._unanswered.pop(key, GoalStatus.STATUS_UNKNOWN)
                    self._goals[key] = handle
            else:
                self._end(key, stamp_ns)
            return handle

        try:
            answer = self._send.call_async(request)
        except BaseException:
            with self._lock:
                self._unanswered.pop(key, None)
                self._forget_feedback(key)
            raise
        self._chain(answer, future, on_response)
        # Added after that of `_chain`, and so called after it: `on_response` takes the state from `_unanswered`. This
        # one also forgets a goal whose future was cancelled, for which `on_response` isn't called.
        answer.when_complete(lambda: self._forget_answered(key, answer))
        return future

    def send_goal(self, goal: GoalT, **kwargs: Any) -> ResultResponseT | None:
        """Send a goal and wait for its end; another thread must spin the node.

        Args:
            goal: The goal's message.
            kwargs: As for `send_goal_async`.

        Returns:
            `.status` and `.result`; None if the server rejected the goal.
        """
        handle = self.wait_for(self.send_goal_async(goal, **kwargs))
        return handle.get_result() if handle is not None and handle.accepted else None

    def cancel(self, goal_id: UUID) -> Future[CancelGoal_Response]:
        """Request cancellation of a goal; goal handles call this."""
        return self._cancel.call_async(CancelGoal.Request(goal_info=GoalInfo(goal_id=goal_id)))

    def get_result(
        self, goal_handle: ClientGoalHandle[GoalT, ResultT, FeedbackT, FeedbackMessageT, ResultResponseT]
    ) -> Future[ResultResponseT]:
        """Request the result of a goal; goal handles call this."""
        request = self._action_type.Impl.GetResultService.Request(goal_id=goal_handle.goal_id)
        key = key_of(goal_handle.goal_id)
        future: Future[ResultResponseT] = Future()

        def on_response(response: Any, stamp_ns: int | None) -> Any:
            goal_handle.status = response.status
            self._end(key, stamp_ns)
            return response

        def end_if_lost() -> None:
            if not answer.cancelled() and answer.exception() is not None:  # its server has left
                self._end(key)

        answer = self._result.call_async(request)
        # The result may be received before feedback that was sent earlier, because they are on different endpoints.
        # What has arrived by then is delivered first, so that the future's completion is the end of the goal's
        # feedback.
        self._chain(answer, future, on_response, self._after_waiting_feedback)
        answer.when_complete(end_if_lost)
        return future

    def wait_for(self, future: Future[T]) -> T | None:
        """Wait for a future that another thread completes, or for shutdown."""
        executor = executor_of(self._node)
        if executor is not None and executor.would_wait_for_itself():
            raise RuntimeError(
                f"Waiting for the action {self._action_name} in a callback would never end, because its executor "
                "receives the response on this thread. Await the method's _async form, or use a MultiThreadedExecutor"
            )
        ended = threading.Event()
        future.when_complete(ended.set)
        self._node.context.add_shutdown_hook(ended.set)
        try:
            ended.wait()
        finally:
            self._node.context.remove_shutdown_hook(ended.set)
        return future.result()

    def _chain(
        self,
        first: Future[Any],
        then: Future[T],
        convert: Callable[[Any, int | None], T],
        after: Callable[[Callable[[], None]], None] | None = None,
    ) -> None:
        """When `first` completes with `result`, complete `then` with `convert(result, stamp_ns)`.

        `stamp_ns` is when the server sent the result, by its clock. `after` calls what it is given when that may be
        done; without it, it is done at once.
        """

        def complete() -> None:
            if then.cancelled():  # by the program, which no longer waits
                return
            if first.cancelled():
                then.cancel()
                return
            if (error := first.exception()) is not None:
                then.set_executor(executor_of(self._node))
                then.set_exception(error)
                return
            if after is None:
                finish()
            else:
                after(finish)

        def finish() -> None:
            if then.cancelled():
                return
            # The executor of now: the node may have been added to one after the request was sent.
            then.set_executor(executor_of(self._node))
            stamp_ns = first.source_stamp_ns if isinstance(first, ResponseFuture) else None
            then.set_result(convert(first.result(), stamp_ns))

        first.when_complete(complete)

    def _forget_answered(self, key: bytes, answer: Future[Any]) -> None:
        with self._lock:
            self._unanswered.pop(key, None)
            if answer.exception() is not None:  # no server has the goal
                self._forget_feedback(key)

    def _forget_feedback(self, key: bytes) -> None:
        self._feedback_callbacks.pop(key, None)
        self._servers.pop(key, None)

    def _end_goals_of_servers_that_left(self) -> frozenset[Any]:
        """End the goals whose servers have all left, and return the servers that are there.

        A server that is killed sends neither a status nor a result, and the program may never request the result. So
        that goals of such servers don't add up, they are looked for when another one is sent.
        """
        connected = self._send.wire_endpoint.connected_servers()
        with self._lock:
            orphaned_keys = [
                key
                for key, servers in self._servers.items()
                if key not in self._ended_ns and servers and servers.isdisjoint(connected)
            ]
        for key in orphaned_keys:
            self._end(key)
        return frozenset(connected)

    def _end(self, key: bytes, stamp_ns: int | None = None) -> None:
        """End a goal's feedback: what the server sent after its result, at `stamp_ns` by its clock, isn't delivered.

        The stamps of feedback are compared with that of the result, and never with the time here: the server may run
        on another host, whose clock differs. Without a stamp, all that still arrives is delivered. Only the goals that
        ended last keep their callbacks.
        """
        with self._lock:
            if key not in self._feedback_callbacks:
                return
            self._ended_ns[key] = stamp_ns
            if len(self._ended_ns) > MAX_ENDED:
                self._forget_feedback(self._ended_ns.popitem(last=False)[0])

    def _is_of_own_goal(self, sample: Sample) -> bool:
        """Return whether feedback, which begins with the goal's id, has a callback here."""
        return sample.data[GOAL_ID] in self._feedback_callbacks

    def _on_feedback(self, message: Any, info: MessageInfo) -> Any:
        key = key_of(message.goal_id)
        callback = self._feedback_callbacks.get(key)
        ended_ns = self._ended_ns.get(key)
        if callback is None or (ended_ns is not None and info["source_timestamp"] > ended_ns):
            return None
        return callback(message)

    def _after_waiting_feedback(self, finish: Callable[[], None]) -> None:
        executor = executor_of(self._node)
        if executor is None:
            finish()
        else:
            # What the program's callback raises goes on to the spin, and `finish` is called nevertheless, because no
            # other response would complete the future.
            executor.run_waiting(self._feedback, finish)

    def _on_status(self, message: GoalStatusArray) -> None:
        for goal_status in message.status_list:
            key = key_of(goal_status.goal_info.goal_id)
            with self._lock:
                # The server publishes the state of a goal it has accepted, maybe before its response is received here.
                # There is no handle yet to store it in.
                if key in self._unanswered:
                    self._unanswered[key] = goal_status.status
                handle = self._goals.get(key)
                has_ended = goal_status.status in TERMINAL and key not in self._ended_ns
            if has_ended:  # by itself, because nobody may ever request the result
                self._end(key)
            # The status in the result is the final one.
            if handle is not None and (handle.status in ACTIVE or handle.status == GoalStatus.STATUS_UNKNOWN):
                handle.status = goal_status.status

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
        for client in (self._send, self._cancel, self._result):
            client.configure_introspection(clock, service_event_qos_profile, introspection_state)

    def get_num_entities(self) -> NumberOfEntities:
        """Return how many items of each kind the client consists of."""
        return NumberOfEntities(num_subs=2, num_clients=3)

    def destroy(self) -> None:
        """Destroy the clients and subscriptions."""
        for client in (self._send, self._result, self._cancel):
            self._node.destroy_client(client)
        self._node.destroy_subscription(self._feedback)
        self._node.destroy_subscription(self._status)

    def __enter__(self) -> Self:
        with self._send.handle:  # raises InvalidHandle after `destroy`
            return self

    def __exit__(self, *_: object) -> None:
        self.destroy()
