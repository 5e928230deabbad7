"""Start the talker and the listener of demo_nodes_cpp."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description() -> LaunchDescription:
    """Return both programs."""
    return LaunchDescription(
        [
            Node(package="demo_nodes_cpp", executable="talker", output="screen"),
            Node(package="demo_nodes_cpp", executable="listener", output="screen"),
        ]
    )
