"""The name under which programs import rclpy's compiled module."""

from tfloom.node.implementation_singleton import *
from tfloom.node.implementation_singleton import __all__
