"""The node that publishes the states of a robot's joints."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.robot.joint_state_publisher import JointStatePublisher as JointStatePublisher
from tfloom.robot.joint_state_publisher import main as main
