"""Start turtlesim, broadcasters of turtle1 and turtle3, and the publisher of turtle3's position as points."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def generate_launch_description() -> LaunchDescription:
    """Return turtlesim, the broadcasters and the publisher."""
    package = "turtle_tf2_py"
    return LaunchDescription(
        [
            DeclareLaunchArgument("target_frame", default_value="turtle1", description="Target frame name."),
            Node(package="turtlesim", executable="turtlesim_node", name="sim", output="screen"),
            Node(
                package=package,
                executable="turtle_tf2_broadcaster",
                name="broadcaster1",
                parameters=[{"turtlename": "turtle1"}],
            ),
            Node(
                package=package,
                executable="turtle_tf2_broadcaster",
                name="broadcaster2",
                parameters=[{"turtlename": "turtle3"}],
            ),
            Node(package=package, executable="turtle_tf2_message_broadcaster", name="message_broadcaster"),
        ]
    )
