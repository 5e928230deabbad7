"""The names of the nodes that a launch has started."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.utilities.track_node_names import add_node_name as add_node_name
from tfloom.launch.ros.utilities.track_node_names import get_node_name_count as get_node_name_count
