"""Publish the frames of a robot of this folder, and print where its tool is.

    ros2 launch examples/robot/display.launch.py robot:=wheeled
    ros2 run tf2_tools view_frames

Its joints move back and forth; `delta:=0.0` keeps them still.
"""

from __future__ import annotations

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import (
    Command,
    EqualsSubstitution,
    IfElseSubstitution,
    LaunchConfiguration,
    PathJoinSubstitution,
    ThisLaunchFileDir,
)
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description() -> LaunchDescription:
    robot = LaunchConfiguration("robot")
    path = PathJoinSubstitution([ThisLaunchFileDir(), robot])
    description = ParameterValue(Command(["xacro '", path, ".urdf.xacro'"]), value_type=str)
    is_arm = EqualsSubstitution(robot, "arm")
    return LaunchDescription(
        [
            DeclareLaunchArgument("robot", default_value="arm", choices=["arm", "wheeled"]),
            DeclareLaunchArgument(
                "delta", default_value="0.02", description="a joint's step, ten times a second"
            ),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": description}],
            ),
            Node(
                package="joint_state_publisher",
                executable="joint_state_publisher",
                parameters=[{"delta": ParameterValue(LaunchConfiguration("delta"), value_type=float)}],
            ),
            Node(
                package="tf2_ros",
                executable="tf2_echo",
                arguments=[
                    IfElseSubstitution(is_arm, "base_link", "base_footprint"),
                    IfElseSubstitution(is_arm, "tool", "camera_optical"),
                ],
                output="screen",
            ),
        ]
    )
