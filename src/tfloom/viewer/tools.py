"""What pages publish: goal poses, initial poses, points, and velocities, on topics as RViz names them."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from tfloom.interfaces.geometry_msgs.msg import (
    Point,
    PointStamped,
    Pose,
    PoseStamped,
    PoseWithCovariance,
    PoseWithCovarianceStamped,
    Quaternion,
    Twist,
    TwistStamped,
    Vector3,
)
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.rmw.errors import WireError
from tfloom.rmw.qos import QoS
from tfloom.rmw.typed_names import topic_of
from tfloom.rosidl import cdr
from tfloom.viewer.forms.filling import stamp_of_ns
from tfloom.viewer.page_command import PageError

if TYPE_CHECKING:
    from tfloom.rmw.base import NodeName, Participant, Writer

__all__ = ["GOAL_TOPIC", "INITIAL_TOPIC", "POINT_TOPIC", "Tools"]

GOAL_TOPIC = "/goal_pose"
INITIAL_TOPIC = "/initialpose"
POINT_TOPIC = "/clicked_point"
MIN_DRAG_M = 0.02
"""A shorter arrow on the floor has no direction: the pose looks along x [m]."""
LINEAR_M_S = 2.0
ANGULAR_RAD_S = 2.0
"""The speeds of a stick at its end, as those of turtlesim's keys."""
SILENCE_S = 0.5
"""A robot that is driven is stopped when its page says nothing for this time [s]."""
VARIANCES = {0: 0.25, 7: 0.25, 35: 0.06853891909122467}
"""Of an initial pose: (0.5 m)² along x and y, and (15 degrees)² of the yaw, as RViz publishes them."""
TWIST_TYPES: dict[str, type[Any]] = {
    "geometry_msgs/msg/Twist": Twist,
    "geometry_msgs/msg/TwistStamped": TwistStamped,
}

Spot = tuple[float, float]
"""x and y on the floor [m]."""


class Tools:
    """Publishes what the tools of pages make. One thread may use it.

    Args:
        participant: The participant that writes.
        node: The node whose writers these are, which was added to the participant.
        now_ns: Returns the time of the stamps [ns since epoch].
    """

    def __init__(self, participant: Participant, node: NodeName, now_ns: Callable[[], int]) -> None:
        self._participant = participant
        self._node = node
        self._now_ns = now_ns
        self._writers: dict[tuple[str, type[Any]], Writer] = {}
        self._driven: dict[str, float] = {}
        """When each topic got its last velocity that isn't zero [s, monotonic]."""

    def open(self) -> None:
        """Open the topics of poses and points, so that subscriptions are matched before something is published."""
        self._writer(GOAL_TOPIC, PoseStamped)
        self._writer(INITIAL_TOPIC, PoseWithCovarianceStamped)
        self._writer(POINT_TOPIC, PointStamped)

    def use(self, tool: str, frame: str, start: Spot, end: Spot) -> str:
        """Publish what a drag on the floor means; return what was published, as a sentence.

        Args:
            tool: `goal`, `initial` or `point`.
            frame: The frame of the floor.
            start: Where the drag began.
            end: Where it ended: the direction of the pose.

        Raises:
            PageError: there is no such tool.
        """
        header = Header(frame_id=frame, stamp=stamp_of_ns(self._now_ns()))
        x, y = start
        if tool == "point":
            self._publish(POINT_TOPIC, PointStamped(header=header, point=Point(x=x, y=y)))
            return f"point ({x:.2f}, {y:.2f}) in {frame}, published on {POINT_TOPIC}"
        dx, dy = end[0] - x, end[1] - y
        yaw = math.atan2(dy, dx) if math.hypot(dx, dy) >= MIN_DRAG_M else 0.0
        turn = Quaternion(z=math.sin(yaw / 2.0), w=math.cos(yaw / 2.0))
        pose = Pose(position=Point(x=x, y=y), orientation=turn)
        text = f"({x:.2f}, {y:.2f}), {math.degrees(yaw):.0f}° in {frame}, published on"
        if tool == "goal":
            self._publish(GOAL_TOPIC, PoseStamped(header=header, pose=pose))
            return f"goal {text} {GOAL_TOPIC}"
        if tool == "initial":
            covariance = [VARIANCES.get(number, 0.0) for number in range(36)]
            estimate = PoseWithCovariance(pose=pose, covariance=covariance)
            self._publish(INITIAL_TOPIC, PoseWithCovarianceStamped(header=header, pose=estimate))
            return f"initial pose {text} {INITIAL_TOPIC}"
        raise PageError("there is no such tool")

    def drive_topics(self) -> list[str]:
        """Return the topics of velocities that somebody subscribes to."""
        ends = self._participant.graph.endpoints()
        return sorted(
            {end.topic.name for end in ends if not end.is_writer and end.topic.type_name in TWIST_TYPES}
        )

    def drive(self, topic: str, ahead: float, left: float) -> None:
        """Publish a velocity.

        Args:
            topic: One of `drive_topics`.
            ahead: From -1 to 1, of `LINEAR_M_S`.
            left: From -1 to 1, of `ANGULAR_RAD_S`.

        Raises:
            PageError: nobody subscribes to the topic.
        """
        types = {
            end.topic.type_name
            for end in self._participant.graph.endpoints()
            if not end.is_writer and end.topic.name == topic and end.topic.type_name in TWIST_TYPES
        }
        if not types:
            raise PageError(f"nobody subscribes to velocities on {topic!r}")
        ahead, left = min(max(ahead, -1.0), 1.0), min(max(left, -1.0), 1.0)
        if ahead or left:
            self._driven[topic] = time.monotonic()
        else:
            self._driven.pop(topic, None)
        twist = Twist(linear=Vector3(x=LINEAR_M_S * ahead), angular=Vector3(z=ANGULAR_RAD_S * left))
        if "geometry_msgs/msg/Twist" in types:
            self._publish(topic, twist)
        else:
            self._publish(topic, TwistStamped(header=Header(stamp=stamp_of_ns(self._now_ns())), twist=twist))

    def stop_silent(self, *, all_topics: bool = False) -> None:
        """Stop what is driven and was not told so for `SILENCE_S`; or all."""
        for topic, told_s in list(self._driven.items()):
            if all_topics or time.monotonic() > told_s + SILENCE_S:
                del self._driven[topic]
                try:
                    self.drive(topic, 0.0, 0.0)
                except (PageError, WireError):
                    continue  # the robot is gone, or the wire refuses the writer, which the page was told

    def close(self) -> None:
        """Stop what is driven, and close the writers."""
        self.stop_silent(all_topics=True)
        for writer in self._writers.values():
            writer.close()
        self._writers.clear()

    def _writer(self, topic: str, message_class: type[Any]) -> Writer:
        key = topic, message_class
        if key not in self._writers:
            self._writers[key] = self._participant.create_writer(
                self._node, topic_of(message_class, topic), QoS()
            )
        return self._writers[key]

    def _publish(self, topic: str, message: Any) -> None:
        self._writer(topic, type(message)).write(cdr.encode(message))
