"""Packages and their programs: the ament index over AMENT_PREFIX_PATH, then tfloom's own programs.

A prefix is a folder into which colcon installs. Under it, `share/ament_index/resource_index/<type>/<name>` is a
marker file (type `packages`: the package is installed), `share/<name>` has the package's files and `lib/<name>` its
programs.
"""

from __future__ import annotations

import os
from pathlib import Path

OWN_PREFIX = Path(__file__).parents[1]
"""The prefix of tfloom's own packages, except those of the companion distributions."""
PREFIX_PATH_VARIABLE = "AMENT_PREFIX_PATH"
RESOURCE_INDEX = "share/ament_index/resource_index"
LEFT_OUT = "tfloom_left_out"
"""The type of the resource about a package's C++ that a build has left out: the reason, and a line for each program."""

PROGRAMS: dict[str, dict[str, str]] = {
    "demo_nodes_cpp": {
        "add_two_ints_client": "tfloom.demos.demo_nodes_cpp:add_two_ints_client_main",
        "add_two_ints_client_async": "tfloom.demos.demo_nodes_cpp:add_two_ints_client_async_main",
        "add_two_ints_server": "tfloom.demos.demo_nodes_py.services:add_two_ints_server_main",
        "listener": "tfloom.demos.demo_nodes_py.topics:listener_main",
        "parameter_blackboard": "tfloom.demos.demo_nodes_py.parameters:parameter_blackboard_main",
        "talker": "tfloom.demos.demo_nodes_cpp:talker_main",
    },
    "demo_nodes_py": {
        "add_two_ints_client": "tfloom.demos.demo_nodes_py.services:add_two_ints_client_main",
        "add_two_ints_client_async": "tfloom.demos.demo_nodes_py.services:add_two_ints_client_async_main",
        "add_two_ints_server": "tfloom.demos.demo_nodes_py.services:add_two_ints_server_main",
        "async_param_client": "tfloom.demos.demo_nodes_py.parameters:async_param_client_main",
        "introspection": "tfloom.demos.demo_nodes_py.introspection:main",
        "listener": "tfloom.demos.demo_nodes_py.topics:listener_main",
        "listener_qos": "tfloom.demos.demo_nodes_py.topics:listener_qos_main",
        "listener_serialized": "tfloom.demos.demo_nodes_py.topics:listener_serialized_main",
        "matched_event_detect": "tfloom.demos.demo_nodes_py.matched_event_detect:main",
        "parameter_blackboard": "tfloom.demos.demo_nodes_py.parameters:parameter_blackboard_main",
        "set_parameters_callback": "tfloom.demos.demo_nodes_py.parameters:set_parameters_callback_main",
        "talker": "tfloom.demos.demo_nodes_py.topics:talker_main",
        "talker_qos": "tfloom.demos.demo_nodes_py.topics:talker_qos_main",
        "use_logger_service": "tfloom.demos.demo_nodes_py.use_logger_service:main",
    },
    "foxglove_bridge": {
        "foxglove_bridge": "tfloom.foxglove.program:main",
    },
    "joint_state_publisher": {
        "joint_state_publisher": "tfloom.robot.joint_state_publisher:main",
    },
    "joint_state_publisher_gui": {
        "joint_state_publisher_gui": "tfloom.cli.page_programs:run_joint_state_publisher_gui",
    },
    "rmw_zenoh_cpp": {
        "rmw_zenohd": "tfloom.cli.zenoh:run_daemon",
    },
    "robot_state_publisher": {
        "robot_state_publisher": "tfloom.robot.robot_state_publisher:main",
    },
    "rqt_console": {
        "rqt_console": "tfloom.cli.rqt:run_console",
    },
    "rqt_graph": {
        "rqt_graph": "tfloom.cli.rqt:run_graph",
    },
    "rqt_plot": {
        "rqt_plot": "tfloom.cli.rqt:run_plot",
    },
    "rviz2": {
        "rviz2": "tfloom.cli.page_programs:run_rviz2",
    },
    "tf2_ros": {
        "buffer_server": "tfloom.tf2_tools.buffer_server:main",
        "static_transform_publisher": "tfloom.tf2_tools.static_publisher:main",
        "tf2_echo": "tfloom.tf2_tools.echo:main",
        "tf2_monitor": "tfloom.tf2_tools.monitor:main",
    },
    "tf2_tools": {
        "view_frames": "tfloom.tf2_tools.view_frames:main",
    },
    "turtle_tf2_py": {
        "dynamic_frame_tf2_broadcaster": "tfloom.demos.turtle_tf2_py.dynamic_frame_tf2_broadcaster:main",
        "fixed_frame_tf2_broadcaster": "tfloom.demos.turtle_tf2_py.fixed_frame_tf2_broadcaster:main",
        "static_turtle_tf2_broadcaster": "tfloom.demos.turtle_tf2_py.static_turtle_tf2_broadcaster:main",
        "turtle_tf2_broadcaster": "tfloom.demos.turtle_tf2_py.turtle_tf2_broadcaster:main",
        "turtle_tf2_listener": "tfloom.demos.turtle_tf2_py.turtle_tf2_listener:main",
        "turtle_tf2_message_broadcaster": "tfloom.demos.turtle_tf2_py.turtle_tf2_message_broadcaster:main",
        "turtle_tf2_time_travel": "tfloom.demos.turtle_tf2_py.turtle_tf2_time_travel:main",
    },
    "turtlesim": {
        "draw_square": "tfloom.turtlesim.draw_square:main",
        "mimic": "tfloom.turtlesim.mimic:main",
        "turtle_teleop_key": "tfloom.turtlesim.teleop_key:main",
        "turtlesim_node": "tfloom.turtlesim.node:main",
    },
    "xacro": {
        "xacro": "tfloom.robot.xacro_program:main",
    },
}
"""tfloom's own programs: `module:function` for each, by package and name. The function takes the arguments."""


_SIMULATOR = (
    "Gazebo is not here: `tfloom demo robot` simulates a robot with a laser in a room, and turtlesim turtles"
)
STAND_INS = {
    "gazebo": _SIMULATOR,
    "gazebo_ros": _SIMULATOR,
    "ros_gz_bridge": _SIMULATOR,
    "ros_gz_sim": _SIMULATOR,
    "rqt": "rqt is not here: `tfloom view` has its graph, log, parameters, plots, images and forms on one page",
    "rqt_gui": "rqt is not here: `tfloom view` has its graph, log, parameters, plots, images and forms on one page",
    "rqt_image_view": "an image in the panel Displays of `tfloom view` stands in for it here",
    "rqt_publisher": "a form for a topic in the panel Send of `tfloom view` stands in for it here",
    "rqt_reconfigure": "the panel Parameters of `tfloom view` stands in for it here",
    "rqt_service_caller": "a form for a service in the panel Send of `tfloom view` stands in for it here",
    "rqt_tf_tree": "the panel Frames of `tfloom view`, and `ros2 run tf2_tools view_frames`, stand in for it here",
}
"""What stands in for common programs with windows of packages that don't exist here, by package, as a sentence."""


NAMED_OTHERWISE = {"python_orocos_kdl_vendor": "PyKDL", "tf2_ros_py": "tf2_ros"}
"""ROS packages of tfloom's that have another name than their Python package, which is told."""


def search_paths() -> list[str]:
    """Return the folders named by AMENT_PREFIX_PATH that exist, in order of precedence."""
    return [
        path
        for path in os.environ.get(PREFIX_PATH_VARIABLE, "").split(os.pathsep)
        if path and Path(path).is_dir()
    ]


def resources(resource_type: str) -> dict[str, str]:
    """Return the prefix of each resource of a type, by the resource's name; the first prefix takes precedence."""
    prefixes: dict[str, str] = {}
    for prefix in search_paths():
        folder = Path(prefix, RESOURCE_INDEX, resource_type)
        if folder.is_dir():
            for entry in sorted(folder.iterdir()):
                if entry.is_file() and not entry.name.startswith("."):
                    prefixes.setdefault(entry.name, prefix)
    return prefixes


def find_resource(resource_type: str, name: str) -> str | None:
    """Return the first prefix that has the resource, or None."""
    if not name or set(name) & set("/\\"):
        return None
    for prefix in search_paths():
        if Path(prefix, RESOURCE_INDEX, resource_type, name).is_file():
            return prefix
    return None


def workspace_packages() -> dict[str, str]:
    """Return the prefix of each package that a workspace has built, by name."""
    return resources("packages")


def find_package(package: str) -> str | None:
    """Return the prefix of a package that a workspace has built, or None."""
    return find_resource("packages", package)


def own_packages() -> dict[str, Path]:
    """Return tfloom's own packages in order of name, each with its prefix: programs, interfaces and Python packages."""
    from tfloom.ros_imports.distributions import installed_prefixes

    prefixes = dict.fromkeys((*PROGRAMS, *NAMED_OTHERWISE), OWN_PREFIX)
    for prefix in (*installed_prefixes(), OWN_PREFIX):
        prefixes |= {path.name: prefix for path in (prefix / "ros_names").glob("[a-z]*") if path.is_dir()}
    return dict(sorted(prefixes.items()))


def share_folder(package: str, prefix: str | None) -> Path:
    """Return the folder of a package's files: under its prefix, or, with None, of one of tfloom's own.

    That of one of tfloom's interface packages holds `msg/*.msg`, as an installed one does; each has a package.xml.
    """
    if prefix is not None:
        return Path(prefix, "share", package)
    from tfloom.rosidl.definition_files import own_folders

    folders = (folder / package for folder in own_folders())
    otherwise = own_packages().get(package, OWN_PREFIX) / "share" / package
    return next((folder for folder in folders if folder.is_dir()), otherwise)


def package_programs(package: str, prefix: str) -> list[Path]:
    """Return the executable files of a package under a prefix, in order of their paths."""
    return [
        Path(folder, name)
        for folder, _, names in sorted(os.walk(Path(prefix, "lib", package)))
        for name in sorted(names)
        if _is_program(Path(folder, name))
    ]


def find_unmarked_program(package: str, prefix: str, program: str) -> Path | None:
    """Return the file of a program among a package's that isn't marked as executable, or None."""
    return next(
        (path for path in sorted(Path(prefix, "lib", package).rglob(program)) if not _is_program(path)), None
    )


def why_left_out(package: str, prefix: str, program: str) -> str:
    """Return a sentence on the C++ that was left out of a package, which the program is part of; empty if it isn't."""
    try:
        text = Path(prefix, RESOURCE_INDEX, LEFT_OUT, package).read_text("utf-8")
    except OSError:
        return ""
    reason, *programs = text.splitlines() or [""]
    if program in programs:
        return f"{program} is a program in C++, which is left out of the build: {reason}, which needs a ROS install"
    return f"{package} has C++ programs that are left out of the build: {reason}, which needs a ROS install"


def replacement(package: str, prefix: str, program: str) -> str | None:
    """Return tfloom's own program in place of a workspace's in C++, as `module:function`; None if there is none."""
    return PROGRAMS.get(package, {}).get(program) if why_left_out(package, prefix, program) else None


def interpreter_with_space(path: Path) -> list[str]:
    """Return the interpreter in a script's first line with its options, if there is a space in its path; else nothing.

    The kernel cuts the line at the space. Setuptools writes such lines, in quotes, for an environment whose path has
    a space, and adds the option -x where it has other letters than ASCII's.
    """
    try:
        with path.open("rb") as script:
            line = os.fsdecode(script.readline(4096))
    except OSError:
        return []
    if not line.startswith("#!"):
        return []
    named = line.removeprefix("#!").strip()
    options = ""
    if named.startswith('"'):
        named, _, options = named[1:].partition('"')
    return [named, *options.split()] if " " in named and Path(named).is_file() else []


def program_name(path: Path) -> str:
    """Return the command for a program's file: its name, on Windows without the extension."""
    return path.stem if os.name == "nt" else path.name


def _is_program(path: Path) -> bool:
    if os.name == "nt":
        return path.suffix.lower() in (*os.environ.get("PATHEXT", ".exe").lower().split(os.pathsep), ".py")
    return path.is_file() and os.access(path, os.X_OK)
