"""Names of rclpy's compiled module that programs import: errors, and entities for wait sets."""

from tfloom.node.implementation import *
from tfloom.node.implementation import __all__
