"""What programs import of the compiled half of rclpy."""

from tfloom.node.implementation import *
from tfloom.node.implementation import __all__
