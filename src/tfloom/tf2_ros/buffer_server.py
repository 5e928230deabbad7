"""Answers lookups of other programs from one buffer, by the action `tf2_msgs/action/LookupTransform`."""

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

# Actions are imported by those who use them: `import tf2_ros` is quick without.
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
"""What each kind of error is called in an answer; the kinds of ExtrapolationException share one."""
RESULT_TIMEOUT_S = 10.0
"""How long an answer is kept for a client that is slow to ask for it."""
MOST_SECONDS = 2**31 - 1
"""What the seconds of a stamp can be at most."""


class BufferServer:
    """Lets others look transforms up in a buffer of this program; `BufferClient` is the other end.

    A goal whose transform is there, or that has no time to wait, is answered at once, and succeeds even when the
    answer is an error, as in tf2. Any other waits: the transform itself wakes it, with no thread and no polling. It
    succeeds with the transform; it is aborted with an error when its timeout is over, or as soon as the time that it
    asks for is older than what the buffer keeps. A goal that waits can be cancelled.

    Args:
        buffer: What to answer from.
        node: The node that serves; whoever spins it answers.
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
            forget_told_results=True,  # the list of goals, which is told at every change, would grow and grow
        )

    async def _execute(self, handle: ServerGoalHandle) -> LookupTransform_Result:
        query = _Query(self._buffer, handle.request)
        if not handle.is_cancel_requested and query.is_settled():
            result = query.answer()
            handle.succeed()
            return result
        waiting = query.wait()
        # Cancelled already, it is called at once.
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
        """Serve no more. Goals that wait get no answer."""
        self._server.destroy()


class _Query:
    """What a goal asks of a buffer."""

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
        """Return whether it is to be answered now."""
        return self._timeout_s <= 0 or self._find_obstacle() is None

    def answer(self) -> LookupTransform_Result:
        """Return the transform, or the error that its lookup raises."""
        from tfloom.interfaces.tf2_msgs.action import LookupTransform_Result

        try:
            transform = self._look_up()
        except TransformException as error:
            return _failure(error)
        if transform.header.stamp.sec > MOST_SECONDS:  # a goal's nanoseconds may be some seconds more
            return _failure(TransformException("the time asked for is later than a stamp can tell"))
        return LookupTransform_Result(transform=transform)

    def wait(self) -> Future[bool]:
        """Return a future: True once the transform is there, or none can come any more; False after the timeout."""
        waiting: Future[bool] = Future()
        request = self._add_request(lambda _handle, _is_available: waiting.set_result(True))
        if not request:
            waiting.set_result(True)
            return waiting

        def expire() -> None:
            if self._buffer.cancel_request(request):  # else it is being answered
                waiting.set_result(False)

        deadline = call_after(self._timeout_s, expire)

        def forget() -> None:
            deadline.call_off()
            self._buffer.cancel_request(request)

        waiting.when_complete(forget)
        return waiting

    def timeout_error(self) -> TimeoutException:
        """Return what tells that the transform did not come, and why."""
        goal = self._goal
        return TimeoutException(
            f"Timed out after {self._timeout_s:g} s waiting for the transform from {goal.source_frame} to "
            f"{goal.target_frame}: {self._find_obstacle() or 'it came too late'}"
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
