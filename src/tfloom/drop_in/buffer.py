"""The buffer for nodes of a real rclpy: the native one, with messages, times and futures of that ROS's classes."""

from __future__ import annotations

import logging
import weakref
from collections.abc import Callable
from contextlib import suppress
from functools import wraps
from typing import TYPE_CHECKING, Any, TypeVar, cast

from tfloom.drop_in import real_ros
from tfloom.drop_in.errors import LookupException, converted
from tfloom.tf2.errors import TransformException
from tfloom.tf2_ros import buffer as tf2_ros_buffer
from tfloom.tf2_ros.buffer import MIN_BACKWARD_JUMP, frames_callback, jump_callback
from tfloom.tf2_ros.buffer_core import BufferCore, time_ns
from tfloom.tf2_ros.buffer_interface import NO_WAIT, BufferInterface, convert

__all__ = ["Buffer"]

S_TO_NS = 1_000_000_000

_Method = TypeVar("_Method", bound=Callable[..., Any])


def _raises_theirs(method: _Method) -> _Method:
    """Let a method raise the exceptions of `tfloom.drop_in.errors`."""

    @wraps(method)
    def run(*args: Any, **kwargs: Any) -> Any:
        try:
            return method(*args, **kwargs)
        except TransformException as error:
            raise converted(error) from None

    return cast("_Method", run)


class Buffer(tf2_ros_buffer.Buffer):
    """A tree of frames over time, as tf2_ros's, for programs of a real rclpy.

    It answers with that ROS's `geometry_msgs/msg/TransformStamped`, `rclpy.time.Time` and `rclpy.task.Future`. A query
    with a timeout waits on a condition that each new transform notifies. It needs no executor, so a callback may wait
    for a transform. `transform` uses the functions that are registered with a real tf2_ros, if there is one, and
    otherwise tfloom's for geometry_msgs and PointCloud2.

    Args:
        cache_time: Length of each frame's history, before its newest sample; None: 10 s.
        node: Node that serves `tf2_frames`, if tf2_msgs is installed for its ROS. A jump backward of its simulated time
            clears the buffer, as does one of a listener's node.

    Raises:
        ImportError: geometry_msgs is not installed for the ROS that `rclpy` comes from.
    """

    def __init__(self, cache_time: Any = None, node: Any = None) -> None:
        BufferCore.__init__(self, cache_time)
        BufferInterface.__init__(self)
        self.set_log_callback(_log)
        self._message_class = real_ros.message_class("geometry_msgs", "TransformStamped")
        self._future_class = real_ros.module("rclpy.task").Future
        self._jump_handles = weakref.WeakKeyDictionary()
        self._context = None
        self._nodes: weakref.WeakSet[Any] = weakref.WeakSet()
        """Nodes whose executors may run tasks that wait for a future of this buffer."""
        self.clock = real_ros.module("rclpy.clock").Clock() if node is None else node.get_clock()
        theirs = real_ros.find("tf2_ros")
        if theirs is not None:
            self.registration = theirs.TransformRegistration()
        if node is not None:
            self.watch_clock(node)
            self.srv = _serve_frames(node, weakref.ref(self))

    def watch_clock(self, node: Any) -> None:
        """Clear the buffer when the clock of `node` jumps backward. Watching the same clock again does nothing."""
        self._context = node.context
        self._nodes.add(node)
        clock = node.get_clock()
        if clock not in self._jump_handles:
            least = real_ros.module("rclpy.duration").Duration(nanoseconds=MIN_BACKWARD_JUMP.nanoseconds)
            threshold = real_ros.module("rclpy.clock").JumpThreshold(min_forward=None, min_backward=least)
            self._jump_handles[clock] = clock.create_jump_callback(
                threshold, post_callback=jump_callback(weakref.ref(self), weakref.ref(clock))
            )

    def __del__(self) -> None:
        # rclpy's clock refers to a handle without keeping it, so one that is not unregistered must not be freed.
        with suppress(Exception):
            for handle in self._jump_handles.values():
                handle.unregister()

    def time_jump_callback(self, time_jump: Any) -> None:
        """Clear the buffer, after a jump backward in time."""
        real_ros.module("rclpy.logging").get_logger("tf2_buffer").warning(
            "Detected jump back in time. Clearing tf buffer."
        )
        self.clear()

    def lookup_transform_core(self, target_frame: str, source_frame: str, time: Any) -> Any:
        """Return the transform that takes data in `source_frame` into `target_frame`; see `lookup_transform`."""
        try:
            return self._message(self.lookup(target_frame, source_frame, time_ns(time)))
        except TransformException as error:
            raise converted(error) from None

    def lookup_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> Any:
        """Return the transform, by way of `fixed_frame`, from the source to the target at another time."""
        target_ns, source_ns = time_ns(target_time), time_ns(source_time)
        try:
            return self._message(
                self.lookup_full(target_frame, target_ns, source_frame, source_ns, fixed_frame)
            )
        except TransformException as error:
            raise converted(error) from None

    if TYPE_CHECKING:  # Any, because the classes are those of whichever ROS is installed

        def lookup_transform(
            self, target_frame: str, source_frame: str, time: Any, timeout: Any = NO_WAIT
        ) -> Any: ...

        def lookup_transform_full(
            self,
            target_frame: str,
            target_time: Any,
            source_frame: str,
            source_time: Any,
            fixed_frame: str,
            timeout: Any = NO_WAIT,
        ) -> Any: ...

        def wait_for_transform_async(
            self, target_frame: str, source_frame: str, time: Any, timeout: Any = None
        ) -> Any: ...

        def wait_for_transform_full_async(
            self,
            target_frame: str,
            target_time: Any,
            source_frame: str,
            source_time: Any,
            fixed_frame: str,
            timeout: Any = None,
        ) -> Any: ...

        async def lookup_transform_async(
            self, target_frame: str, source_frame: str, time: Any, timeout: Any = None
        ) -> Any: ...

        async def lookup_transform_full_async(
            self,
            target_frame: str,
            target_time: Any,
            source_frame: str,
            source_time: Any,
            fixed_frame: str,
            timeout: Any = None,
        ) -> Any: ...

    @_raises_theirs
    def get_latest_common_time(self, target_frame: str, source_frame: str) -> Any:
        """Return the newest time at which the whole chain is known; zero if all of it is static."""
        stamp_ns = super().get_latest_common_time(target_frame, source_frame).nanoseconds
        clock_type = real_ros.module("rclpy.clock").ClockType.SYSTEM_TIME
        return real_ros.module("rclpy.time").Time(nanoseconds=stamp_ns, clock_type=clock_type)

    lookupVelocityCore = _raises_theirs(tf2_ros_buffer.Buffer.lookupVelocityCore)
    lookupVelocityFullCore = _raises_theirs(tf2_ros_buffer.Buffer.lookupVelocityFullCore)
    _chain = _raises_theirs(tf2_ros_buffer.Buffer._chain)  # noqa: SLF001, tf2_py's name

    def _message(self, stamped: Any) -> Any:
        message = self._message_class()
        header, transform = message.header, message.transform
        # Floored, because nanosec must not be negative.
        header.stamp.sec, header.stamp.nanosec = divmod(stamped.stamp_ns, S_TO_NS)
        header.frame_id = stamped.frame_id
        message.child_frame_id = stamped.child_frame_id
        position, rotation = transform.translation, transform.rotation
        position.x, position.y, position.z = stamped.translation
        rotation.x, rotation.y, rotation.z, rotation.w = stamped.rotation_xyzw
        return message

    def _registered(self, kind: Any) -> Callable[..., Any] | None:
        theirs = real_ros.find("tf2_ros")
        if theirs is not None:
            try:
                return self.registration.get(kind)
            except theirs.TypeException:
                function = _find_ours(kind)
                if function is None:
                    raise
                return function
        return _find_ours(kind) or super()._registered(kind)

    def _conversion_error(self, kind: Any, new_type: Any) -> Exception | None:
        return super()._conversion_error(kind, new_type) if real_ros.find("tf2_ros") is None else None

    def _converted(self, result: Any, new_type: Any) -> Any:
        theirs = real_ros.find("tf2_ros")
        return convert(result, new_type) if theirs is None else theirs.convert(result, new_type)

    def _new_future(self) -> Any:
        future = self._future_class()
        future.add_done_callback(self._wake_executors)
        return future

    def _wake_executors(self, _future: object) -> None:
        """Let executors continue the tasks that wait for a future, because it is completed outside of them."""
        for node in list(self._nodes):
            with suppress(Exception):  # the executor may be shut down meanwhile
                if (executor := node.executor) is not None:
                    executor.wake()

    def _on_completion(self, future: Any, function: Callable[[], None]) -> None:
        future.add_done_callback(lambda _: function())

    def _timed_out(self, text: str) -> Exception:
        return LookupException(text)


def _find_ours(kind: Any) -> Callable[..., Any] | None:
    """Return tfloom's function that transforms messages of a stock type; None for others."""
    from tfloom.tf2_ros import geometry  # noqa: F401, registers them
    from tfloom.tf2_ros.buffer_interface import TransformRegistration, TypeException

    if kind.__name__ == "PointCloud2":
        from tfloom.tf2_ros.point_clouds import point_cloud  # noqa: F401, registers it
    try:
        return TransformRegistration().get(kind)
    except TypeException:
        return None


def _serve_frames(node: Any, buffer: weakref.ref[tf2_ros_buffer.Buffer]) -> Any:
    """Return the service `tf2_frames` of a node; None without tf2_msgs."""
    tf2_msgs = real_ros.find("tf2_msgs.srv")
    if tf2_msgs is None:
        node.get_logger().info("tf2_msgs is not installed for this ROS, so there is no service tf2_frames")
        return None
    return node.create_service(tf2_msgs.FrameGraph, "tf2_frames", frames_callback(buffer))


def _log(severity: int, text: str) -> None:
    """Log the text of a rejected transform; a call site of rclpy's logger has one severity for good."""
    logger = real_ros.module("rclpy.logging").get_logger("tf2_buffer")
    if severity >= logging.ERROR:
        logger.error(text)
    elif severity >= logging.WARNING:
        logger.warning(text)
    else:
        logger.info(text)
