"""Start turtlesim, the driver of turtle1, and ten wagons, each with a node that steers it."""

from itertools import pairwise

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

WAGONS = 10


def generate_launch_description():
    """Return the nodes of the train."""
    config = PathJoinSubstitution([FindPackageShare('train_bringup'), 'config', 'train.yaml'])
    turtles = ['turtle1', *(f'wagon{number}' for number in range(1, WAGONS + 1))]
    followers = [
        Node(package='turtle_train', executable='follower', name=f'{wagon}_follower',
             parameters=[config, {'wagon': wagon, 'before': before}])
        for before, wagon in pairwise(turtles)
    ]
    return LaunchDescription([
        DeclareLaunchArgument(
            'gap', default_value='0.4', description='Distance between two turtles [m].'),
        DeclareLaunchArgument(
            'speed', default_value='0.8', description='Speed of the first turtle [m/s].'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(package='turtle_train', executable='frames', name='frames'),
        Node(package='turtle_train', executable='driver', name='driver', output='screen',
             parameters=[config, {'speed': LaunchConfiguration('speed')}]),
        Node(package='turtle_train', executable='train', name='train', output='screen',
             parameters=[config, {'gap': LaunchConfiguration('gap'), 'steers': False}]),
        *followers,
    ])
