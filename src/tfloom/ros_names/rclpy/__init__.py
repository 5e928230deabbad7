"""The ROS 2 client library for Python, implemented by tfloom."""

from tfloom.node.client_library import *
from tfloom.node.client_library import __all__
from tfloom.ros_modules import rclpy_module as __getattr__
