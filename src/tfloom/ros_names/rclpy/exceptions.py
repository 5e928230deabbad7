"""What rclpy raises."""

from tfloom.node.values.exceptions import *
from tfloom.node.values.exceptions import __all__
