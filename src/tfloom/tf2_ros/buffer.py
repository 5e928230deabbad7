"""The buffer of a program: lookups with a timeout, and futures of transforms."""

from __future__ import annotations

import weakref
from time import monotonic
from typing import TYPE_CHECKING, Any

from tfloom.interfaces.tf2_msgs.srv import FrameGraph
from tfloom.node.clock.clock import Clock
from tfloom.node.clock.time_jump import ClockChange, JumpThreshold
from tfloom.node.executing.task import Future
from tfloom.node.log.logging import get_logger
from tfloom.node.values.duration import Duration
from tfloom.node.values.wrong_arguments import node_error
from tfloom.tf2.errors import LookupException
from tfloom.tf2_ros.buffer_core import BufferCore, cache_time_error, duration_ns, time_error, time_ns
from tfloom.tf2_ros.buffer_interface import NO_WAIT, BufferInterface
from tfloom.tf2_ros.deadlines import call_after

if TYPE_CHECKING:
    from collections.abc import Callable

    from tfloom.interfaces.geometry_msgs.msg import TransformStamped
    from tfloom.node.clock.clock import JumpHandle
    from tfloom.node.clock.time_jump import TimeJump
    from tfloom.node.context.context import Context
    from tfloom.node.node import Node

__all__ = ["Buffer"]

MIN_BACKWARD_JUMP = Duration(seconds=-1)
MAX_MARGIN_NS = 1_000_000_000
SLICE_S = 0.25
"""Period at which a wait checks whether its context was shut down [s]."""


class Buffer(BufferCore, BufferInterface):
    """A tree of frames over time. A TransformListener fills it; all methods may be called from any thread.

    A query with a timeout waits on a condition that each new transform notifies. It needs no executor, so a callback
    may wait for a transform.

    Args:
        cache_time: Length of each frame's history, before its newest sample; None: 10 s.
        node: Node that serves `tf2_frames`, which returns the frames as YAML. A jump backward of its simulated time
            clears the buffer, as does one of a listener's node.
    """

    def __init__(self, cache_time: Any = None, node: Node | None = None) -> None:
        if (error := cache_time_error(cache_time)) is not None:
            raise error
        if node is not None and (error := node_error("Buffer", node)) is not None:
            raise error
        BufferCore.__init__(self, cache_time)
        BufferInterface.__init__(self)
        self._jump_handles: weakref.WeakKeyDictionary[Clock, JumpHandle] = weakref.WeakKeyDictionary()
        self._context: Context | None = None
        self.clock = Clock() if node is None else node.get_clock()
        if node is not None:
            self.watch_clock(node)
            self.srv = node.create_service(FrameGraph, "tf2_frames", frames_callback(weakref.ref(self)))

    def watch_clock(self, node: Node) -> None:
        """Clear the buffer when the clock of `node` jumps backward. Watching the same clock again does nothing."""
        self._context = node.context
        clock = node.get_clock()
        if clock not in self._jump_handles:
            threshold = JumpThreshold(min_forward=None, min_backward=MIN_BACKWARD_JUMP, on_clock_change=True)
            self._jump_handles[clock] = clock.create_jump_callback(
                threshold, post_callback=jump_callback(weakref.ref(self), weakref.ref(clock))
            )

    def time_jump_callback(self, time_jump: TimeJump) -> None:
        """Clear the buffer, after a jump backward in time."""
        get_logger("tf2_buffer").warning("Detected jump back in time. Clearing tf buffer.")
        self.clear()

    def ignore_stragglers(self, jump_ns: int, now_ns: int) -> None:
        """Ignore transforms sent before a jump backward, which have stamps near the old time, for a short time.

        Args:
            jump_ns: The jump, which is negative.
            now_ns: The time after it.
        """
        margin_ns = min(-jump_ns // 2, MAX_MARGIN_NS)
        self.ignore_from(now_ns - jump_ns - margin_ns, margin_ns / 1e9)

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Any, timeout: Any = NO_WAIT
    ) -> TransformStamped:
        """Return the transform that takes data in `source_frame` into `target_frame`.

        Args:
            target_frame: Frame to express the data in.
            source_frame: Frame the data is expressed in.
            time: Time of the transform; `Time()` is the newest time at which the whole chain is known.
            timeout: The longest wait for it.

        Raises:
            LookupException: a frame is unknown, or the chain is a loop.
            ConnectivityException: the two frames are in different trees.
            ExtrapolationException: the time lies outside the stored history.
            InvalidArgumentException: a frame's name is empty or starts with a slash.
        """
        if timeout is not NO_WAIT:
            self._wait(duration_ns(timeout), self.wait, target_frame, source_frame, time_ns(time))
        return self.lookup_transform_core(target_frame, source_frame, time)

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
        query = target_frame, target_time, source_frame, source_time, fixed_frame
        if timeout is not NO_WAIT:
            self._wait(duration_ns(timeout), self.wait_full, *_in_ns(*query))
        return self.lookup_transform_full_core(*query)

    def can_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Any,
        timeout: Any = NO_WAIT,
        return_debug_tuple: bool = False,
    ) -> bool | tuple[bool, str]:
        """Return whether `lookup_transform` succeeds within `timeout`; with `return_debug_tuple`, also why not."""
        stamp_ns = time_ns(time)
        if timeout is not NO_WAIT:
            self._wait(duration_ns(timeout), self.wait, target_frame, source_frame, stamp_ns)
        obstacle = self.find_obstacle(target_frame, source_frame, stamp_ns)
        return (obstacle is None, obstacle or "") if return_debug_tuple else obstacle is None

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Any = NO_WAIT,
        return_debug_tuple: bool = False,
    ) -> bool | tuple[bool, str]:
        """Return whether `lookup_transform_full` succeeds within `timeout`; see `can_transform`."""
        query = target_frame, target_time, source_frame, source_time, fixed_frame
        if timeout is not NO_WAIT:
            self._wait(duration_ns(timeout), self.wait_full, *_in_ns(*query))
        if (error := time_error(target_time) or time_error(source_time)) is not None:
            raise error
        verdict = self.can_transform_full_core(*query)
        return verdict if return_debug_tuple else verdict[0]

    def _wait(self, timeout_ns: int, wait: Callable[..., bool], *query: Any) -> None:
        # The native wait ends by a transform or by time, but not by a shutdown of the context. So it is made in slices,
        # with a look at the context after each. A slice that ends early, without the transform, is the native verdict
        # that it can never come; the lookup that follows raises the reason.
        end_s = monotonic() + timeout_ns / 1e9
        while (left_s := end_s - (start_s := monotonic())) > 0:
            slice_s = min(left_s, SLICE_S)
            if wait(*query, timeout_s=slice_s) or monotonic() - start_s < slice_s / 2:
                return
            if self._context is not None and not self._context.ok():
                return

    def wait_for_transform_async(
        self, target_frame: str, source_frame: str, time: Any, timeout: Any = None
    ) -> Future[TransformStamped]:
        """Return a future of the transform that `lookup_transform` will return once it is available.

        It is completed on the thread that inserts the missing transform. If the lookup can no longer succeed, its
        exception is set; after `timeout`, a LookupException. Cancelling the future ends the wait.
        """
        query = target_frame, source_frame, time
        stamp_ns = time_ns(time)
        return self._future(
            lambda: self.lookup_transform_core(*query),
            lambda answer: self.add_request(target_frame, source_frame, stamp_ns, answer),
            lambda: self.can_transform_core(*query)[1],
            None if timeout is None else duration_ns(timeout),
        )

    def wait_for_transform_full_async(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Any = None,
    ) -> Future[TransformStamped]:
        """Return a future of the transform of `lookup_transform_full`; see `wait_for_transform_async`."""
        query = target_frame, target_time, source_frame, source_time, fixed_frame
        query_ns = _in_ns(*query)
        return self._future(
            lambda: self.lookup_transform_full_core(*query),
            lambda answer: self.add_request_full(*query_ns, answer),
            lambda: self.can_transform_full_core(*query)[1],
            None if timeout is None else duration_ns(timeout),
        )

    async def lookup_transform_async(
        self, target_frame: str, source_frame: str, time: Any, timeout: Any = None
    ) -> TransformStamped:
        """Return the transform of `lookup_transform` once it is available; see `wait_for_transform_async`."""
        await self.wait_for_transform_async(target_frame, source_frame, time, timeout)
        return self.lookup_transform_core(target_frame, source_frame, time)

    async def lookup_transform_full_async(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Any = None,
    ) -> TransformStamped:
        """Return the transform of `lookup_transform_full` once it is available; see `wait_for_transform_async`."""
        query = target_frame, target_time, source_frame, source_time, fixed_frame
        await self.wait_for_transform_full_async(*query, timeout)
        return self.lookup_transform_full_core(*query)

    def _future(
        self,
        look_up: Callable[[], TransformStamped],
        request: Callable[[Callable[[int, bool], None]], int | None],
        explain: Callable[[], str],
        timeout_ns: int | None,
    ) -> Future[TransformStamped]:
        # Three things can end the wait: the transform arrives, on the thread that stores it; the time is over, on the
        # thread of deadlines; the user cancels. `cancel_request` decides which was first: it returns True to one caller
        # alone, and only while `complete` has not been called and never will be.
        future = self._new_future()

        def complete(*_: object) -> None:
            if future.cancelled() or future.done():
                return
            try:
                future.set_result(look_up())
            except Exception as error:  # the future raises it
                future.set_exception(error)

        # 0: it is available now; None: it never can be. Either way `complete` has not been called, and knows the
        # answer.
        handle = request(complete)
        if not handle:
            complete()
            return future

        def expire() -> None:
            if self.cancel_request(handle):  # otherwise it is being completed
                future.set_exception(self._timed_out(f"timed out: {explain()}"))

        future.add_done_callback(lambda ended: ended.cancelled() and self.cancel_request(handle))
        if timeout_ns is not None:
            try:
                deadline = call_after(timeout_ns / 1e9, expire)
            except RuntimeError:  # no thread: without its timeout, the request must not stay
                self.cancel_request(handle)
                raise
            self._on_completion(future, deadline.cancel)
        return future

    def _new_future(self) -> Future[TransformStamped]:
        return Future()

    def _on_completion(self, future: Future[TransformStamped], function: Callable[[], None]) -> None:
        future.when_complete(function)

    def _timed_out(self, text: str) -> Exception:
        return LookupException(text)


def jump_callback(buffer: weakref.ref[Buffer], clock: weakref.ref[Any]) -> Callable[[Any], None]:
    """Return a jump callback that keeps neither the buffer nor the clock alive, of tfloom or of a real rclpy."""

    def jumped(time_jump: Any) -> None:
        alive, source = buffer(), clock()
        if alive is None or source is None:
            return
        alive.time_jump_callback(time_jump)
        jump_ns = time_jump.delta.nanoseconds
        if jump_ns < 0 and int(time_jump.clock_change) == ClockChange.ROS_TIME_NO_CHANGE:
            alive.ignore_stragglers(jump_ns, source.now().nanoseconds)

    return jumped


def frames_callback(buffer: weakref.ref[Buffer]) -> Callable[[Any, Any], Any]:
    """Return the callback of the service `tf2_frames`, which does not keep the buffer alive."""

    def answer(_request: Any, response: Any) -> Any:
        alive = buffer()
        response.frame_yaml = "[]" if alive is None else alive.all_frames_as_yaml()
        return response

    return answer


def _in_ns(
    target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
) -> tuple[str, int, str, int, str]:
    return target_frame, time_ns(target_time), source_frame, time_ns(source_time), fixed_frame
