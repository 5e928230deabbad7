"""The action that takes lifecycle nodes through several transitions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.actions.lifecycle_transition import LifecycleTransition as LifecycleTransition
from tfloom.launch.ros.actions.lifecycle_transition import match_node_name_goal as match_node_name_goal
from tfloom.launch.ros.actions.lifecycle_transition import match_node_name_start_goal as match_node_name_start_goal
