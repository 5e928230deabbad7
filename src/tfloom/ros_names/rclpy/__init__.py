"""The client library of ROS 2, on tfloom."""

from tfloom.node.client_library import *
from tfloom.node.client_library import __all__
from tfloom.ros_modules import rclpy_module as __getattr__
