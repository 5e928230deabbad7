"""Matchers of actions of nodes."""

import launch_ros.events.matchers.matches_node_name
from tfloom.launch.ros.events.matchers import matches_node_name as matches_node_name
