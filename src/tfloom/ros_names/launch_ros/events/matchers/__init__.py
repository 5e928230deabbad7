"""Matchers of actions of nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

import launch_ros.events.matchers.matches_node_name
from tfloom.launch.ros.events.matchers import matches_node_name as matches_node_name

__all__ = [
    "matches_node_name",
]
