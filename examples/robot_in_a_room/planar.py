"""Compose poses in the plane, and convert them from and to messages: x [m], y [m], yaw [rad]."""

from __future__ import annotations

import math
from typing import NamedTuple

from builtin_interfaces.msg import Time
from geometry_msgs.msg import Pose, Quaternion, Transform, TransformStamped


class Pose2D(NamedTuple):
    """A pose in a frame, and the transform that it is: `map_from_base = map_from_odom @ odom_from_base`."""

    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0

    def __matmul__(self, other: Pose2D) -> Pose2D:
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        x = self.x + cos * other.x - sin * other.y
        y = self.y + sin * other.x + cos * other.y
        return Pose2D(x, y, turned(self.yaw + other.yaw))

    def inverse(self) -> Pose2D:
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        return Pose2D(-cos * self.x - sin * self.y, sin * self.x - cos * self.y, -self.yaw)


def turned(angle: float) -> float:
    """Return an angle between -pi and pi [rad]."""
    return math.remainder(angle, math.tau)


def quaternion(yaw: float) -> Quaternion:
    return Quaternion(z=math.sin(yaw / 2), w=math.cos(yaw / 2))


def yaw_of(rotation: Quaternion) -> float:
    """Return the heading of an orientation: the angle of its x axis in the plane [rad]."""
    return math.atan2(
        2.0 * (rotation.w * rotation.z + rotation.x * rotation.y),
        1.0 - 2.0 * (rotation.y * rotation.y + rotation.z * rotation.z),
    )


def of_transform(transform: Transform) -> Pose2D:
    return Pose2D(transform.translation.x, transform.translation.y, yaw_of(transform.rotation))


def of_pose(pose: Pose) -> Pose2D:
    return Pose2D(pose.position.x, pose.position.y, yaw_of(pose.orientation))


def fill_pose(message: Pose, pose: Pose2D) -> None:
    message.position.x, message.position.y = pose.x, pose.y
    message.orientation = quaternion(pose.yaw)


def transform_message(frame_id: str, child_frame_id: str, stamp: Time, pose: Pose2D) -> TransformStamped:
    message = TransformStamped(child_frame_id=child_frame_id)
    message.header.frame_id, message.header.stamp = frame_id, stamp
    message.transform.translation.x, message.transform.translation.y = pose.x, pose.y
    message.transform.rotation = quaternion(pose.yaw)
    return message
