"""Matchers of actions of nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.events.matchers import matches_node_name as matches_node_name
