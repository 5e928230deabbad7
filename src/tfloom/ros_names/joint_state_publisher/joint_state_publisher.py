"""The node that publishes the states of a robot's joints."""

from tfloom.robot.joint_state_publisher import JointStatePublisher, main

__all__ = ["JointStatePublisher", "main"]
