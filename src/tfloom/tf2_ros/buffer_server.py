"""Lookups for other programs in this program's buffer, by the action `tf2_msgs/action/LookupTransform`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.interfaces.tf2_msgs.msg import TF2Error
from tfloom.node.executing.task import Future
from tfloom.tf2.errors import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)
from tfloom.tf2_ros.buffer_core import BufferCore, duration_ns, time_ns
from tfloom.tf2_ros.deadlines import call_after

# Actions are imported where they are used, because `import tf2_ros` has to be quick.
if TYPE_CHECKING:
    from collections.abc import Callable

    from tfloom.interfaces.geometry_msgs.msg import TransformStamped
    from tfloom.interfaces.tf2_msgs.action import LookupTransform_Goal, LookupTransform_Result
    from tfloom.node.action.server_goal_handle import ServerGoalHandle
    from tfloom.node.node import Node

__all__ = ["BufferServer"]

CODES: dict[type[TransformException], int] = {
    LookupException: TF2Error.LOOKUP_ERROR,
    ConnectivityException: TF2Error.CONNECTIVITY_ERROR,
    ExtrapolationException: TF2Error.EXTRAPOLATION_ERROR,
    InvalidArgumentException: TF2Error.INVALID_ARGUMENT_ERROR,
    TimeoutException: TF2Error.TIMEOUT_ERROR,
    TransformException: TF2Error.TRANSFORM_ERROR,
}
"""The error code of each exception in a result; the kinds of ExtrapolationException share one."""
RESULT_TIMEOUT_S = 10.0
"""Time for which a result is kept for a client that requests it late [s]."""
MAX_SECONDS = 2**31 - 1
"""The largest number of seconds in a stamp."""


class BufferServer:
    """Serves lookups in a buffer of this program; `BufferClient` is the client.

    A goal whose transform is available, or whose timeout is zero, ends at once, and succeeds even with an error as its
    result, as in tf2. Any other goal waits for its transform, without a thread and without polling. It succeeds with
    the transform; it is aborted with an error after its timeout, or as soon as the requested time is older than the
    buffer's history. A waiting goal can be cancelled.

    Args:
        buffer: The buffer to look up in.
        node: The node that serves, on the executor that spins it.
        action_name: Name of the action.
    """

    def __init__(self, buffer: BufferCore, node: Node, action_name: str = "tf2_buffer_server") -> None:
        from tfloom.interfaces.tf2_msgs.action import LookupTransform
        from tfloom.node.action.server import ActionServer, CancelResponse

        self._buffer = buffer
        self._server = ActionServer(
            node,
            LookupTransform,
            action_name,
            self._execute,
            cancel_callback=lambda _handle: CancelResponse.ACCEPT,
            result_timeout=RESULT_TIMEOUT_S,
            forget_sent_results=True,  # because the list of goals, published at every change, would grow without end
        )

    async def _execute(self, handle: ServerGoalHandle) -> LookupTransform_Result:
        # Most goals are answered from what the buffer has. The others wait without a thread: the buffer completes the
        # future when the transform arrives, and a timeout or a cancellation completes it before.
        query = _Query(self._buffer, handle.request)
        if not handle.is_cancel_requested and query.is_settled():
            result = query.answer()
            handle.succeed()
            return result
        waiting = query.wait()
        # If the goal was cancelled before, it is called at once.
        handle.cancel_future.when_complete(waiting.cancel)
        await waiting
        if handle.is_cancel_requested:
            handle.canceled()
            return _failure(TransformException("the lookup was canceled"))
        result = query.answer() if waiting.result() else _failure(query.timeout_error())
        if result.error.error == TF2Error.NO_ERROR:
            handle.succeed()
        else:
            handle.abort()
        return result

    def destroy(self) -> None:
        """Destroy the action server. No result is sent for waiting goals."""
        self._server.destroy()


class _Query:
    """The query of a goal."""

    def __init__(self, buffer: BufferCore, goal: LookupTransform_Goal) -> None:
        self._buffer = buffer
        self._goal = goal
        self._timeout_s = duration_ns(goal.timeout) / 1e9
        source_ns = time_ns(goal.source_time)
        self._simple = goal.target_frame, goal.source_frame, source_ns
        self._full = (
            goal.target_frame,
            time_ns(goal.target_time),
            goal.source_frame,
            source_ns,
            goal.fixed_frame,
        )

    def is_settled(self) -> bool:
        """Return whether the goal ends at once."""
        return self._timeout_s <= 0 or self._find_obstacle() is None

    def answer(self) -> LookupTransform_Result:
        """Return the transform, or the exception of its lookup."""
        from tfloom.interfaces.tf2_msgs.action import LookupTransform_Result

        try:
            transform = self._look_up()
        except TransformException as error:
            return _failure(error)
        if transform.header.stamp.sec > MAX_SECONDS:  # a goal's nanoseconds may add some seconds
            return _failure(TransformException("the requested time is later than a stamp can hold"))
        return LookupTransform_Result(transform=transform)

    def wait(self) -> Future[bool]:
        """Return a future: True once the transform is available or can't become so, False after the timeout."""
        # `cancel_request` returns True to one caller alone, which decides between the transform and the timeout.
        waiting: Future[bool] = Future()
        request = self._add_request(lambda _handle, _is_available: waiting.set_result(True))
        if not request:
            waiting.set_result(True)
            return waiting

        def expire() -> None:
            if self._buffer.cancel_request(request):  # otherwise it is being completed
                waiting.set_result(False)

        try:
            deadline = call_after(self._timeout_s, expire)
        except RuntimeError:  # no thread: without its timeout, the request must not stay
            self._buffer.cancel_request(request)
            raise

        # However the wait has ended, neither the timeout nor the request must stay.
        def forget() -> None:
            deadline.cancel()
            self._buffer.cancel_request(request)

        waiting.when_complete(forget)
        return waiting

    def timeout_error(self) -> TimeoutException:
        """Return the exception for a transform that did not arrive, with the reason."""
        goal = self._goal
        return TimeoutException(
            f"Timed out after {self._timeout_s:g} s waiting for the transform from {goal.source_frame} to "
            f"{goal.target_frame}: {self._find_obstacle() or 'it arrived too late'}"
        )

    def _find_obstacle(self) -> str | None:
        if self._goal.advanced:
            return self._buffer.find_obstacle_full(*self._full)
        return self._buffer.find_obstacle(*self._simple)

    def _look_up(self) -> TransformStamped:
        goal = self._goal
        if goal.advanced:
            return self._buffer.lookup_transform_full_core(
                goal.target_frame, goal.target_time, goal.source_frame, goal.source_time, goal.fixed_frame
            )
        return self._buffer.lookup_transform_core(goal.target_frame, goal.source_frame, goal.source_time)

    def _add_request(self, callback: Callable[[int, bool], None]) -> int | None:
        if self._goal.advanced:
            return self._buffer.add_request_full(*self._full, callback)
        return self._buffer.add_request(*self._simple, callback)


def _failure(error: TransformException) -> LookupTransform_Result:
    from tfloom.interfaces.tf2_msgs.action import LookupTransform_Result

    code = next(code for kind, code in CODES.items() if isinstance(error, kind))
    return LookupTransform_Result(error=TF2Error(error=code, error_string=str(error)))
