"""The compiled half of rclpy, as programs import it."""

from tfloom.node.implementation_singleton import *
from tfloom.node.implementation_singleton import __all__
