"""What pages publish with a drag on the floor: goal poses, initial poses and points, on topics as RViz names them."""

from __future__ import annotations

import math
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
)
from tfloom.interfaces.std_msgs.msg import Header
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
VARIANCES = {0: 0.25, 7: 0.25, 35: 0.06853891909122467}
"""Of an initial pose: (0.5 m)² along x and y, and (15 degrees)² of the yaw, as RViz publishes them."""
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

    def close(self) -> None:
        """Close the writers. The next use opens them again."""
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
