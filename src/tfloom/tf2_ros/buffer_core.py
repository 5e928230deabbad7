"""The buffer with tf2_py's interface: messages in, messages out."""

from __future__ import annotations

from typing import Any

from tfloom.common.text import given_text
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.log.logging import get_logger
from tfloom.node.values.exceptions import add_note
from tfloom.node.values.time import ClockType, Time
from tfloom.tf2 import buffer as tf2_buffer
from tfloom.tf2.buffer import DEFAULT_CACHE_TIME_NS
from tfloom.tf2.errors import InvalidArgumentException, TransformException
from tfloom.tf2.errors import LookupException as _LookupException

__all__ = [
    "BufferCore",
    "cache_time_error",
    "duration_error",
    "duration_ns",
    "frame_error",
    "time_error",
    "time_ns",
]

S_TO_NS = 1_000_000_000
Triple = tuple[float, float, float]
_NO_TRANSFORM = "{name}() needs a geometry_msgs.msg.TransformStamped, got {given!r}"


class BufferCore(tf2_buffer.Buffer):
    """A tree of frames over time that accepts and returns `geometry_msgs/msg/TransformStamped`.

    Times and durations may be ROS messages (`sec`, `nanosec`) or rclpy's objects (`nanoseconds`). Messages may be of
    any class, a real ROS install's included, because their fields are read by attribute.

    Args:
        cache_time: Length of each frame's history, before its newest sample; None: 10 s. As in tf2_py, it is
            positional, and unknown keywords are ignored.

    It also has the methods of `tfloom.tf2.buffer.Buffer`, which take names, nanoseconds and numbers.
    """

    def __init__(self, cache_time: Any = None, /, **_ignored: object) -> None:
        # Built in here, not by the class above, so that a wrong argument's traceback is short.
        if (error := cache_time_error(cache_time)) is not None:
            raise error
        super().__init__(DEFAULT_CACHE_TIME_NS if cache_time is None else duration_ns(cache_time))
        self.set_log_callback(_log)

    def set_transform(self, transform: Any, authority: str) -> None:
        """Store a TransformStamped. An invalid one is rejected and logged.

        Raises:
            TypeError: the message or one of its parts lacks a field.
        """
        if not hasattr(transform, "child_frame_id"):
            raise TypeError(_NO_TRANSFORM.format(name="set_transform", given=transform))
        self.set_message(transform, authority)

    def set_transform_static(self, transform: Any, authority: str) -> None:
        """Store a TransformStamped that holds at all times; see `set_transform`."""
        if not hasattr(transform, "child_frame_id"):
            raise TypeError(_NO_TRANSFORM.format(name="set_transform_static", given=transform))
        self.set_message(transform, authority, static=True)

    def can_transform_core(self, target_frame: str, source_frame: str, time: Any) -> tuple[bool, str]:
        """Return whether `lookup_transform_core` would succeed, and the reason if not."""
        obstacle = self.find_obstacle(target_frame, source_frame, time_ns(time))
        return obstacle is None, obstacle or ""

    def can_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> tuple[bool, str]:
        """Return whether `lookup_transform_full_core` would succeed, and the reason if not."""
        obstacle = self.find_obstacle_full(
            target_frame, time_ns(target_time), source_frame, time_ns(source_time), fixed_frame
        )
        return obstacle is None, obstacle or ""

    def lookup_transform_core(self, target_frame: str, source_frame: str, time: Any) -> TransformStamped:
        """Return the transform that takes data in `source_frame` into `target_frame`.

        Args:
            target_frame: Frame to express the data in.
            source_frame: Frame the data is expressed in.
            time: Time of the transform; zero is the newest time at which the whole chain is known.

        Raises:
            LookupException: a frame is unknown, or the chain is a loop.
            ConnectivityException: the two frames are in different trees.
            ExtrapolationException: the time lies outside the stored history.
            InvalidArgumentException: a frame's name is empty or starts with a slash.
        """
        try:
            message: TransformStamped = self.lookup_message(target_frame, source_frame, time)
        except TypeError as error:
            _note_time(error, time)
            raise
        return message

    def lookup_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> TransformStamped:
        """Return the transform, by way of `fixed_frame`, from the source to the target at another time.

        The result has the target's time. Raises as `lookup_transform_core` does.
        """
        try:
            message: TransformStamped = self.lookup_message_full(
                target_frame, target_time, source_frame, source_time, fixed_frame
            )
        except TypeError as error:
            _note_time(error, target_time, source_time)
            raise
        return message

    def get_latest_common_time(self, target_frame: str, source_frame: str) -> Time:
        """Return the newest time at which the whole chain is known; zero if all of it is static.

        Raises:
            LookupException: a frame is unknown.
            InvalidArgumentException: a frame's name is empty or starts with a slash.
            TransformException: the two frames are in different trees, or the chain is a loop.
        """
        if (wrong_frame := frame_error(target_frame) or frame_error(source_frame)) is not None:
            raise wrong_frame
        try:
            stamp = self.latest_common_time(target_frame, source_frame)
        except InvalidArgumentException:
            raise
        except TransformException as error:
            # tf2_py raises the base class where there is no chain.
            if isinstance(error, _LookupException) and error.frame_id is not None:
                raise
            raise TransformException(*error.args) from None
        return Time(nanoseconds=stamp, clock_type=ClockType.SYSTEM_TIME)

    def lookupVelocityCore(
        self, tracking_frame: str, observation_frame: str, time: Any, averaging_interval: Any
    ) -> tuple[Triple, Triple]:
        """Return the linear and angular velocity of one frame in another, by tf2's formula; see `lookup_velocity`."""
        interval_s = duration_ns(averaging_interval) / 1e9
        twist = self.lookup_velocity(tracking_frame, observation_frame, time_ns(time), interval_s)
        return twist.linear, twist.angular

    def lookupVelocityFullCore(
        self,
        tracking_frame: str,
        observation_frame: str,
        reference_frame: str,
        reference_point: Triple,
        reference_point_frame: str,
        time: Any,
        averaging_interval: Any,
    ) -> tuple[Triple, Triple]:
        """Return the velocity of a point of the moving body, in a third frame; see `lookup_velocity`."""
        twist = self.lookup_velocity(
            tracking_frame,
            observation_frame,
            time_ns(time),
            duration_ns(averaging_interval) / 1e9,
            reference_frame=reference_frame,
            reference_point=reference_point,
            reference_point_frame=reference_point_frame,
        )
        return twist.linear, twist.angular

    def _chain(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> list[str]:
        source_ns, target_ns = time_ns(source_time), time_ns(target_time)
        _, chain = self.branches(fixed_frame, source_frame, source_ns)
        if source_ns == target_ns:
            return chain
        _, other = self.branches(target_frame, fixed_frame, target_ns)
        while chain and other and chain[-1] == other[-1]:
            chain.pop()
            other.pop()
        return chain + other

    def _frameExists(self, frame_id: str) -> bool:
        return self.has_frame(frame_id)

    def _getFrameStrings(self) -> list[str]:
        return self.frame_names()

    def _allFramesAsDot(self, time: float = 0) -> str:
        return self.all_frames_as_dot(float(time))


def time_ns(time: Any) -> int:
    """Return a time in nanoseconds: of an object with `nanoseconds`, or with `sec` and `nanosec`.

    Raises:
        TypeError: it has neither.
    """
    try:
        return _ns(time)
    except AttributeError:
        raise without_fields(time, "time") from None


def duration_ns(duration: Any) -> int:
    """Return a duration in nanoseconds: of an object with `nanoseconds`, or with `sec` and `nanosec`.

    Raises:
        TypeError: it has neither.
    """
    try:
        return _ns(duration)
    except AttributeError:
        raise without_fields(duration, "duration") from None


def time_error(time: object) -> TypeError | None:
    """Return what `time_ns` raises, or None, for callers whose tracebacks shall be short."""
    return None if _has_time(time) else without_fields(time, "time")


def duration_error(duration: object) -> TypeError | None:
    """Return what `duration_ns` raises, or None, for callers whose tracebacks shall be short."""
    return None if _has_time(duration) else without_fields(duration, "duration")


def frame_error(frame_id: object) -> TypeError | None:
    """Return the native buffer's error of a frame's name that is not a text, or None if it is one."""
    if isinstance(frame_id, str):
        return None
    given = given_text(frame_id)
    return TypeError(f"the name of a frame or a publisher must be a str, not {given}")


def cache_time_error(cache_time: Any) -> Exception | None:
    """Return the error of what is neither None nor a duration from 0."""
    if cache_time is None:
        return None
    if (error := duration_error(cache_time)) is not None:
        return error
    return ValueError(f"cache_time must not be negative, got {cache_time!r}") if _ns(cache_time) < 0 else None


def _has_time(value: object) -> bool:
    return hasattr(value, "nanoseconds") or (hasattr(value, "sec") and hasattr(value, "nanosec"))


def _ns(value: Any) -> int:
    try:
        return int(value.nanoseconds)
    except AttributeError:
        return int(value.sec) * S_TO_NS + int(value.nanosec)


def without_fields(given: object, kind: str) -> TypeError:
    """Return the error of a `time` or a `duration` that has neither `nanoseconds` nor `sec` and `nanosec`."""
    error = TypeError(f"{kind} must have sec and nanosec, or nanoseconds.")
    add_note(error, _meant(given, kind))
    return error


def _note_time(error: TypeError, *times: Any) -> None:
    """Add to an error of the native buffer which of the times has no fields of one, if that is its reason."""
    for time in times:
        if not _has_time(time):
            add_note(error, _meant(time, "time"))
            return


def _meant(given: object, kind: str) -> str:
    is_number = isinstance(given, (int, float)) and not isinstance(given, bool)
    seconds = f"(seconds={given!r})" if is_number else "(seconds=…)"
    text = f"got {given_text(given)}: write rclpy.{kind}.{kind.title()}{seconds}"
    return f"{text}, or Time() for the latest transform" if kind == "time" else text


def _log(severity: int, text: str) -> None:
    get_logger("tf2_buffer").log(text, severity)
