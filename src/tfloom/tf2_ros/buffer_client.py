"""Lookups in the buffer of another program."""

from __future__ import annotations

import math
import time as steady
from typing import TYPE_CHECKING, Any

from tfloom.common.seconds import checked_timeout
from tfloom.interfaces.builtin_interfaces.msg import Duration as DurationMessage
from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMessage
from tfloom.interfaces.tf2_msgs.msg import TF2Error
from tfloom.node.endpoints.client import NoResponseError
from tfloom.node.executing.executor import executor_of
from tfloom.node.executing.lone_spin import wait_for_future
from tfloom.node.executing.task import Future
from tfloom.node.values.duration import Duration
from tfloom.node.values.names import name_error
from tfloom.node.values.wrong_arguments import node_error
from tfloom.tf2.errors import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)
from tfloom.tf2_ros.buffer_core import S_TO_NS, duration_ns, time_ns
from tfloom.tf2_ros.buffer_interface import NO_WAIT, BufferInterface

# Actions are imported where they are used, because `import tf2_ros` must be quick.
if TYPE_CHECKING:
    from tfloom.interfaces.geometry_msgs.msg import TransformStamped
    from tfloom.interfaces.tf2_msgs.action import LookupTransform_Goal
    from tfloom.node.action.client import ClientGoalHandle
    from tfloom.node.node import Node

__all__ = ["BufferClient"]

MAX_DURATION_S = 2**31 - 1
"""The longest duration that a message can hold [s], 68 years; rclpy's Infinite is longer."""
PADDING = Duration(seconds=2.0)
WRONG = "Something is likely wrong with the server."
ERRORS: dict[int, type[TransformException]] = {
    TF2Error.LOOKUP_ERROR: LookupException,
    TF2Error.CONNECTIVITY_ERROR: ConnectivityException,
    TF2Error.EXTRAPOLATION_ERROR: ExtrapolationException,
    TF2Error.INVALID_ARGUMENT_ERROR: InvalidArgumentException,
    TF2Error.TIMEOUT_ERROR: TimeoutException,
}
"""The exception for each error code of a result; other codes raise TransformException."""


class BufferClient(BufferInterface):
    """The queries of a buffer, sent to the `BufferServer` of another program, tf2's included.

    They may be called from any thread. Another thread must spin a node that is in an executor; a node in none is spun
    by the query.

    Args:
        node: The node of the action client.
        ns: Name of the server's action, as `tf2_buffer_server`.
        check_frequency: Accepted for tf2's signature and unused, because results arrive as events.
        timeout_padding: Time that a result may take beyond the query's timeout; a Duration, or seconds.
    """

    def __init__(
        self, node: Node, ns: str, check_frequency: float = 10.0, timeout_padding: Any = PADDING
    ) -> None:
        from tfloom.interfaces.tf2_msgs.action import LookupTransform
        from tfloom.node.action.client import ActionClient

        if (error := node_error("BufferClient", node) or name_error(ns, is_service=True)) is not None:
            raise error
        _padding_s(timeout_padding)  # raises for what is not one
        super().__init__()
        self.node = node
        self.action_client = ActionClient(node, LookupTransform, action_name=ns)
        self._goal_type = LookupTransform.Goal
        self.check_frequency = check_frequency
        self.timeout_padding = timeout_padding

    def wait_for_server(self, timeout_sec: float | None = None) -> bool:
        """Wait until the server is ready; return False after `timeout_sec` [s] (None: no limit) or at shutdown."""
        return self.action_client.wait_for_server(timeout_sec)

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Any, timeout: Any = NO_WAIT
    ) -> TransformStamped:
        """Return the transform that takes data in `source_frame` into `target_frame`.

        Args:
            target_frame: Frame to express the data in.
            source_frame: Frame the data is expressed in.
            time: Time of the transform, as a Time or a stamp; zero is the newest at which the whole chain is known.
            timeout: The longest wait of the server for it.

        Raises:
            TimeoutException: there is no server, or the transform or the server's result did not arrive in time.
            LookupException, ConnectivityException, ExtrapolationException, InvalidArgumentException: as
                `Buffer.lookup_transform` raises them, at the server.
            TransformException: the server sent no result, or one with an unknown error.
            TypeError: `time` has neither `sec` and `nanosec` nor `nanoseconds`.
            RuntimeError: called in a callback of the single-threaded executor that must receive the result.
        """
        goal = self._goal_type(
            target_frame=target_frame,
            source_frame=source_frame,
            source_time=_time_message(time),
            timeout=_duration_message(timeout),
        )
        return self._query(goal)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Any = NO_WAIT,
    ) -> TransformStamped:
        """Return the transform, by way of `fixed_frame`, from the source to the target at another time.

        `fixed_frame` must not move between the two times. Raises as `lookup_transform` does.
        """
        goal = self._goal_type(
            target_frame=target_frame,
            source_frame=source_frame,
            source_time=_time_message(source_time),
            timeout=_duration_message(timeout),
            target_time=_time_message(target_time),
            fixed_frame=fixed_frame,
            advanced=True,
        )
        return self._query(goal)

    def destroy(self) -> None:
        """Destroy the action client."""
        self.action_client.destroy()

    def _query(self, goal: LookupTransform_Goal) -> TransformStamped:
        executor = executor_of(self.node)
        if executor is not None and executor.would_wait_for_itself():
            raise RuntimeError(
                "Waiting for the BufferServer in a callback would never end, because its executor receives the result "
                "on this thread. Use a MultiThreadedExecutor, or a Buffer of your own"
            )
        if not self.action_client.server_is_ready():
            raise TimeoutException("The BufferServer is not ready.")
        # One end for the whole exchange: the server waits for the transform up to the goal's timeout, and the padding
        # is for the messages there and back.
        end_s = (
            steady.monotonic() + max(0.0, duration_ns(goal.timeout) / 1e9) + _padding_s(self.timeout_padding)
        )
        handle: ClientGoalHandle = self._wait(self.action_client.send_goal_async(goal), end_s)
        if not handle.accepted:
            raise TimeoutException(
                f"The LookupTransform goal sent to the BufferServer did not come back with accepted status. {WRONG}"
            )
        try:
            response = self._wait(handle.get_result_async(), end_s)
        except BaseException:
            # Nobody awaits the result any more, after a timeout or Ctrl-C: let the server end its wait, too. After a
            # shutdown there is no way to tell it.
            if self.node.context.ok():
                handle.cancel_goal_async()
            raise
        return _transform_of(response, goal)

    def _wait(self, future: Future[Any], end_s: float) -> Any:
        """Return the result of a future once the node's executor has completed it.

        Raises:
            TimeoutException: it isn't complete at `end_s`, by the steady clock, or at shutdown, or the server has left.
        """
        wait_for_future(self.node, future, end_s)
        if not future.done():
            raise TimeoutException(
                f"The LookupTransform goal sent to the BufferServer did not come back in the specified time. {WRONG}"
            )
        try:
            return future.result()
        except NoResponseError as error:
            raise TimeoutException(
                f"The LookupTransform goal sent to the BufferServer did not come back: {error}. {WRONG}"
            ) from None


def _padding_s(padding: Any) -> float:
    if hasattr(padding, "nanoseconds") or hasattr(padding, "nanosec"):
        return duration_ns(padding) / 1e9
    padding_s = checked_timeout("BufferClient", padding)
    return math.inf if padding_s is None else padding_s


def _transform_of(response: Any, goal: LookupTransform_Goal) -> TransformStamped:
    """Return the transform of a server's result, or raise its error."""
    from tfloom.interfaces.action_msgs.msg import GoalStatus

    result = None if response is None else response.result
    if result is None or result.error is None:
        raise TransformException(f"The BufferServer returned None for result or result.error!  {WRONG}")
    error: TF2Error = result.error
    if error.error != TF2Error.NO_ERROR:
        raise ERRORS.get(error.error, TransformException)(error.error_string)
    if response.status == GoalStatus.STATUS_ABORTED:
        # tf2's server ends a goal after its timeout in this way, with an empty transform that looks like a result.
        raise TimeoutException(
            f"Timed out after {duration_ns(goal.timeout) / 1e9:g} s waiting for the transform from "
            f"{goal.source_frame} to {goal.target_frame}"
        )
    if response.status != GoalStatus.STATUS_SUCCEEDED:
        raise TransformException(
            f"The BufferServer returned no transform from {goal.source_frame} to {goal.target_frame}: "
            "the lookup was canceled, or its goal is unknown"
        )
    transform: TransformStamped = result.transform
    return transform


def _time_message(time: Any) -> TimeMessage:
    try:
        sec, nanosec = divmod(time_ns(time), S_TO_NS)
    except TypeError:
        raise TypeError("Must pass a rclpy.time.Time object.") from None
    return TimeMessage(sec=sec, nanosec=nanosec)


def _duration_message(duration: Any) -> DurationMessage:
    sec, nanosec = divmod(min(duration_ns(duration), MAX_DURATION_S * S_TO_NS), S_TO_NS)
    return DurationMessage(sec=sec, nanosec=nanosec)
