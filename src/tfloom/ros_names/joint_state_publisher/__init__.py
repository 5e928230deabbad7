"""The states of a robot's joints, without hardware."""

from tfloom.ros_guard import claim

claim("joint_state_publisher")
