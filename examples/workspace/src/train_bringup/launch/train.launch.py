"""Start turtlesim, the driver, and the train."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Return the nodes of the train."""
    config = str(Path(get_package_share_directory('train_bringup')) / 'config' / 'train.yaml')
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node'),
        Node(package='turtle_train', executable='driver', parameters=[config]),
        Node(package='turtle_train', executable='frames'),
        Node(package='turtle_train', executable='train', parameters=[config]),
    ])
