"""Start the demonstration, and broadcast carrot1, which moves around turtle1, to follow by target_frame:=carrot1."""

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description() -> LaunchDescription:
    """Return the demonstration and the broadcaster of carrot1."""
    package = "turtle_tf2_py"
    demo = PathJoinSubstitution([FindPackageShare(package), "launch", "turtle_tf2_demo.launch.py"])
    return LaunchDescription(
        [
            IncludeLaunchDescription(PythonLaunchDescriptionSource(demo)),
            Node(package=package, executable="dynamic_frame_tf2_broadcaster", name="dynamic_broadcaster"),
        ]
    )
