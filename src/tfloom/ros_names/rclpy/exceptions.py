"""What rclpy raises."""

from tfloom.node.exceptions import *
from tfloom.node.exceptions import __all__
