"""Start the add_two_ints_server and the add_two_ints_client_async of demo_nodes_cpp."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description() -> LaunchDescription:
    """Return both programs."""
    return LaunchDescription(
        [
            Node(package="demo_nodes_cpp", executable="add_two_ints_server", output="screen"),
            Node(package="demo_nodes_cpp", executable="add_two_ints_client_async", output="screen"),
        ]
    )
