"""The node of a launch, by which its actions call services, subscribe and time; it is created on first use."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.ros_adapters import ROSAdapter as ROSAdapter
from tfloom.launch.ros.ros_adapters import get_ros_adapter as get_ros_adapter
from tfloom.launch.ros.ros_adapters import get_ros_node as get_ros_node
