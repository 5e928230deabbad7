"""The matcher of lifecycle nodes, by its former place."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.events.lifecycle.lifecycle_node_matchers import matches_node_name as matches_node_name
