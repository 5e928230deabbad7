"""Start the robot in its room, the node that maps it, and a tour.

    ros2 launch examples/robot_in_a_room/room.launch.py
    ros2 launch examples/robot_in_a_room/room.launch.py tour:=false

A second robot on the same domain gets a name, which stands before its topics and frames: `name:=second`.
"""

from __future__ import annotations

import sys
from pathlib import Path

from launch import Condition, LaunchContext, LaunchDescription, LaunchDescriptionEntity
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

FOLDER = Path(__file__).parent


def nodes(context: LaunchContext) -> list[LaunchDescriptionEntity]:
    name = LaunchConfiguration("name").perform(context)
    speed = ParameterValue(LaunchConfiguration("speed"), value_type=float)
    parameters = {
        "frame_prefix": f"{name}/" if name else "",
        "use_sim_time": LaunchConfiguration("use_sim_time").perform(context) == "true",
    }

    def program(file: str, condition: Condition | None = None, **values: ParameterValue) -> Node:
        # A file, not the program of a package: Python runs it.
        return Node(
            executable=sys.executable,
            exec_name=file.partition(".")[0],
            arguments=["-u", str(FOLDER / file)],
            namespace=name,
            parameters=[{**parameters, **values}],
            condition=condition,
            output="screen",
        )

    return [
        program("robot.py"),
        program("mapper.py"),
        program("pose_errors.py"),
        program("tour.py", IfCondition(LaunchConfiguration("tour")), speed=speed),
        Node(
            package="robot_state_publisher",
            executable="robot_state_publisher",
            namespace=name,
            parameters=[parameters, {"robot_description": (FOLDER / "robot.urdf").read_text("utf-8")}],
        ),
    ]


def generate_launch_description() -> LaunchDescription:
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                "name", default_value="", description="of a second robot, as its namespace"
            ),
            DeclareLaunchArgument("tour", default_value="true", choices=["true", "false"]),
            DeclareLaunchArgument("speed", default_value="0.5", description="of the tour [m/s]"),
            DeclareLaunchArgument("use_sim_time", default_value="false", choices=["true", "false"]),
            OpaqueFunction(function=nodes),
        ]
    )
