"""A robot_state_publisher as a user would write it with ROS's names: from message objects to message objects.

It has the robot as a table of origins and axes, and does nothing else that the program does.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import JointState
from tf2_ros import TransformBroadcaster

from tfloom.robot.description import Joint
from tfloom.robot.urdf import parse_urdf


class ByMessages(Node):
    def __init__(self, urdf: str) -> None:
        super().__init__("by_messages")
        self.joints = parse_urdf(urdf).joints
        self.broadcaster = TransformBroadcaster(self)
        self.create_subscription(JointState, "joint_states", self.on_states, qos_profile_sensor_data)

    def on_states(self, state: JointState) -> None:
        pairs = zip(state.name, state.position, strict=True)
        stamp = state.header.stamp
        transforms = [self.transform(self.joints[name], position, stamp) for name, position in pairs]
        self.broadcaster.sendTransform(transforms)

    def transform(self, joint: Joint, position: float, stamp: object) -> TransformStamped:
        message = TransformStamped()
        message.header.stamp = stamp
        message.header.frame_id, message.child_frame_id = joint.parent, joint.child
        at, turn = message.transform.translation, message.transform.rotation
        at.x, at.y, at.z = joint.origin.translation
        x, y, z, w = joint.origin.rotation_xyzw
        s, c = math.sin(position / 2), math.cos(position / 2)
        a, b, d = (s * number for number in joint.axis)
        turn.x = w * a + x * c + y * d - z * b
        turn.y = w * b - x * d + y * c + z * a
        turn.z = w * d + x * b - y * a + z * c
        turn.w = w * c - x * a - y * b - z * d
        return message


if __name__ == "__main__":
    rclpy.init()
    rclpy.spin(ByMessages(Path(sys.argv[1]).read_text()))
