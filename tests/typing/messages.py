"""User code without errors for a strict type checker."""

import numpy as np
from geometry_msgs.msg import PoseWithCovariance, TransformStamped, Twist
from rosidl_runtime_py import message_to_yaml, set_message_fields
from sensor_msgs.msg import Image, JointState, PointField
from turtlesim.action import RotateAbsolute
from turtlesim.srv import Spawn

twist = Twist()
twist.linear.x = 2.0
twist.linear.y = 1
joints = JointState(name=["a"], position=[1.0, 2.0], check_fields=True)
joints.position = np.zeros(3)
joints.position.append(1.0)
image = Image(data=b"abc")
image.data = [1, 2]
names: list[str] = joints.name
pose = PoseWithCovariance(covariance=[0.0] * 36)
pose.covariance = [1.0] * 36
first: float = pose.covariance[0]
kind: int = PointField.FLOAT32
request = Spawn.Request(x=1.0, name="bob")
goal = RotateAbsolute.Goal(theta=1.0)
theta: float = goal.theta
text: str = message_to_yaml(twist)
set_message_fields(twist, {"linear": {"x": 1.0}})
stamp: int = TransformStamped().header.stamp.sec
