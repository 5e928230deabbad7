"""What may yet change in rclpy."""

from tfloom.node.experimental import *
from tfloom.node.experimental import __all__
