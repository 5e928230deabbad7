"""The modules that expose the tags and substitutions of tfloom, which are imported when a launch file uses them.

Importing all of them at once would take longer than most launch files take to load. Those of other packages are found
by the entry points `launch.frontend.launch_extension`.
"""

from __future__ import annotations

__all__ = ["ACTION_MODULES", "SUBSTITUTION_MODULES"]

_ACTIONS = "tfloom.launch.actions."
_ROS_ACTIONS = "tfloom.launch.ros.actions."
_SUBSTITUTIONS = "tfloom.launch.substitutions."
_ROS_SUBSTITUTIONS = "tfloom.launch.ros.substitutions."

ACTION_MODULES: dict[str, str] = {
    "append_env": _ACTIONS + "append_environment_variable",
    "arg": _ACTIONS + "declare_launch_argument",
    "executable": _ACTIONS + "execute_process",
    "for": _ACTIONS + "for_loop",
    "for_each": _ACTIONS + "for_loop",
    "group": _ACTIONS + "group_action",
    "include": _ACTIONS + "include_launch_description",
    "let": _ACTIONS + "set_launch_configuration",
    "lifecycle_node": _ROS_ACTIONS + "lifecycle_node",
    "load_composable_node": _ROS_ACTIONS + "load_composable_nodes",
    "log": _ACTIONS + "log",
    "log_debug": _ACTIONS + "log",
    "log_error": _ACTIONS + "log",
    "log_info": _ACTIONS + "log",
    "log_warning": _ACTIONS + "log",
    "node": _ROS_ACTIONS + "node",
    "node_container": _ROS_ACTIONS + "composable_node_container",
    "push-ros-namespace": _ROS_ACTIONS + "push_ros_namespace",
    "push_ros_namespace": _ROS_ACTIONS + "push_ros_namespace",
    "reset": _ACTIONS + "reset_launch_configurations",
    "reset_env": _ACTIONS + "reset_environment",
    "ros_timer": _ROS_ACTIONS + "ros_timer",
    "set_env": _ACTIONS + "set_environment_variable",
    "set_parameter": _ROS_ACTIONS + "set_parameter",
    "set_parameters_from_file": _ROS_ACTIONS + "set_parameters_from_file",
    "set_remap": _ROS_ACTIONS + "set_remap",
    "set_ros_log_dir": _ROS_ACTIONS + "set_ros_log_dir",
    "set_use_sim_time": _ROS_ACTIONS + "set_use_sim_time",
    "shutdown": _ACTIONS + "shutdown_action",
    "timer": _ACTIONS + "timer_action",
    "unset_env": _ACTIONS + "unset_environment_variable",
}
"""Module of each tag."""

SUBSTITUTION_MODULES: dict[str, str] = {
    "all": _SUBSTITUTIONS + "boolean_substitution",
    "and": _SUBSTITUTIONS + "boolean_substitution",
    "anon": _SUBSTITUTIONS + "anon_name",
    "any": _SUBSTITUTIONS + "boolean_substitution",
    "command": _SUBSTITUTIONS + "command",
    "dirname": _SUBSTITUTIONS + "this_launch_file_dir",
    "env": _SUBSTITUTIONS + "environment_variable",
    "equals": _SUBSTITUTIONS + "equals_substitution",
    "eval": _SUBSTITUTIONS + "python_expression",
    "exec-in-package": _ROS_SUBSTITUTIONS + "executable_in_package",
    "exec-in-pkg": _ROS_SUBSTITUTIONS + "executable_in_package",
    "file-content": _SUBSTITUTIONS + "file_content",
    "filename": _SUBSTITUTIONS + "this_launch_file",
    "find-exec": _SUBSTITUTIONS + "find_executable",
    "find-pkg-prefix": _ROS_SUBSTITUTIONS + "find_package",
    "find-pkg-share": _ROS_SUBSTITUTIONS + "find_package",
    "for-var": _SUBSTITUTIONS + "for_loop_var",
    "if": _SUBSTITUTIONS + "if_else_substitution",
    "index": _SUBSTITUTIONS + "for_loop_var",
    "launch_log_dir": _SUBSTITUTIONS + "launch_log_dir",
    "log_dir": _SUBSTITUTIONS + "launch_log_dir",
    "not": _SUBSTITUTIONS + "boolean_substitution",
    "not-equals": _SUBSTITUTIONS + "not_equals_substitution",
    "or": _SUBSTITUTIONS + "boolean_substitution",
    "param": _ROS_SUBSTITUTIONS + "parameter",
    "path-join": _SUBSTITUTIONS + "path_join_substitution",
    "string-join": _SUBSTITUTIONS + "string_join_substitution",
    "var": _SUBSTITUTIONS + "launch_configuration",
}
"""Module of each name that follows `$(`."""
