"""The modules that expose the tags and substitutions of tfloom, which are imported when a launch file uses them.

Importing all of them at once would take longer than most launch files take to load. Those of other packages are found
by the entry points `launch.frontend.launch_extension`.
"""

from __future__ import annotations

__all__ = ["ACTION_MODULES", "SUBSTITUTION_MODULES"]

_ACTIONS = "tfloom.launch.actions."
_ROS_ACTIONS = "tfloom.launch.ros.actions."
_SUBSTITUTIONS = "tfloom.launch.substitutions."
_ROS_SUBSTITUTIONS = "tfloom.launch.ros.substitutions"

ACTION_MODULES: dict[str, str] = {
    "append_env": _ACTIONS + "environment",
    "arg": _ACTIONS + "declare_launch_argument",
    "bool_arg": _ACTIONS + "declare_launch_argument",
    "executable": _ACTIONS + "execute_process",
    "for": _ACTIONS + "for_loop",
    "for_each": _ACTIONS + "for_loop",
    "group": _ACTIONS + "group_action",
    "include": _ACTIONS + "include_launch_description",
    "let": _ACTIONS + "launch_configurations",
    "lifecycle_node": _ROS_ACTIONS + "lifecycle_node",
    "load_composable_node": _ROS_ACTIONS + "composable_nodes",
    "log": _ACTIONS + "log",
    "log_debug": _ACTIONS + "log",
    "log_error": _ACTIONS + "log",
    "log_info": _ACTIONS + "log",
    "log_warning": _ACTIONS + "log",
    "node": _ROS_ACTIONS + "node",
    "node_container": _ROS_ACTIONS + "composable_nodes",
    "push-ros-namespace": _ROS_ACTIONS + "node_defaults",
    "push_ros_namespace": _ROS_ACTIONS + "node_defaults",
    "rep_env": _ACTIONS + "environment",
    "reset": _ACTIONS + "launch_configurations",
    "reset_env": _ACTIONS + "environment",
    "ros_timer": _ROS_ACTIONS + "ros_timer",
    "set_env": _ACTIONS + "environment",
    "set_parameter": _ROS_ACTIONS + "node_defaults",
    "set_parameters_from_file": _ROS_ACTIONS + "node_defaults",
    "set_remap": _ROS_ACTIONS + "node_defaults",
    "set_ros_log_dir": _ROS_ACTIONS + "node_defaults",
    "set_use_sim_time": _ROS_ACTIONS + "node_defaults",
    "shutdown": _ACTIONS + "event_actions",
    "timer": _ACTIONS + "timer_action",
    "unset_env": _ACTIONS + "environment",
}
"""Module of each tag."""

SUBSTITUTION_MODULES: dict[str, str] = {
    "all": _SUBSTITUTIONS + "comparisons",
    "and": _SUBSTITUTIONS + "comparisons",
    "anon": _SUBSTITUTIONS + "anon_name",
    "any": _SUBSTITUTIONS + "comparisons",
    "command": _SUBSTITUTIONS + "command",
    "dirname": _SUBSTITUTIONS + "launch_files",
    "env": _SUBSTITUTIONS + "variables",
    "equals": _SUBSTITUTIONS + "comparisons",
    "eval": _SUBSTITUTIONS + "python_expression",
    "exec-in-package": _ROS_SUBSTITUTIONS,
    "exec-in-pkg": _ROS_SUBSTITUTIONS,
    "file-content": _SUBSTITUTIONS + "file_content",
    "filename": _SUBSTITUTIONS + "launch_files",
    "find-exec": _SUBSTITUTIONS + "find_executable",
    "find-pkg-prefix": _ROS_SUBSTITUTIONS,
    "find-pkg-share": _ROS_SUBSTITUTIONS,
    "for-var": _SUBSTITUTIONS + "variables",
    "if": _SUBSTITUTIONS + "comparisons",
    "index": _SUBSTITUTIONS + "variables",
    "launch_log_dir": _SUBSTITUTIONS + "launch_files",
    "log_dir": _SUBSTITUTIONS + "launch_files",
    "not": _SUBSTITUTIONS + "comparisons",
    "not-equals": _SUBSTITUTIONS + "comparisons",
    "or": _SUBSTITUTIONS + "comparisons",
    "param": _ROS_SUBSTITUTIONS,
    "path-join": _SUBSTITUTIONS + "joins",
    "string-join": _SUBSTITUTIONS + "joins",
    "var": _SUBSTITUTIONS + "variables",
}
"""Module of each name that follows `$(`."""
